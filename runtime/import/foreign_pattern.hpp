// A pattern made by another program, as its file tells it, before it becomes text of the language.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compiler/curve/curve.hpp"

namespace toile {

struct ForeignEdge {
  std::string label;  // may be empty, need not be a name, and several edges may have the same
  Vec2 from, to;      // [m]
  Curve curve;        // one segment
};

/// Where the source puts a panel before it is sewn, in its own frame.
struct ForeignPlacement {
  std::array<double, 3> translation{};  // [cm]
  std::array<double, 3> rotation{};     // [deg]
};

struct ForeignPanel {
  std::string name;
  std::string part;                // of the body, "leg"; may be empty
  std::vector<ForeignEdge> edges;  // one closed line; its right side is seen where it runs counter-clockwise
  std::optional<ForeignPlacement> placement;
};

struct ForeignEnd {
  std::size_t panel = 0;
  std::size_t edge = 0;
};

/// Two edges joined with their directions opposed, as cloth is that lies right side on right side, or, `to_wrong_side`,
/// start to start.
struct ForeignStitch {
  ForeignEnd first, second;
  bool to_wrong_side = false;
};

struct ForeignPattern {
  std::vector<ForeignPanel> panels;
  std::vector<ForeignStitch> stitches;
};

}  // namespace toile
