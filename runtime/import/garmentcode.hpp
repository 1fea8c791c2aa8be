// Pattern specifications of GarmentCode (JSON).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/import/foreign_pattern.hpp"

namespace toile {

/// The pattern, or nullopt with the reason in `error`, which names the panel and the edge. Lengths are finite and below
/// 100 m, outlines closed, edges no points, and stitches name edges that exist.
std::optional<ForeignPattern> read_garmentcode(std::string_view json, std::string& error);

}  // namespace toile
