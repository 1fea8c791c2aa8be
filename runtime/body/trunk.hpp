// The trunk of a dress form: a grid of vertices lofted through its sections.
#pragma once

#include <vector>

#include "compiler/pattern/body_spec.hpp"
#include "runtime/body/half_form.hpp"
#include "runtime/body/monotone_cubic.hpp"

namespace toile {

/// The sections interpolated in level: girth, proportions, place and shape each by a monotone cubic.
class TrunkProfile {
 public:
  explicit TrunkProfile(const std::vector<BodySection>& sections);
  /// The whole ring of `count` vertices at a level, from the front counter-clockwise seen from above.
  std::vector<Vec3> ring(double level, int count) const;

 private:
  MonotoneCubic girth_, ratio_, forward_, squareness_;
};

/// Columns run from the front centre (0) over the left side to the back centre; rows upwards.
struct Trunk {
  std::vector<std::vector<int>> rows;  // vertices of the half form
  std::vector<bool> is_named;  // rows that are named sections: their girth is promised, fairing leaves them alone
  std::vector<int> row_of_section;
  int columns() const { return static_cast<int>(rows.front().size()); }
  int side() const { return columns() / 2; }
};

/// Adds the vertices; rows follow the sections and are evenly spaced along the surface between them.
Trunk lay_out_trunk(const std::vector<BodySection>& sections, HalfForm& form);

/// A block of the grid, rows and columns inclusive, that is left open for a limb.
struct Opening {
  int first_row = 0, last_row = -1;
  int first_column = 0, last_column = -1;
};

void skin_trunk(const Trunk& trunk, const Opening& opening, HalfForm& form);

/// Closes the top of the trunk (`upwards`) or its bottom by a low dome.
void cap_trunk(const std::vector<int>& rim, bool upwards, HalfForm& form);

}  // namespace toile
