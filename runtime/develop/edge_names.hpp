// How the edges of a developed pattern are called: as they were drawn, parts and copies told apart.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile {

class EdgeNames {
 public:
  /// Where halves are redrawn for pieces on the fold, copies have the names of what they are copies of.
  EdgeNames(const Garment& garment, bool halved);

  const std::string& of(int piece, int edge) const;
  const std::string& of_piece(int piece) const;
  static std::string of_hole(std::size_t number);
  /// As a seam names it behind its piece: of a hole's edge with the hole.
  std::string reference(EdgeRef edge) const;

 private:
  const Garment& garment_;
  std::vector<std::string> pieces_;
  std::vector<std::vector<std::string>> edges_;
};

}  // namespace toile
