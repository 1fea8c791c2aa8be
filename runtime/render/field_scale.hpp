// Which values of a field the colours span, and where a scale has its ticks.
#pragma once

#include <vector>

#include "runtime/field/field.hpp"
#include "runtime/render/colour.hpp"

namespace toile {

class FieldScale {
 public:
  /// From the 1st to the 99th percentile by area, so that one wild triangle does not take all the colour; symmetric
  /// about zero for a diverging field, from zero over the positive values for one that has no negative ones.
  FieldScale(const Field& field, const std::vector<double>& values, const std::vector<double>& areas);

  Rgb colour(double value) const;  // SI
  double low() const { return low_; }
  double high() const { return high_; }
  /// The field's own extremes, beyond the colours' ends or not.
  double least() const { return least_; }
  double greatest() const { return greatest_; }
  /// Round values within the colours' span: 3 to 7 of them, in the field's unit, ascending.
  std::vector<double> ticks() const;
  double to_unit() const { return to_unit_; }
  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }

 private:
  std::string name_, unit_;
  double to_unit_ = 1;
  bool diverging_ = false;
  double low_ = 0, high_ = 1, least_ = 0, greatest_ = 0;
};

/// A number as a scale shows it: as few digits as tell ticks `step` apart.
std::string tick_label(double value, double step);

}  // namespace toile
