// Darts made ready to sew: legs that end before the tip, edges that run on smoothly once the dart is closed, and the
// side to which it is pressed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/curve/places.hpp"
#include "compiler/pattern/cutting.hpp"

namespace toile {
namespace {

constexpr double kNear = 1e-6;       // [m]
constexpr double kLegsAlike = 1e-5;  // [m] legs that differ less need no truing
constexpr double kReach = 2;         // of a dart's width that truing may take of its edge on either side

double angle_of(Vec2 v) {
  return std::atan2(v.y, v.x);
}

// A dart's two legs and its neighbours on the loop.
struct Legs {
  std::vector<PieceEdge>& loop;
  int left, right, before, after;

  Vec2 from() const { return loop[left].curve.start(); }
  Vec2 to() const { return loop[right].curve.end(); }
};

std::optional<Legs> legs_of(DrawnPiece& drawn, const CutDart& dart) {
  const std::optional<EdgePlace> left = find_leg(drawn, dart.name + ".left");
  if (!left || dart.edge.empty()) return std::nullopt;
  std::vector<PieceEdge>& loop = drawn.loop(left->loop);
  const int n = static_cast<int>(loop.size());
  return Legs{loop, left->edge, (left->edge + 1) % n, (left->edge + n - 1) % n, (left->edge + 2) % n};
}

void shorten(const Legs& legs, CutDart& dart) {
  const Vec2 a = legs.from() - dart.tip, b = legs.to() - dart.tip;
  const Vec2 way = a / norm(a) + b / norm(b);
  dart.tip = dart.tip + dart.draft->short_of_tip / norm(way) * way;
  legs.loop[legs.left].curve = line(legs.from(), dart.tip);
  legs.loop[legs.right].curve = line(dart.tip, legs.to());
}

// Two edges that run on into each other once a dart is closed: `turn` about the tip brings the second to the first.
struct Joint {
  PieceEdge& before;
  PieceEdge& after;
  Vec2 tip;
  double turn = 0;
  double reach = 0;  // [m] that it takes of each
};

Joint joint_of(PieceEdge& before, PieceEdge& after, Vec2 tip, double turn, double width) {
  const double reach = std::min({kReach * width, before.curve.length() / 2, after.curve.length() / 2});
  return {before, after, tip, turn, reach};
}

// From the edge before to the one after, over the closed dart.
Curve smooth_over(const Joint& joint) {
  const Curve on = joint.after.curve.rotated(joint.turn, joint.tip);
  const double s = joint.before.curve.length() - joint.reach;
  return tangent_curve(joint.before.curve.at(s), angle_of(joint.before.curve.tangent(s)), on.at(joint.reach),
                       angle_of(on.tangent(joint.reach)));
}

// Puts the smooth curve in the place of what it bridges: its parts up to `s` and from there on.
void replace(const Joint& joint, const Curve& smooth, double s) {
  const Curve first = smooth.part(0, s), second = smooth.part(s, smooth.length()).rotated(-joint.turn, joint.tip);
  joint.before.curve = join({joint.before.curve.part(0, joint.before.curve.length() - joint.reach), first});
  joint.after.curve = join({second, joint.after.curve.part(joint.reach, joint.after.curve.length())});
}

bool true_open_dart(const Legs& legs, const CutDart& dart) {
  const Vec2 a = legs.from() - dart.tip, b = legs.to() - dart.tip;
  const double turn = std::atan2(cross(b, a), dot(b, a));
  const Joint joint =
      joint_of(legs.loop[legs.before], legs.loop[legs.after], dart.tip, turn, distance(legs.from(), legs.to()));
  const Curve smooth = smooth_over(joint);
  const Vec2 beyond = dart.tip + (1.5 * std::max(norm(a), norm(b)) / norm(a)) * a;
  const std::vector<Crossing> met = intersections(smooth, line(dart.tip, beyond));
  if (met.empty() || met[0].s_first < kNear || met[0].s_first > smooth.length() - kNear) return false;
  replace(joint, smooth, met[0].s_first);
  legs.loop[legs.left].curve = line(legs.loop[legs.before].curve.end(), dart.tip);
  legs.loop[legs.right].curve = line(dart.tip, legs.loop[legs.after].curve.start());
  return true;
}

// Where a dart was that a pivot has closed, its edge has a corner.
void true_closed_dart(DrawnPiece& drawn, const CutDart& dart) {
  for (int l = 0; l < drawn.loop_count(); ++l) {
    std::vector<PieceEdge>& loop = drawn.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      PieceEdge &before = loop[i], &after = loop[(i + 1) % loop.size()];
      const double ends = before.against_drawing ? before.drawn.from : before.drawn.to;
      const double meets = before.against_drawing ? dart.mouth.to : dart.mouth.from;
      const bool joined =
          before.name == dart.edge && after.name == dart.edge && !before.is_dart_leg && !after.is_dart_leg;
      if (!joined || std::abs(ends - meets) > kNear) continue;
      const Joint joint = joint_of(before, after, dart.tip, 0, dart.mouth.to - dart.mouth.from);
      const Curve smooth = smooth_over(joint);
      replace(joint, smooth, smooth.length() / 2);
      return;
    }
  }
}

bool legs_differ(const Legs& legs) {
  return std::abs(legs.loop[legs.left].curve.length() - legs.loop[legs.right].curve.length()) > kLegsAlike;
}

Vec2 direction_of(Press press) {
  switch (press) {
    case Press::Left:
      return {-1, 0};
    case Press::Right:
      return {1, 0};
    case Press::Up:
      return {0, 1};
    default:
      return {0, -1};
  }
}

// Darts that run more across than down are pressed down, others towards the centre: the fold, or the line x = 0 in
// which copies are mirrored.
Vec2 usual_press(const DrawnPiece& drawn, const std::optional<std::string>& fold, Vec2 mouth, Vec2 tip) {
  const Vec2 axis = tip - mouth;
  if (std::abs(axis.x) > std::abs(axis.y)) return {0, -1};
  double centre = 0;
  for (const PieceEdge& edge : drawn.piece.edges) {
    if (fold && edge.name == *fold) centre = edge.curve.at(edge.curve.length() / 2).x;
  }
  return {mouth.x > centre ? -1.0 : 1.0, 0};
}

void press(const DraftPiece& draft, DrawnPiece& drawn, const CutDart& dart) {
  if (dart.draft->pressed == Press::Open) return;
  const auto left = find_leg(drawn, dart.name + ".left"), right = find_leg(drawn, dart.name + ".right");
  if (!left || !right) return;
  PieceEdge& first = drawn.loop(left->loop)[left->edge];
  PieceEdge& second = drawn.loop(right->loop)[right->edge];
  const Vec2 a = first.curve.at(dart.edge.empty() ? first.curve.length() / 2 : 0);
  const Vec2 b = second.curve.at(dart.edge.empty() ? second.curve.length() / 2 : second.curve.length());
  const Vec2 way = dart.draft->pressed ? direction_of(*dart.draft->pressed)
                                       : usual_press(drawn, draft.fold, 0.5 * (a + b), dart.tip);
  (dot(a - b, way) >= 0 ? first : second).pressed_onto = true;
}

}  // namespace

bool finish_darts(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings) {
  const int errors = findings.errors();
  for (CutDart& dart : drawn.darts) {
    const std::optional<Legs> legs = dart.closed ? std::nullopt : legs_of(drawn, dart);
    if (legs && dart.draft->short_of_tip > 0) shorten(*legs, dart);
  }
  for (const CutDart& dart : drawn.darts) {
    if (dart.closed) {
      if (dart.draft->trued) true_closed_dart(drawn, dart);
      continue;
    }
    const std::optional<Legs> legs = legs_of(drawn, dart);
    // A slit in a chart is redrawn when it is developed.
    if (legs && !draft.chart && (dart.draft->trued || legs_differ(*legs)) && !true_open_dart(*legs, dart)) {
      findings.error(
          "E0331", fmt::format("dart {} cannot be trued", quoted(dart.name)),
          {{dart.draft->written, fmt::format("legs of {} and {}", in_cm(legs->loop[legs->left].curve.length()),
                                             in_cm(legs->loop[legs->right].curve.length()))}},
          "turn its tip more square to the edge, or move it further from the edge's ends");
    }
    press(draft, drawn, dart);
  }
  return findings.errors() == errors;
}

}  // namespace toile
