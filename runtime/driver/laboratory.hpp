// `toile kes`: a cloth on the virtual KES instruments.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/driver/workroom.hpp"
#include "runtime/export/plot.hpp"
#include "runtime/laboratory/kes.hpp"

namespace toile {

/// Prints the sheet that is read back beside the one that went in and draws the curves. `fabric` is an expression of
/// the loaded script. What went wrong is said to the workroom's listener.
void test_fabric(Workroom& workroom, const std::string& fabric, const std::filesystem::path& drawing);

/// Its curves in the units of the instruments.
std::vector<PlotPanel> drawn(const KesReading& reading);

}  // namespace toile
