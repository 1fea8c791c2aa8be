#include "runtime/fabric/law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double kes_force = 490.3325;     // [N/m], 500 gf/cm
constexpr double blend = 1e-4;             // half width of the passage from compression to tension
constexpr double smoothing_curvature = 4;  // [1/m]
constexpr double shear_smoothing = 0.25 * degree;
// A loop with a memory is as steep at its beginning as the loading branch.
constexpr double slip_curvature = 2 * smoothing_curvature;
constexpr double slip_angle = 2 * shear_smoothing;
constexpr double shear_loop_end = 8 * degree;
constexpr double woven_locking = 40 * degree;

/// LT = 2/z - 2/(exp(z) - 1) falls from 2 through 1 at z = 0 to 0; the root by bisection.
double exponent_of_linearity(double lt) {
  const auto linearity = [](double z) { return std::abs(z) < 1e-4 ? 1 - z / 6 : 2 / z - 2 / std::expm1(z); };
  double low = -30, high = 30;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (linearity(middle) > lt ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The scale of the barrier between two layers that presses them to `share` of T0 under the plate that measures Tm.
double layer_pressure(double share) {
  const double y = std::clamp(share, 0.3, 0.95), rest = 1 - y;
  return 4.9e3 / (-2 * rest * std::log(y) + rest * rest / y);
}

}  // namespace

ElongationLaw ElongationLaw::linear(double stiffness) {
  ElongationLaw law;
  law.initial_ = law.compression_ = stiffness;
  return law;
}

ElongationLaw ElongationLaw::from_kes(double emt, double lt) {
  ElongationLaw law;
  law.limit_ = emt;
  law.exponent_ = exponent_of_linearity(lt);
  if (std::abs(law.exponent_) < 1e-6) law.exponent_ = 1e-6;
  law.scale_ = kes_force / std::expm1(law.exponent_);
  law.initial_ = law.scale_ * law.exponent_ / emt;
  law.compression_ = 0.1 * law.initial_;
  // Across the blend the slope runs straight from compression to tension; what that loses against the curve shifts the
  // rest.
  const Density curve = law.stretched(blend);
  law.top_ = curve.stiffness;
  const double middle = 0.5 * (law.compression_ + curve.stiffness);
  const double rise = (curve.stiffness - law.compression_) / (2 * blend);
  law.shift_force_ = middle * blend + 0.5 * rise * blend * blend - curve.force;
  law.shift_energy_ = 0.5 * middle * blend * blend + rise * blend * blend * blend / 6 - curve.energy;
  return law;
}

Density ElongationLaw::stretched(double strain) const {
  const double inside = std::min(strain, limit_);
  const double growth = std::exp(exponent_ * inside / limit_);
  Density density{scale_ * (limit_ / exponent_ * (growth - 1) - inside), scale_ * (growth - 1),
                  scale_ * exponent_ / limit_ * growth};
  const double beyond = strain - inside;
  density.energy += density.force * beyond + 0.5 * density.stiffness * beyond * beyond;
  density.force += density.stiffness * beyond;
  return density;
}

Density ElongationLaw::operator()(double strain) const {
  if (limit_ == 0) return {0.5 * initial_ * strain * strain, initial_ * strain, initial_};
  if (strain > blend) {
    Density density = stretched(strain);
    density.energy += shift_force_ * (strain - blend) + shift_energy_;
    density.force += shift_force_;
    return density;
  }
  const double middle = 0.5 * (compression_ + top_);
  const double rise = (top_ - compression_) / (2 * blend);
  const auto blended = [&](double e) {
    return Density{0.5 * middle * e * e + rise * e * e * e / 6, middle * e + 0.5 * rise * e * e, middle + rise * e};
  };
  if (strain >= -blend) return blended(strain);
  const Density edge = blended(-blend);
  const double beyond = strain + blend;
  return {edge.energy + edge.force * beyond + 0.5 * compression_ * beyond * beyond, edge.force + compression_ * beyond,
          compression_};
}

ShearLaw::ShearLaw(double stiffness, double hysteresis_half_degree, double hysteresis_five_degrees,
                   double locking_angle)
    : stiffness_(stiffness), locking_(locking_angle) {
  const double half = hysteresis_half_degree / 2, five = hysteresis_five_degrees / 2;
  // A loop that grows faster than the whole curve would leave nothing elastic: keep a third of G.
  slope_ = std::clamp((five - half) / (4.5 * degree), 0.0, 2 * stiffness / 3);
  step_ = std::max(0.0, half - slope_ * 0.5 * degree);
}

ShearLaw ShearLaw::linear(double stiffness) {
  return {stiffness, 0, 0, 0};
}

ElongationLaw ElongationLaw::softened(double share) const {
  ElongationLaw soft = *this;
  for (double* part : {&soft.initial_, &soft.compression_, &soft.scale_, &soft.shift_force_, &soft.shift_energy_}) {
    *part *= share;
  }
  soft.top_ = soft.stretched(blend).stiffness;
  return soft;
}

ShearLaw ShearLaw::softened(double share) const {
  ShearLaw soft = *this;
  for (double* part : {&soft.stiffness_, &soft.step_, &soft.slope_}) *part *= share;
  return soft;
}

/// The threads begin to jam past the end of the loop.
Density ShearLaw::jammed(Density density, double angle) const {
  const double beyond = std::abs(angle) - shear_loop_end;
  if (locking_ == 0 || beyond <= 0) return density;
  const double jam = 10 * stiffness_ / ((locking_ - shear_loop_end) * (locking_ - shear_loop_end));
  density.energy += jam * beyond * beyond * beyond * beyond / 4;
  density.force += (angle > 0 ? 1 : -1) * jam * beyond * beyond * beyond;
  density.stiffness += 3 * jam * beyond * beyond;
  return density;
}

/// Past its end the loop no longer grows; the slope goes over smoothly within a degree.
Density ShearLaw::past_loop(Density density, double angle) const {
  const double beyond = std::abs(angle) - shear_loop_end;
  if (locking_ == 0 || beyond <= 0) return density;
  const bool passing = beyond < degree;
  density.energy -= slope_ * (passing ? beyond * beyond * beyond / (6 * degree)
                                      : degree * degree / 6 + (beyond - degree) * beyond / 2);
  density.force -= (angle > 0 ? 1 : -1) * slope_ * (passing ? beyond * beyond / (2 * degree) : beyond - degree / 2);
  density.stiffness -= slope_ * std::min(beyond / degree, 1.0);
  return density;
}

Density ShearLaw::operator()(double angle) const {
  const double root = std::hypot(angle, shear_smoothing);
  Density density{0.5 * stiffness_ * angle * angle + step_ * (root - shear_smoothing),
                  stiffness_ * angle + step_ * angle / root,
                  stiffness_ + step_ * shear_smoothing * shear_smoothing / (root * root * root)};
  return jammed(past_loop(density, angle), angle);
}

Slip ShearLaw::loop() const {
  return {slip_angle, step_, slope_, shear_loop_end + degree / 2};
}

Density ShearLaw::operator()(double angle, double anchor) const {
  const double elastic = stiffness_ - slope_;
  Density density = slip_density(loop(), anchor, angle);
  density.energy += 0.5 * elastic * angle * angle;
  density.force += elastic * angle;
  density.stiffness += elastic;
  return jammed(density, angle);
}

Density BendingLaw::operator()(double curvature) const {
  const double root = std::hypot(curvature, smoothing_curvature);
  return {0.5 * rigidity * curvature * curvature + friction * (root - smoothing_curvature),
          rigidity * curvature + friction * curvature / root,
          rigidity + friction * smoothing_curvature * smoothing_curvature / (root * root * root)};
}

Slip BendingLaw::loop() const {
  return {slip_curvature, friction, 0, 0};
}

Density BendingLaw::operator()(double curvature, double anchor) const {
  Density density = slip_density(loop(), anchor, curvature);
  density.energy += 0.5 * rigidity * curvature * curvature;
  density.force += rigidity * curvature;
  density.stiffness += rigidity;
  return density;
}

FabricLaw softened(const FabricLaw& law, double share) {
  FabricLaw soft = law;
  soft.warp = law.warp.softened(share);
  soft.weft = law.weft.softened(share);
  soft.shear = law.shear.softened(share);
  return soft;
}

FabricSheet with_class_values(FabricSheet sheet) {
  sheet = in_kes_rows(std::move(sheet));
  const auto take = [](auto& row, auto value) {
    if (!row) row = value;
  };
  // Of LT, WT and EMT two say the third: WT = LT Fm EMT / 2.
  const auto double_work = [&sheet](const std::optional<WarpWeft>& by) {
    return WarpWeft{2 * sheet.wt->warp / kes_force / by->warp, 2 * sheet.wt->weft / kes_force / by->weft};
  };
  if (sheet.wt && sheet.lt) take(sheet.emt, double_work(sheet.lt));
  if (sheet.wt && sheet.emt) take(sheet.lt, double_work(sheet.emt));
  take(sheet.lt, WarpWeft{0.65, 0.65});
  if (sheet.wt) take(sheet.emt, double_work(sheet.lt));
  take(sheet.emt, WarpWeft{0.05, 0.05});
  take(sheet.g, WarpWeft{0.6 * 56.188, 0.6 * 56.188});
  take(sheet.hg, WarpWeft{});
  take(sheet.hg5, *sheet.hg);
  take(sheet.b, WarpWeft{});
  take(sheet.hb, WarpWeft{});
  take(sheet.twist, 0.5 * std::sqrt(sheet.b->warp * sheet.b->weft));
  take(sheet.weight, 0.0);
  if (!sheet.t0 || !sheet.tm) sheet.tm = 0.7 * sheet.t0.value_or(0.0005);
  take(sheet.t0, 0.0005);
  take(sheet.miu, 0.2);
  return sheet;
}

FabricLaw make_law(const FabricSheet& measured) {
  const FabricSheet sheet = with_class_values(measured);
  const auto mean = [](const std::optional<WarpWeft>& row) { return 0.5 * (row->warp + row->weft); };
  const auto elongation = [&sheet](double WarpWeft::*thread) {
    return sheet.stretch ? ElongationLaw::linear((*sheet.stretch).*thread)
                         : ElongationLaw::from_kes((*sheet.emt).*thread, (*sheet.lt).*thread);
  };
  const ShearLaw shear = sheet.shear ? ShearLaw::linear(*sheet.shear)
                                     : ShearLaw(mean(sheet.g), mean(sheet.hg), mean(sheet.hg5), woven_locking);
  // Plies are sewn along their edges and slide on each other between: what each resists adds up.
  const double plies = sheet.plies;
  return FabricLaw{
      .warp = elongation(&WarpWeft::warp).softened(plies),
      .weft = elongation(&WarpWeft::weft).softened(plies),
      .shear = shear.softened(plies),
      .bend_warp = {plies * sheet.b->warp, plies * sheet.hb->warp / 2},
      .bend_weft = {plies * sheet.b->weft, plies * sheet.hb->weft / 2},
      .twist = plies * *sheet.twist,
      .weight = plies * *sheet.weight,
      .thickness = plies * *sheet.t0,
      .pressure = layer_pressure(*sheet.tm / *sheet.t0),
      .friction = *sheet.miu,
  };
}

}  // namespace toile
