// What kind of quantity a number is: exponents of length, mass, time and angle. Angles are a dimension of their own, so
// that `68cm + 3deg` and `sin(2)` are mistakes that can be pointed at.
#pragma once

#include <optional>
#include <string>

namespace toile {

struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;

  constexpr bool plain() const { return *this == Dimension{}; }
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

constexpr Dimension operator*(Dimension a, Dimension b) {
  return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
}
constexpr Dimension operator/(Dimension a, Dimension b) {
  return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
}
constexpr Dimension power(Dimension a, int n) {
  return {a.length * n, a.mass * n, a.time * n, a.angle * n};
}
/// The dimension whose square this is; there is none for odd exponents.
std::optional<Dimension> root(Dimension a);

namespace dimension {
inline constexpr Dimension number{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension area{2, 0, 0, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension mass{0, 1, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension force{1, 1, -2, 0};
inline constexpr Dimension energy{2, 1, -2, 0};
inline constexpr Dimension pressure{-1, 1, -2, 0};
inline constexpr Dimension line_force = force / length;   // membrane stress
inline constexpr Dimension softness = pressure / length;  // pressure per depth
inline constexpr Dimension area_weight = mass / area;     // W of a fabric
inline constexpr Dimension shear_stiffness = line_force / angle;
inline constexpr Dimension curvature = number / length;
}  // namespace dimension

/// In words with the article: "a length", "an angle", "a plain number", "a quantity in kg*m/s".
std::string describe(Dimension a);
/// As SI base units: "kg/s^2", "1" for a plain number.
std::string si_symbol(Dimension a);

}  // namespace toile
