// A body as the script states it; runtime/body makes the surface.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grammar/source.hpp"

namespace toile {

/// A horizontal section of the torso: a superellipse |x/a|^n + |y/b|^n = 1 scaled so that its perimeter is `girth`.
struct BodySection {
  std::string name;              // "waist", "hip", … or empty for one that only shapes
  double level = 0;              // [m] above the floor
  double girth = 0;              // [m]
  double width_to_depth = 1.35;  // a/b
  double forward = 0;            // [m] shift of the centre towards the front (-y)
  double squareness = 2.2;       // n
  Location written{};
};

/// A limb grows out of the torso; sections are perpendicular to its axis. Given for the left side (+x) and mirrored.
struct BodyLimb {
  enum class Kind { Arm, Leg } kind = Kind::Arm;
  double girth_root = 0, girth_tip = 0;  // [m]
  double length = 0;                     // [m] of the stump
  double angle = 0;                      // [rad] of the axis from straight down, outward
};

struct FormSpec {
  std::vector<BodySection> sections;  // from the crotch up to the neck, levels increasing
  std::vector<BodyLimb> limbs;
};
struct SphereSpec {
  double radius = 0;
  double height = 0;
};  // [m] radius; height of the centre above the floor
struct CylinderSpec {
  double radius = 0;
  double length = 0;
  double height = 0;
  bool upright = true;
};  // height of the centre; lying: axis along x
struct DiscSpec {
  double radius = 0;
  double thickness = 0;
  double height = 0;
};  // height of the top face
struct BoxSpec {
  double width = 0, depth = 0, tall = 0;
  double height = 0;
};  // x, y, z extents; height of the top face
struct PlaneSpec {
  double height = 0;
};
struct MeshSpec {
  std::string path;  // OBJ, metres, z up
  struct Line {
    std::string name;
    double px, py, pz, nx, ny, nz;
  };  // the plane that cuts the line out; the loop nearest the point counts
  std::vector<Line> lines;
};

struct BodySpec {
  std::string name;
  std::variant<FormSpec, SphereSpec, CylinderSpec, DiscSpec, BoxSpec, PlaneSpec, MeshSpec> shape;
  double softness = 1e6;           // [N/m3] pressure per depth of penetration
  std::optional<double> friction;  // coefficient against cloth; the fabric's MIU when absent
  Location written;
};

}  // namespace toile
