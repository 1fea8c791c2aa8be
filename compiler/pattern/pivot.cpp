// Darts moved about their tips: the piece is cut from the tip to the new place, and what lies between there and the
// dart is turned until the dart has lost the share that opens at the new place.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/diag/nearest.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kTouch = 1e-6;  // [m]

CutDart* find_dart(const DraftPivot& pivot, DrawnPiece& drawn, Findings& findings) {
  std::vector<std::string> names;
  for (CutDart& dart : drawn.darts) {
    if (dart.name == pivot.dart && !dart.closed && !dart.edge.empty()) return &dart;
    if (!dart.closed && !dart.edge.empty()) names.push_back(dart.name);
  }
  findings.error("E0330", fmt::format("there is no dart {} on an edge to be moved", quoted(pivot.dart)),
                 {{pivot.written, "unknown dart"}}, suggestion(pivot.dart, names));
  return nullptr;
}

double signed_angle(Vec2 from, Vec2 to) {
  return std::atan2(cross(from, to), dot(from, to));
}

void turn(PieceEdge& edge, double angle, Vec2 about) {
  edge.curve = edge.curve.rotated(angle, about);
}

Vec2 turned(Vec2 point, double angle, Vec2 about) {
  const Vec2 d = point - about;
  return about + std::cos(angle) * d + std::sin(angle) * perpendicular(d);
}

class Pivot {
 public:
  Pivot(const DraftPiece& draft, const DraftPivot& pivot, CutDart& dart, DrawnPiece& drawn)
      : draft_(draft), pivot_(pivot), dart_(dart), drawn_(drawn), loop_(drawn.piece.edges) {
    left_ = find_leg(drawn, dart.name + ".left").value().edge;
    const auto size = loop_.size();
    tip_ = dart.tip;
    opening_ = signed_angle(loop_[(left_ + 1) % size].curve.end() - tip_, loop_[left_].curve.start() - tip_);
  }

  bool run(Findings& findings) {
    const std::optional<EdgePlace> place = find_place(drawn_, pivot_.edge, pivot_.at);
    if (!place || place->loop != 0) {
      findings.error("E0330", fmt::format("dart {} cannot be moved there", quoted(pivot_.dart)),
                     {{pivot_.written, place ? "on the edge of a hole" : "in the mouth of a dart"}},
                     "name a place of the outline that no dart takes up");
      return false;
    }
    target_ = place->edge;
    at_ = place->s;
    goal_ = loop_[target_].curve.at(at_);
    if (!way_is_free(findings)) return false;
    if (pivot_.share < 1 && !(dart_.draft->short_of_tip > 0)) {
      findings.error("E0330", fmt::format("dart {} would be two darts with one tip", quoted(pivot_.dart)),
                     {{dart_.draft->written, "the dart"}, {pivot_.written, "moves a share of it"}},
                     "let its legs end before the tip: `{ ..., short 2cm }`");
      return false;
    }
    split_target();
    turn_sector();
    return true;
  }

 private:
  int size() const { return static_cast<int>(loop_.size()); }

  bool way_is_free(Findings& findings) const {
    const Curve way = line(tip_, goal_);
    const double length = way.length();
    const PieceEdge* obstacle = nullptr;
    if (length < 1e-3 || !in_cloth(drawn_, 0.5 * (tip_ + goal_))) obstacle = &loop_[target_];
    for (int i = 0; i < drawn_.piece.edge_count() && obstacle == nullptr; ++i) {
      const PieceEdge& edge = drawn_.piece.edge(i);
      if (i == left_ || i == (left_ + 1) % size()) continue;
      for (const Crossing& crossing : crossings(way, edge.curve)) {
        if (crossing.s_first < length - kTouch) obstacle = &edge;
      }
    }
    if (obstacle == nullptr) return true;
    findings.error(
        "E0330", fmt::format("the way from the tip of dart {} to its new place leaves the cloth", quoted(pivot_.dart)),
        {{pivot_.written, fmt::format("{} from the tip", in_cm(length))},
         {obstacle->written, "in the way"},
         {dart_.draft->written, "the dart"}},
        "a dart moves to a place that is seen straight from its tip");
    return false;
  }

  // The target's edge in two, so that the new mouth lies between edges.
  void split_target() {
    if (at_ < kTouch) {
      target_ = (target_ + size() - 1) % size();
    } else if (at_ < loop_[target_].curve.length() - kTouch) {
      divide_edge(drawn_, {0, target_, at_});
      if (left_ > target_) ++left_;
    }
  }

  // The edges that follow one, up to another, in the order of the loop.
  std::vector<PieceEdge> edges_between(int after, int last) const {
    std::vector<PieceEdge> edges;
    for (int i = (after + 1) % size(); edges.size() < loop_.size(); i = (i + 1) % size()) {
      edges.push_back(loop_[i]);
      if (i == last) break;
    }
    return edges;
  }

  bool has_fold(const std::vector<PieceEdge>& edges) const {
    return std::any_of(edges.begin(), edges.end(), [&](const PieceEdge& e) { return draft_.fold == e.name; });
  }
  static double length_of(const std::vector<PieceEdge>& edges) {
    double sum = 0;
    for (const PieceEdge& edge : edges) sum += edge.curve.length();
    return sum;
  }

  void turn_sector() {
    const int right = (left_ + 1) % size();
    std::vector<PieceEdge> ahead = edges_between(right, target_);                           // from the dart to the goal
    std::vector<PieceEdge> behind = edges_between(target_, (left_ + size() - 1) % size());  // and on to the dart
    PieceEdge left = loop_[left_], second = loop_[right];
    const double angle = pivot_.share * opening_;
    const bool ahead_turns = !has_fold(ahead) && (has_fold(behind) || length_of(ahead) <= length_of(behind));
    Vec2 goal_ahead = goal_, goal_behind = goal_;
    if (ahead_turns) {
      turn_all(ahead, angle);
      turn(second, angle, tip_);
      goal_ahead = turned(goal_, angle, tip_);
    } else {
      turn_all(behind, -angle);
      turn(left, -angle, tip_);
      goal_behind = turned(goal_, -angle, tip_);
    }
    loop_.clear();
    append(ahead);
    loop_.push_back(leg(".left", goal_ahead, tip_));
    loop_.push_back(leg(".right", tip_, goal_behind));
    append(behind);
    const CutDart moved{dart_.draft, pivot_.name, tip_, pivot_.edge, {pivot_.at, pivot_.at}, false};
    if (pivot_.share < 1) {
      loop_.push_back(std::move(left));
      loop_.push_back(std::move(second));
    } else {
      dart_.closed = true;
    }
    drawn_.darts.push_back(moved);  // ends the life of dart_
  }

  PieceEdge leg(const char* name, Vec2 from, Vec2 to) const {
    return {pivot_.name + name, Side::Drawn, 0, true, line(from, to), 0, pivot_.written};
  }

  void append(std::vector<PieceEdge>& edges) {
    for (PieceEdge& edge : edges) loop_.push_back(std::move(edge));
  }

  // Edges with all that lies between them and the tip: holes, other darts' tips, marks.
  void turn_all(std::vector<PieceEdge>& edges, double angle) {
    std::vector<Curve> rim{line(tip_, edges.front().curve.start())};
    for (const PieceEdge& edge : edges) rim.push_back(edge.curve);
    rim.push_back(line(edges.back().curve.end(), tip_));
    const Region sector(join(rim));
    for (PieceEdge& edge : edges) turn(edge, angle, tip_);
    for (auto* inner : {&drawn_.piece.holes, &drawn_.piece.lines}) {
      for (std::vector<PieceEdge>& each : *inner) {
        if (!sector.contains(each.front().curve.at(each.front().curve.length() / 2))) continue;
        for (PieceEdge& edge : each) turn(edge, angle, tip_);
      }
    }
    for (CutDart& dart : drawn_.darts) {
      if (&dart == &dart_ || dart.closed) continue;
      const bool own = std::any_of(edges.begin(), edges.end(),
                                   [&](const PieceEdge& e) { return e.is_dart_leg && e.name == dart.name + ".left"; });
      if (own || (dart.edge.empty() && sector.contains(dart.tip))) dart.tip = turned(dart.tip, angle, tip_);
    }
    for (LineMark& mark : drawn_.piece.marks) {
      if (sector.contains(mark.curve.at(mark.curve.length() / 2))) mark.curve = mark.curve.rotated(angle, tip_);
    }
    for (PointMark& spot : drawn_.piece.spots) {
      if (!sector.contains(spot.at)) continue;
      spot.at = turned(spot.at, angle, tip_);
      spot.angle += angle;
    }
  }

  const DraftPiece& draft_;
  const DraftPivot& pivot_;
  CutDart& dart_;
  DrawnPiece& drawn_;
  std::vector<PieceEdge>& loop_;
  int left_ = 0, target_ = 0;
  double at_ = 0, opening_ = 0;
  Vec2 tip_, goal_;
};

bool crosses_itself(const DraftPivot& pivot, const DrawnPiece& drawn, Findings& findings) {
  const std::vector<Crossing> found = self_crossings(whole_outline(drawn.piece.edges));
  const bool overlaps = std::any_of(found.begin(), found.end(), [&](const Crossing& crossing) {
    return std::none_of(drawn.darts.begin(), drawn.darts.end(),
                        [&](const CutDart& dart) { return distance(dart.tip, crossing.point) < kTouch; });
  });
  if (!overlaps) return false;
  findings.error("E0330", fmt::format("with dart {} moved there the piece would overlap itself", quoted(pivot.dart)),
                 {{pivot.written, ""}});
  return true;
}

}  // namespace

bool pivot_darts(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings) {
  const int before = findings.errors();
  for (const DraftPivot& pivot : draft.pivots) {
    CutDart* dart = find_dart(pivot, drawn, findings);
    if (dart == nullptr || !Pivot(draft, pivot, *dart, drawn).run(findings)) break;
    if (crosses_itself(pivot, drawn, findings)) break;
  }
  return findings.errors() == before;
}

}  // namespace toile
