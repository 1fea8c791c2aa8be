// Golden tests: scripts compared with what they were last accepted to say.
//
// NAME.toile has its golden files beside it. NAME.out holds its diagnostics and a line about each garment, as `toile
// check` gives them. Lines of the script that start with "//!" ask for more:
//   //! emit pattern pmesh smesh   those stages too, in NAME.pattern, NAME.pmesh, NAME.smesh
//   //! triangles 60               about so many triangles a garment
//   //! set flare=20cm             a parameter, as --set does
//   //! run                        NAME.out is what running its commands says
#pragma once

#include <filesystem>

#include "runtime/driver/listener.hpp"
#include "runtime/driver/outcome.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

/// Tests the script, or all scripts below the folder, in the order of their names. Differences, and the closing line
/// "N passed, N failed", are printed. With `update` what was found becomes the golden files.
Outcome test_scripts(const std::filesystem::path& path, bool update, Listener& listener, const Job& job);

}  // namespace toile
