// Reading and writing whole files. Nobody ever sees half a file: bytes go to a temporary name first.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// The file's bytes, or nullopt with the reason in words in `error`.
std::optional<std::string> read_file(const std::filesystem::path& path, std::string& error);

/// Makes the folders that are missing, writes to a temporary name beside `path` and renames. False with the reason in
/// `error`; the temporary file is then gone and a file that stood there before is untouched.
bool write_file(const std::filesystem::path& path, std::string_view bytes, std::string& error);

/// `path` as seen from `folder`, or nullopt when it would leave the folder: a script writes nowhere else.
std::optional<std::filesystem::path> below(const std::filesystem::path& folder, const std::string& path);

}  // namespace toile
