#include "runtime/render/cloth_brdf.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace toile {
namespace {

using std::numbers::pi;
constexpr double kRoughness = 0.5;  // of the fibres' directions; 1 is a fuzz without direction

double sheen_value(double cos_light, double cos_view, double cos_half) {
  constexpr double kInverse = 1 / kRoughness;
  static_assert(kInverse == 2.0, "the power of the sine is written out below");
  const double sine_squared = std::max(0.0, 1 - cos_half * cos_half);
  const double distribution = (2 + kInverse) / (2 * pi) * sine_squared;
  const double visibility = 1 / (4 * (cos_light + cos_view - cos_light * cos_view));
  return distribution * visibility;
}

/// The directional albedo at equidistant cosines, and its mean over the hemisphere.
struct SheenTable {
  std::array<double, 65> albedo{};
  double mean = 0;

  SheenTable() {
    for (std::size_t i = 0; i < albedo.size(); ++i) {
      albedo[i] = integrated(std::max(1e-3, static_cast<double>(i) / static_cast<double>(albedo.size() - 1)));
    }
    constexpr int kSteps = 1024;
    for (int k = 0; k < kSteps; ++k) {
      const double cosine = (k + 0.5) / kSteps;
      mean += 2 * cosine * (*this)(cosine) / kSteps;
    }
  }

  double operator()(double cosine) const {
    const double place = std::clamp(cosine, 0.0, 1.0) * static_cast<double>(albedo.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), albedo.size() - 2);
    const double t = place - static_cast<double>(i);
    return (1 - t) * albedo[i] + t * albedo[i + 1];
  }

 private:
  static double integrated(double cos_view) {
    constexpr int kCosines = 96;
    constexpr int kAngles = 96;
    const double sin_view = std::sqrt(1 - cos_view * cos_view);
    double sum = 0;
    for (int i = 0; i < kCosines; ++i) {
      const double cos_light = (i + 0.5) / kCosines;
      const double sin_light = std::sqrt(1 - cos_light * cos_light);
      for (int k = 0; k < kAngles; ++k) {
        const double between = cos_light * cos_view + sin_light * sin_view * std::cos(pi * (k + 0.5) / kAngles);
        const double cos_half = (cos_light + cos_view) / std::sqrt(2 + 2 * between);
        sum += sheen_value(cos_light, cos_view, cos_half) * cos_light;
      }
    }
    return sum * 2 * pi / (kCosines * kAngles);
  }
};

const SheenTable& sheen_table() {
  static const SheenTable table;
  return table;
}

}  // namespace

double sheen_albedo(double cosine) {
  return sheen_table()(cosine);
}

ClothBrdf::ClothBrdf(Rgb base, Rgb sheen) : base_(base), sheen_(sheen), rest_(grey(1) - sheen_table().mean * sheen) {}

Rgb ClothBrdf::operator()(double cos_light, double cos_view, double cos_half) const {
  const SheenTable& table = sheen_table();
  const Rgb in = grey(1) - table(cos_light) * sheen_;
  const Rgb out = grey(1) - table(cos_view) * sheen_;
  return (1 / pi) * (base_ * in * out / rest_) + sheen_value(cos_light, cos_view, cos_half) * sheen_;
}

Rgb ClothBrdf::operator()(Vec3 normal, Vec3 to_light, Vec3 to_view) const {
  const double cos_light = dot(normal, to_light);
  const double cos_view = dot(normal, to_view);
  if (!(cos_light > 0 && cos_view > 0)) return {};
  const Vec3 half = to_light + to_view;
  return (*this)(cos_light, cos_view, dot(normal, half) / norm(half));
}

}  // namespace toile
