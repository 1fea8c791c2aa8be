// Where curves meet. Two parts can only meet if their chords come nearer than both stray from them; parts are halved
// until they stray by no more than a nanometre, and the places found are refined by Newton's method on the exact
// curves.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include "compiler/curve/curve.hpp"
#include "compiler/curve/segment.hpp"

namespace toile {
namespace {

constexpr double kTouch = 1e-9;             // [m] curves nearer than this meet
constexpr double kFlat = 1e-9;              // [m] a part that strays less from its chord is treated as the chord
constexpr double kSame = 1e-5;              // [m] meetings nearer than this along both curves are one
constexpr double kSharedEnd = 1e-6;         // [m] a meeting this near to an end common to both is that end
constexpr int kMostSteps = 200'000;         // pairs of parts looked at for a pair of segments
constexpr std::size_t kMostCrossings = 32;  // an overlap is reported by that many places at most

// A stretch of a segment that cannot cross itself.
struct Part {
  const Segment* segment;
  double t0, t1;
  double s0;  // arc length at t0 along the whole curve
  Vec2 from, to;
  double stray;

  Part(const Segment& whole, double begin, double end, double arc)
      : segment(&whole),
        t0(begin),
        t1(end),
        s0(arc),
        from(point(whole, begin)),
        to(point(whole, end)),
        stray(toile::stray(part(whole, begin, end))) {}

  // Halves share the arc length at the start of the whole part: it is only wanted for those parts that meet.
  Part half(bool second) const {
    const double middle = (t0 + t1) / 2;
    return second ? Part(*segment, middle, t1, s0) : Part(*segment, t0, middle, s0);
  }
};

std::vector<Part> parts_of(const Curve& curve) {
  std::vector<Part> parts;
  parts.reserve(curve.segments().size());
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const Segment& segment = curve.segments()[i];
    const std::vector<double> cuts = monotone_cuts(segment);
    double arc = curve.start_of(i), before = 0;
    for (const double cut : cuts) {
      parts.emplace_back(segment, before, cut, arc);
      arc += length_between(segment, before, cut);
      before = cut;
    }
    parts.emplace_back(segment, before, 1, arc);
  }
  return parts;
}

double chord_distance(const Part& a, const Part& b) {
  const Vec2 d = a.to - a.from, e = b.to - b.from;
  const double left = cross(d, b.from - a.from), right = cross(d, b.to - a.from);
  const double below = cross(e, a.from - b.from), above = cross(e, a.to - b.from);
  if (((left > 0) != (right > 0)) && ((below > 0) != (above > 0))) return 0;
  return std::min({distance_to_segment(a.from, b.from, b.to), distance_to_segment(a.to, b.from, b.to),
                   distance_to_segment(b.from, a.from, a.to), distance_to_segment(b.to, a.from, a.to)});
}

bool boxes_apart(const Part& a, const Part& b) {
  const double margin = a.stray + b.stray + kTouch;
  const auto apart = [&](double a0, double a1, double b0, double b1) {
    return std::min(a0, a1) > std::max(b0, b1) + margin || std::min(b0, b1) > std::max(a0, a1) + margin;
  };
  return apart(a.from.x, a.to.x, b.from.x, b.to.x) || apart(a.from.y, a.to.y, b.from.y, b.to.y);
}

// The directions in which a part lies as seen from `p`, one of its ends: its control points but that end. Those of an
// arc are where the tangents at its ends meet, and the other end.
class Directions {
 public:
  Directions(const Part& seen, Vec2 p) : p_(p) {
    const Segment whole = part(*seen.segment, seen.t0, seen.t1);
    if (const auto* b = std::get_if<BezierSegment>(&whole)) {
      for (const Vec2 point : {b->p0, b->p1, b->p2, b->p3}) add(point);
      return;
    }
    add(seen.from);
    add(seen.to);
    if (const auto* a = std::get_if<ArcSegment>(&whole)) {
      const double half = a->sweep / 2;
      add(a->centre + a->radius / std::cos(half) * direction(a->start + half));
    }
  }

  const Vec2* begin() const { return directions_.data(); }
  const Vec2* end() const { return directions_.data() + count_; }
  std::size_t size() const { return count_; }

 private:
  void add(Vec2 point) {
    const double away = distance(point, p_);
    if (away > kTouch) directions_[count_++] = (point - p_) / away;
  }

  Vec2 p_;
  std::array<Vec2, 4> directions_;
  std::size_t count_ = 0;
};

// Two parts that follow on each other meet nowhere but there when a line through that place parts them. So it is at
// nearly every corner and joint, and the search would halve its way down to it.
bool parted_at_joint(const Part& a, const Part& b) {
  const Vec2 p = a.to;
  if (distance(p, b.from) > 1e-12) return false;
  const Directions before(a, p), after(b, p);
  Vec2 across{0, 0};
  for (const Vec2 d : before) across = across + d / static_cast<double>(before.size());
  for (const Vec2 d : after) across = across - d / static_cast<double>(after.size());
  if (before.size() == 0 || after.size() == 0 || norm(across) < 1e-3) return false;
  const double margin = 1e-6 * norm(across);
  return std::ranges::all_of(before, [&](Vec2 d) { return dot(d, across) > margin; }) &&
         std::ranges::all_of(after, [&](Vec2 d) { return dot(d, across) < -margin; });
}

struct Meeting {
  double t = 0, u = 0;  // native parameters of the two segments
};

// Newton on first(t) = second(u) within the parts' parameters, as long as it brings the points nearer.
std::optional<Meeting> refine(const Part& a, const Part& b, Meeting guess) {
  const auto gap = [&](const Meeting& m) { return point(*b.segment, m.u) - point(*a.segment, m.t); };
  Meeting best = guess;
  double nearest = norm(gap(best));
  for (int step = 0; step < 60 && nearest > 0; ++step) {
    const Vec2 d = derivative(*a.segment, best.t), e = derivative(*b.segment, best.u);
    const double area = cross(d, e);
    if (area == 0) break;
    const Vec2 r = gap(best);
    const Meeting next{std::clamp(best.t + cross(r, e) / area, a.t0, a.t1),
                       std::clamp(best.u + cross(r, d) / area, b.t0, b.t1)};
    const double distance_there = norm(gap(next));
    if (!(distance_there < nearest)) break;
    best = next;
    nearest = distance_there;
  }
  if (nearest > kTouch) return std::nullopt;
  return best;
}

// Candidates on two nearly straight parts: where the chords cross, and the ends that lie on the other part.
std::vector<Meeting> guesses(const Part& a, const Part& b) {
  std::vector<Meeting> found;
  const Vec2 d = a.to - a.from, e = b.to - b.from, r = b.from - a.from;
  const auto add = [&](double x, double y) {
    const double t = std::clamp(x, 0.0, 1.0), u = std::clamp(y, 0.0, 1.0);
    found.push_back({a.t0 + t * (a.t1 - a.t0), b.t0 + u * (b.t1 - b.t0)});
  };
  const double area = cross(d, e);
  if (std::abs(area) > 1e-12 * norm(d) * norm(e)) add(cross(r, e) / area, cross(r, d) / area);
  const auto foot = [](Vec2 p, Vec2 from, Vec2 along) {
    const double square = dot(along, along);
    return square > 0 ? dot(p - from, along) / square : 0.0;
  };
  add(0, foot(a.from, b.from, e));
  add(1, foot(a.to, b.from, e));
  add(foot(b.from, a.from, d), 0);
  add(foot(b.to, a.from, d), 1);
  return found;
}

// Gathers meetings of two curves, leaving out those that `shared` says are a common end.
template <class Shared>
class Search {
 public:
  explicit Search(Shared shared) : shared_(shared) {}

  void pair(const Part& first, const Part& second) {
    if (boxes_apart(first, second)) return;
    std::vector<std::pair<Part, Part>> waiting{{first, second}};
    for (int step = 0; step < kMostSteps && !waiting.empty() && found_.size() < kMostCrossings; ++step) {
      const auto [a, b] = waiting.back();
      waiting.pop_back();
      if (boxes_apart(a, b) || chord_distance(a, b) > a.stray + b.stray + kTouch) continue;
      if (a.stray <= kFlat && b.stray <= kFlat) {
        for (const Meeting& guess : guesses(a, b)) add(first, second, refine(a, b, guess));
        continue;
      }
      const bool halve_first = a.stray >= b.stray;
      for (const bool half : {true, false}) {
        waiting.emplace_back(halve_first ? a.half(half) : a, halve_first ? b : b.half(half));
      }
    }
  }

  std::vector<Crossing> take() {
    std::sort(found_.begin(), found_.end(), [](const Crossing& x, const Crossing& y) {
      return x.s_first != y.s_first ? x.s_first < y.s_first : x.s_second < y.s_second;
    });
    return std::move(found_);
  }

 private:
  void add(const Part& first, const Part& second, const std::optional<Meeting>& meeting) {
    if (!meeting) return;
    const Crossing crossing{first.s0 + length_between(*first.segment, first.t0, meeting->t),
                            second.s0 + length_between(*second.segment, second.t0, meeting->u),
                            point(*first.segment, meeting->t)};
    if (shared_(crossing)) return;
    for (const Crossing& known : found_) {
      if (std::abs(known.s_first - crossing.s_first) < kSame && std::abs(known.s_second - crossing.s_second) < kSame) {
        return;
      }
    }
    found_.push_back(crossing);
  }

  Shared shared_;
  std::vector<Crossing> found_;
};

// About the control points of a curve, or the circles of its arcs.
struct Bounds {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};

  explicit Bounds(const Curve& curve) {
    for (const Segment& segment : curve.segments()) std::visit([this](const auto& s) { add(s); }, segment);
  }
  bool apart(const Bounds& other) const {
    const double margin = 2 * kTouch;
    return low.x > other.high.x + margin || other.low.x > high.x + margin || low.y > other.high.y + margin ||
           other.low.y > high.y + margin;
  }

 private:
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const LineSegment& l) {
    add(l.from);
    add(l.to);
  }
  void add(const ArcSegment& a) {
    add(a.centre - Vec2{a.radius, a.radius});
    add(a.centre + Vec2{a.radius, a.radius});
  }
  void add(const BezierSegment& b) {
    for (const Vec2 p : {b.p0, b.p1, b.p2, b.p3}) add(p);
  }
};

template <class SearchOf>
std::vector<Crossing> found_by(SearchOf search, const Curve& first, const Curve& second) {
  if (Bounds(first).apart(Bounds(second))) return {};
  const std::vector<Part> ones = parts_of(first), others = parts_of(second);
  for (const Part& a : ones) {
    for (const Part& b : others) search.pair(a, b);
  }
  return search.take();
}

}  // namespace

std::vector<Crossing> crossings(const Curve& first, const Curve& second) {
  const auto at_end = [](const Curve& curve, double s) { return s < kSharedEnd || s > curve.length() - kSharedEnd; };
  return found_by(Search([&](const Crossing& c) { return at_end(first, c.s_first) && at_end(second, c.s_second); }),
                  first, second);
}

std::vector<Crossing> meetings(const Curve& first, const Curve& second) {
  return found_by(Search([](const Crossing&) { return false; }), first, second);
}

std::vector<Crossing> self_crossings(const Curve& curve) {
  const bool closed = distance(curve.start(), curve.end()) < kSharedEnd;
  Search search([&](const Crossing& c) {
    const double apart = std::abs(c.s_second - c.s_first);
    return apart < kSharedEnd || (closed && curve.length() - apart < kSharedEnd);
  });
  const std::vector<Part> parts = parts_of(curve);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      const bool joined = (j == i + 1 && parted_at_joint(parts[i], parts[j])) ||
                          (j + 1 == parts.size() && i == 0 && closed && parted_at_joint(parts[j], parts[i]));
      if (!joined) search.pair(parts[i], parts[j]);
    }
  }
  return search.take();
}

}  // namespace toile
