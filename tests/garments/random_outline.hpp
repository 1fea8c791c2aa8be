// Outlines drawn at random: star-shaped, some edges arcs.
#pragma once

#include <string>
#include <vector>

#include "tests/garments/dice.hpp"

namespace toile::test {

/// A length in metres as the language writes it.
std::string cm(double metres);

struct OutlineEdge {
  double x = 0, y = 0;  // [m] where it begins
  double bulge = 0;     // [m] height of the arc beyond its chord; 0 for a straight edge
};

/// Edges are called e0, e1, …
class Outline {
 public:
  explicit Outline(std::vector<OutlineEdge> edges) : edges_(std::move(edges)) {}
  int count() const { return static_cast<int>(edges_.size()); }
  double length(int edge) const;  // [m]
  Outline scaled(double factor) const;
  /// As a statement of a garment, with further lines in it.
  std::string piece(const std::string& name, const std::string& further) const;
  /// A dart's line on a straight edge, or nothing.
  std::string random_dart(Dice& dice) const;

 private:
  double chord(int edge) const;
  std::vector<OutlineEdge> edges_;
};

/// About (0, 0), out to `size` [m].
Outline random_outline(Dice& dice, double size);

}  // namespace toile::test
