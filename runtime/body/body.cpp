#include "runtime/body/body.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "runtime/body/form.hpp"
#include "runtime/body/manifold.hpp"
#include "runtime/body/mesh_body.hpp"
#include "runtime/body/plane_cut.hpp"
#include "runtime/body/primitives.hpp"
#include "runtime/body/wavefront.hpp"

namespace toile {
namespace {

LinedSurface failed(std::string error) {
  return {{}, {}, std::move(error)};
}

LinedSurface import(const MeshSpec& mesh) {
  std::ifstream file(mesh.path, std::ios::binary);
  if (!file) return failed(fmt::format("{}: cannot be read", mesh.path));
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return failed(fmt::format("{}: cannot be read", mesh.path));
  LinedSurface result;
  std::string fault;
  if (!read_obj(text, &result.surface, &fault)) return failed(fmt::format("{}: {}", mesh.path, fault));
  if (fault = manifold_fault(result.surface); !fault.empty()) return failed(fmt::format("{}: {}", mesh.path, fault));
  face_outwards(result.surface);
  for (const MeshSpec::Line& line : mesh.lines) {
    const double length = norm(Vec3{line.nx, line.ny, line.nz});
    if (!(length > 0 && std::isfinite(length) && std::isfinite(line.px + line.py + line.pz))) {
      return failed(fmt::format("line {}: its plane needs a point and a direction", line.name));
    }
    std::optional<BodyLine> cut = cut_line(result.surface, line);
    if (!cut) return failed(fmt::format("line {}: its plane misses {}", line.name, mesh.path));
    result.lines.push_back(std::move(*cut));
  }
  return result;
}

}  // namespace

std::shared_ptr<const Body> Body::make(const BodySpec& spec, std::string* error) {
  std::string ignored;
  if (error == nullptr) error = &ignored;
  error->clear();
  const auto* form = std::get_if<FormSpec>(&spec.shape);
  const auto* mesh = std::get_if<MeshSpec>(&spec.shape);
  if (form == nullptr && mesh == nullptr) return make_primitive(spec, error);
  LinedSurface lined = form != nullptr ? make_form(*form) : import(*mesh);
  if (!lined.error.empty()) {
    *error = std::move(lined.error);
    return nullptr;
  }
  return make_mesh_body(spec, std::move(lined));
}

std::optional<Clearance> Body::clearance(Vec3 p, double reach) const {
  const std::optional<SurfacePoint> surface = nearest(p, reach);
  if (!surface) return std::nullopt;
  return Clearance{surface->distance, surface->normal, {}};
}

const BodyLine* Body::line(std::string_view name) const {
  for (const BodyLine& candidate : lines()) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

}  // namespace toile
