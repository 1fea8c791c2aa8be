// One script in several sizes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/driver/workroom.hpp"

namespace toile {

/// The options for each time that the script is gone through: where the size is `all`, one for each size of its tables,
/// with the size in the names of files; else the options as they are.
std::vector<WorkroomOptions> one_by_size(const std::filesystem::path& script, const WorkroomOptions& options);

/// `skirt.report.json` -> `skirt-M.report.json`
std::filesystem::path name_for_size(const std::filesystem::path& path, const std::string& size);

}  // namespace toile
