#include "runtime/place/leg_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr int directions_about = 72;
constexpr double level_step = 0.01;    // [m] between rings
constexpr double farthest_skin = 0.5;  // [m] from the middle to the skin

}  // namespace

LegFrame::LegFrame(Vec3 down) : axis(down) {
  const Vec3 front{0, -1, 0};
  const Vec3 across = front - dot(front, axis) * axis;
  forward = norm(across) > 1e-3 ? normalized(across) : normalized(Vec3{1, 0, 0} - axis.x * axis);
  aside = cross(forward, axis);
}

Vec3 LegFrame::outwards(double fraction) const {
  const double angle = 2 * std::numbers::pi * fraction;
  return std::cos(angle) * forward + std::sin(angle) * aside;
}

LegRings::LegRings(const Body& body, const LegFrame& frame, const std::vector<Divide>& divides, Vec3 start, double top,
                   double bottom, double clearance)
    : frame_(frame), divides_(divides), clearance_(clearance), top_(top) {
  Vec3 middle = start + (top - frame.level(start)) * frame.axis;
  const int count = std::max(1, static_cast<int>(std::ceil((bottom - top) / level_step))) + 1;
  for (int i = 0; i < count; ++i) {
    const auto inside = body.nearest(middle, 0);
    if (!inside && i > 0) {
      rings_.push_back({middle, rings_.back().radius});
    } else {
      rings_.push_back(measured(body, middle));
      Vec3 sum;  // about its own middle: a ring that is drawn from aside is drawn again
      for (int k = 0; k < directions_about; ++k) {
        sum += rings_.back().radius[k] * frame.outwards(static_cast<double>(k) / directions_about);
      }
      middle += sum / static_cast<double>(directions_about);
      rings_.back() = measured(body, middle);
    }
    middle += level_step * frame.axis;
  }
}

double LegRings::room(Vec3 middle, Vec3 direction) const {
  double most = farthest_skin;
  for (const Divide& divide : divides_) {
    const double towards = dot(direction, divide.away);
    const double left = dot(divide.point - middle, divide.away) - clearance_;
    if (towards > 1e-9) most = std::min(most, std::max(left, 0.0) / towards);
  }
  return most;
}

// From the middle outwards to where the body is left, by steps no longer than the distance to the skin.
LegRings::Ring LegRings::measured(const Body& body, Vec3 middle) const {
  Ring ring{middle, {}};
  for (int k = 0; k < directions_about; ++k) {
    const Vec3 direction = frame_.outwards(static_cast<double>(k) / directions_about);
    const double most = room(middle, direction);
    double radius = 0;
    while (radius < most) {
      const auto surface = body.nearest(middle + radius * direction, clearance_);
      if (!surface || surface->distance >= clearance_) break;
      radius += std::max(clearance_ - surface->distance, 5e-4);
    }
    ring.radius.push_back(std::min(radius, most));
  }
  return ring;
}

std::size_t LegRings::index(double level) const {
  const double x = std::clamp((level - top_) / level_step, 0.0, static_cast<double>(rings_.size() - 1));
  return std::min(static_cast<std::size_t>(x), rings_.size() - 1);
}

double LegRings::fraction_of(Vec3 p) const {
  const Vec3 d = p - rings_[index(frame_.level(p))].middle;
  return std::atan2(dot(d, frame_.aside), dot(d, frame_.forward)) / (2 * std::numbers::pi);
}

Vec3 LegRings::on_ring(const Ring& ring, double fraction, double slack) const {
  const double x = (fraction - std::floor(fraction)) * directions_about;
  const int k = static_cast<int>(x) % directions_about;
  const double t = x - std::floor(x);
  const double radius = (1 - t) * ring.radius[k] + t * ring.radius[(k + 1) % directions_about];
  const Vec3 direction = frame_.outwards(fraction);
  return ring.middle + std::min(radius + slack, room(ring.middle, direction)) * direction;
}

Vec3 LegRings::at(double level, double fraction, double slack) const {
  const std::size_t i = index(level), j = std::min(i + 1, rings_.size() - 1);
  const double t = (level - top_) / level_step - static_cast<double>(i);
  const double within = std::clamp(t, 0.0, 1.0);
  const Vec3 p = (1 - within) * on_ring(rings_[i], fraction, slack) + within * on_ring(rings_[j], fraction, slack);
  return p + (level - frame_.level(p)) * frame_.axis;
}

double LegRings::girth(double level) const {
  const Ring& ring = rings_[index(level)];
  double sum = 0;
  for (int k = 0; k < directions_about; ++k) {
    sum += distance(on_ring(ring, static_cast<double>(k) / directions_about, 0),
                    on_ring(ring, static_cast<double>(k + 1) / directions_about, 0));
  }
  return sum;
}

}  // namespace toile
