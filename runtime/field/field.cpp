#include "runtime/field/field.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

/// How a field is read off a drape and labelled.
struct Kind {
  std::string_view name;
  std::string_view unit;
  double to_unit;
  std::vector<double> Drape::*values;
  bool per_vertex;
  bool diverging;
};

constexpr double kDegrees = 180.0 / std::numbers::pi;

constexpr std::array<Kind, 10> kKinds{{
    {"strain.warp", "%", 100, &Drape::strain_warp, false, true},
    {"strain.weft", "%", 100, &Drape::strain_weft, false, true},
    {"strain.shear", "deg", kDegrees, &Drape::shear_angle, false, true},
    {"stress.warp", "N/m", 1, &Drape::stress_warp, false, true},
    {"stress.weft", "N/m", 1, &Drape::stress_weft, false, true},
    {"stress.shear", "N/m", 1, &Drape::stress_shear, false, true},
    {"curvature.warp", "1/m", 1, &Drape::curvature_warp, false, true},
    {"curvature.weft", "1/m", 1, &Drape::curvature_weft, false, true},
    {"curvature.twist", "1/m", 1, &Drape::twist, false, true},
    {"contact.pressure", "Pa", 1, &Drape::pressure, true, false},
}};

/// Area of a triangle in the plane of the cloth.
double area(const ClothTriangle& triangle) {
  return std::abs(cross(triangle.uv[1] - triangle.uv[0], triangle.uv[2] - triangle.uv[0])) / 2;
}

}  // namespace

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  names.reserve(kKinds.size());
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

Field field(std::string_view name, const Cloth& cloth, const Drape& drape) {
  for (const Kind& kind : kKinds) {
    if (kind.name != name) continue;
    Field found{.name = std::string(kind.name),
                .unit = std::string(kind.unit),
                .to_unit = kind.to_unit,
                .per_vertex = kind.per_vertex,
                .values = drape.*kind.values,
                .diverging = kind.diverging};
    // A drape that was cancelled early may have measured nothing yet.
    found.values.resize(kind.per_vertex ? static_cast<std::size_t>(cloth.vertex_count) : cloth.triangles.size(), 0.0);
    for (double& value : found.values) {
      if (!std::isfinite(value)) value = 0;
    }
    return found;
  }
  return {};
}

std::vector<double> at_vertices(const Field& field, const Cloth& cloth) {
  if (field.per_vertex) return field.values;
  const auto count = static_cast<std::size_t>(cloth.vertex_count);
  std::vector<double> sum(count, 0.0);
  std::vector<double> weight(count, 0.0);
  for (std::size_t t = 0; t < cloth.triangles.size() && t < field.values.size(); ++t) {
    const double w = area(cloth.triangles[t]);
    for (const int vertex : cloth.triangles[t].vertices) {
      sum[static_cast<std::size_t>(vertex)] += w * field.values[t];
      weight[static_cast<std::size_t>(vertex)] += w;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (weight[i] > 0) sum[i] /= weight[i];
  }
  return sum;
}

}  // namespace toile
