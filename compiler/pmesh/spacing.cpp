#include "compiler/pmesh/spacing.hpp"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double kGrowth = 0.35;  // a side may be longer than its neighbour by about this share
constexpr int kMostSides = 20000;
constexpr int kHalvings = 8;
constexpr int kChordSamples = 8;

class Member {
 public:
  explicit Member(const SpacingMember& m) : m_(m), straight_(is_straight(m)) {}

  double length() const { return m_.to - m_.from; }
  bool straight() const { return straight_; }
  Vec2 at(double t) const { return m_.curve->at(arc(t)); }
  Vec2 tangent(double t) const { return m_.forward ? m_.curve->tangent(arc(t)) : -m_.curve->tangent(arc(t)); }

  /// The largest distance of the curve from the chord between two fractions.
  double stray(double t0, double t1) const {
    if (straight_) return 0;
    const Vec2 a = at(t0), chord = at(t1) - a;
    const double l2 = dot(chord, chord);
    double most = 0;
    for (int i = 1; i < kChordSamples; ++i) {
      const Vec2 p = at(t0 + (t1 - t0) * i / kChordSamples) - a;
      const double along = l2 > 0 ? std::clamp(dot(p, chord) / l2, 0.0, 1.0) : 0.0;
      most = std::max(most, norm(p - along * chord));
    }
    return most;
  }

 private:
  double arc(double t) const { return m_.forward ? m_.from + t * length() : m_.to - t * length(); }

  /// Kinks are breaks, so a stretch on lines only is one straight line.
  static bool is_straight(const SpacingMember& m) {
    return std::all_of(m.curve->segments().begin(), m.curve->segments().end(),
                       [](const Segment& s) { return std::holds_alternative<LineSegment>(s); });
  }

  SpacingMember m_;
  bool straight_;
};

/// The wanted side as a fraction, at the middles of equal samples.
std::vector<double> wanted_sides(const std::vector<Member>& members, const SpacingBounds& bounds) {
  double longest = 0;
  bool straight = true;
  for (const Member& m : members) {
    longest = std::max(longest, m.length());
    straight = straight && m.straight();
  }
  const int samples = straight ? 1 : static_cast<int>(std::clamp(4 * longest / bounds.edge, 16.0, 1024.0));
  std::vector<double> wanted(samples, std::min(1.0, bounds.edge / std::max(longest, 1e-12)));
  for (const Member& m : members) {
    if (m.straight()) continue;
    const double ds = m.length() / samples;
    Vec2 before = m.tangent(1e-9);
    for (int i = 0; i < samples; ++i) {
      const Vec2 after = m.tangent(std::min((i + 1.0) / samples, 1 - 1e-9));
      const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
      // The sagitta of a chord h on the curvature k is k h^2/8.
      if (turn > 0) wanted[i] = std::min(wanted[i], std::sqrt(8 * bounds.chord_error * ds / turn) / m.length());
      before = after;
    }
  }
  for (int i = 1; i < samples; ++i) wanted[i] = std::min(wanted[i], wanted[i - 1] + kGrowth / samples);
  for (int i = samples - 2; i >= 0; --i) wanted[i] = std::min(wanted[i], wanted[i + 1] + kGrowth / samples);
  return wanted;
}

/// Nodes at equal steps of the integral of 1/side.
std::vector<double> spread(const std::vector<double>& wanted, int least) {
  const double step = 1.0 / static_cast<double>(wanted.size());
  double total = 0;
  for (const double w : wanted) total += step / w;
  const int sides = static_cast<int>(std::clamp(std::ceil(total - 0.1), double(least), double{kMostSides}));
  std::vector<double> t{0};
  double sum = 0;
  std::size_t i = 0;
  for (int k = 1; k < sides; ++k) {
    const double goal = total * k / sides;
    while (i + 1 < wanted.size() && sum + step / wanted[i] < goal) sum += step / wanted[i++];
    t.push_back(std::min(1.0, step * static_cast<double>(i) + (goal - sum) * wanted[i]));
  }
  t.push_back(1);
  return t;
}

bool strays(const std::vector<Member>& members, double t0, double t1, double chord_error) {
  return std::any_of(members.begin(), members.end(), [&](const Member& m) { return m.stray(t0, t1) > chord_error; });
}

}  // namespace

std::vector<double> divide_alike(const std::vector<SpacingMember>& spacing_members, const SpacingBounds& bounds) {
  std::vector<Member> members;
  for (const SpacingMember& m : spacing_members) members.emplace_back(m);
  std::vector<double> t = spread(wanted_sides(members, bounds), bounds.least);
  for (int halving = 0; halving < kHalvings; ++halving) {
    std::vector<double> finer{0};
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
      if (strays(members, t[i], t[i + 1], bounds.chord_error)) finer.push_back((t[i] + t[i + 1]) / 2);
      finer.push_back(t[i + 1]);
    }
    if (finer.size() == t.size()) break;
    t = std::move(finer);
  }
  return t;
}

}  // namespace toile
