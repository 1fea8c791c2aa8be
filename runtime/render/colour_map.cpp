#include "runtime/render/colour_map.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace toile {
namespace {

struct Lab {
  double l = 0, a = 0, b = 0;
};

Lab operator+(Lab x, Lab y) {
  return {x.l + y.l, x.a + y.a, x.b + y.b};
}
Lab operator*(double s, Lab x) {
  return {s * x.l, s * x.a, s * x.b};
}
double distance(Lab x, Lab y) {
  return std::hypot(x.l - y.l, x.a - y.a, x.b - y.b);
}

/// Lightness, chroma and hue in degrees.
Lab from_lch(double l, double c, double h) {
  const double radians = h * std::numbers::pi / 180;
  return {l, c * std::cos(radians), c * std::sin(radians)};
}

Lab oklab(Rgb c) {
  const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
  const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
  const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Rgb linear(Lab c) {
  const double l = std::pow(c.l + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
  const double m = std::pow(c.l - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
  const double s = std::pow(c.l - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
  const auto unit = [](double x) { return std::clamp(x, 0.0, 1.0); };
  return {unit(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          unit(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          unit(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

/// A smooth curve through the control points, tabulated at equal arc lengths.
class UniformMap {
 public:
  explicit UniformMap(const std::vector<Lab>& control) {
    constexpr int kFine = 64;
    std::vector<Lab> fine;
    std::vector<double> arc;
    for (std::size_t i = 0; i + 1 < control.size(); ++i) {
      for (int k = 0; k < kFine; ++k) append(fine, arc, catmull_rom(control, i, k / static_cast<double>(kFine)));
    }
    append(fine, arc, control.back());

    std::size_t at = 0;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      const double wanted = arc.back() * static_cast<double>(i) / static_cast<double>(colours_.size() - 1);
      while (at + 2 < arc.size() && arc[at + 1] < wanted) ++at;
      const double t = std::clamp((wanted - arc[at]) / (arc[at + 1] - arc[at]), 0.0, 1.0);
      colours_[i] = linear((1 - t) * fine[at] + t * fine[at + 1]);
    }
  }

  Rgb operator()(double t) const {
    const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(colours_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), colours_.size() - 2);
    return mix(colours_[i], colours_[i + 1], place - static_cast<double>(i));
  }

 private:
  static Lab catmull_rom(const std::vector<Lab>& p, std::size_t i, double t) {
    const Lab& before = p[i == 0 ? 0 : i - 1];
    const Lab& after = p[std::min(i + 2, p.size() - 1)];
    const double t2 = t * t;
    const double t3 = t2 * t;
    return 0.5 * ((2 - 5 * t2 + 3 * t3) * p[i] + (-t + 2 * t2 - t3) * before + (t + 4 * t2 - 3 * t3) * p[i + 1] +
                  (t3 - t2) * after);
  }
  static void append(std::vector<Lab>& fine, std::vector<double>& arc, Lab next) {
    arc.push_back(fine.empty() ? 0 : arc.back() + distance(fine.back(), next));
    fine.push_back(next);
  }

  std::array<Rgb, 513> colours_;
};

}  // namespace

Rgb sequential_colour(double t) {
  static const UniformMap map({from_lch(0.24, 0.105, 300), from_lch(0.38, 0.115, 275), from_lch(0.51, 0.098, 238),
                               from_lch(0.63, 0.105, 185), from_lch(0.76, 0.150, 146), from_lch(0.91, 0.175, 109)});
  return map(t);
}

Rgb diverging_colour(double t) {
  static const UniformMap cold({from_lch(0.955, 0.004, 250), from_lch(0.80, 0.085, 245), from_lch(0.62, 0.140, 252),
                                from_lch(0.42, 0.150, 262)});
  static const UniformMap warm(
      {from_lch(0.955, 0.004, 60), from_lch(0.80, 0.095, 45), from_lch(0.62, 0.165, 32), from_lch(0.42, 0.150, 24)});
  return t < 0 ? cold(-t) : warm(t);
}

double lightness(Rgb light) {
  return oklab(light).l;
}

double colour_difference(Rgb a, Rgb b) {
  return distance(oklab(a), oklab(b));
}

}  // namespace toile
