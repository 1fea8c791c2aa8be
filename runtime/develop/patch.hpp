// A piece of a body's surface, cut out so that it can be laid in the plane.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "runtime/body/body.hpp"

namespace toile {

/// Has the shape of a disc: connected, with one boundary, every edge in one triangle or two.
struct Patch {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;  // as on the body
  std::vector<int> boundary;                  // points, in turn, the patch on the left
};

/// All triangles that hang together with the one nearest to `centre` and reach nearer to it than `reach` [m]. What is
/// wrong comes back in `error`.
std::optional<Patch> patch_round(const Body::Surface& surface, Vec3 centre, double reach, std::string& error);

/// What of a limb lies beyond a line of the body: as far as `reach` [m] along the line's axis, with the triangles that
/// the line runs through, cut open along the half plane that goes from the axis towards `open`.
std::optional<Patch> patch_of_limb(const Body::Surface& surface, const BodyLine& line, Vec3 middle, Vec3 open,
                                   double reach, std::string& error);

}  // namespace toile
