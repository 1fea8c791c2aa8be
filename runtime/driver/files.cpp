#include "runtime/driver/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

namespace toile {
namespace {

std::string reason() {
  return errno != 0 ? std::strerror(errno) : "unknown reason";
}

}  // namespace

std::optional<std::string> read_file(const std::filesystem::path& path, std::string& error) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    error = fmt::format("cannot read {}: it is a folder", path.string());
    return std::nullopt;
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  if (in) bytes.assign(std::istreambuf_iterator<char>(in), {});
  if (!in.is_open() || in.bad()) {
    error = fmt::format("cannot read {}: {}", path.string(), reason());
    return std::nullopt;
  }
  return bytes;
}

bool write_file(const std::filesystem::path& path, std::string_view bytes, std::string& error) {
  std::error_code code;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
  if (code) {
    error = fmt::format("cannot make the folder {}: {}", path.parent_path().string(), code.message());
    return false;
  }
  const std::filesystem::path temporary =
      path.parent_path() / fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    error = fmt::format("cannot write {}: {}", path.string(), reason());
    std::filesystem::remove(temporary, code);
    return false;
  }
  std::filesystem::rename(temporary, path, code);
  if (code) {
    error = fmt::format("cannot write {}: {}", path.string(), code.message());
    std::filesystem::remove(temporary, code);
    return false;
  }
  return true;
}

std::optional<std::filesystem::path> below(const std::filesystem::path& folder, const std::string& path) {
  const std::filesystem::path inside = std::filesystem::path(path).lexically_normal();
  if (inside.empty() || inside.is_absolute() || !inside.has_filename() || inside == "." || *inside.begin() == "..") {
    return std::nullopt;
  }
  return folder / inside;
}

}  // namespace toile
