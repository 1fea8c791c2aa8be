// Fields on a draped cloth by the names the language gives them: "strain.warp", "stress.shear", "contact.pressure", …
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/drape/drape.hpp"

namespace toile {

struct Field {
  std::string name;
  std::string unit;            // "%", "N/m", "Pa", "deg", "1/m": the unit in which a scale is labelled
  double to_unit = 1;          // SI value times this
  bool per_vertex = false;     // else per triangle
  std::vector<double> values;  // SI
  bool diverging = false;      // shown about zero
};

std::vector<std::string> field_names();
/// Null name or unknown: nullopt-like empty `name`.
Field field(std::string_view name, const Cloth& cloth, const Drape& drape);

/// The same, one value a vertex (area-weighted mean of the triangles about it).
std::vector<double> at_vertices(const Field& field, const Cloth& cloth);

}  // namespace toile
