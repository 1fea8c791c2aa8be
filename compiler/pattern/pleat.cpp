// Pleats: edges divided where the cloth is folded, the parts below left out of the sewn line, and the lines of the
// folds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/pattern/cutting.hpp"

namespace toile {
namespace {

constexpr double kMeets = 1e-6;  // [m]

// One turn of the cloth. The fold points forwards along the edge as drawn, or backwards: at the fold the uppermost
// layer turns back, at the inner fold (one depth on) forwards again, and at the placement line it is uppermost again.
struct Turn {
  double fold = 0;  // [m] along the edge as drawn
  double sign = 1;
};

Vec2 way_of(Press press) {
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

class PleatCutter {
 public:
  PleatCutter(const DraftPiece& draft, const DraftPleat& pleat, DrawnPiece& drawn, Findings& findings)
      : draft_(draft), pleat_(pleat), drawn_(drawn), findings_(findings) {}

  // The edge at the pleat's other end is folded, too, where it is sewn or worn.
  bool cut(bool other_end_joined) {
    const DraftEdge* edge = find_edge(draft_, pleat_.place.edge, pleat_.written, findings_);
    if (edge == nullptr) return false;
    const std::optional<EdgePlace> place = find_place(drawn_, pleat_.place.edge, pleat_.place.at);
    if (!place) return fail("stands in the mouth of a dart", {});
    if (pleat_.style == PleatStyle::Box && pleat_.depth > pleat_.width / 2 + kMeets) {
      return fail("is deeper than half its width: its layers would lie over each other",
                  fmt::format("make it at least {} wide, or less deep", in_cm(2 * pleat_.depth)));
    }
    const std::vector<Turn> turns = turns_at(pleat_.place.at, sign_at(*place));
    add_lines(turns, *place);
    if (!fold_edge(pleat_.place.edge, turns)) return false;
    if (!pleat_.other_end) return true;
    std::vector<Turn> others;
    for (const Turn& turn : turns) others.push_back({other_at(turn.fold), turn.sign * other_sign_});
    if (other_end_joined) return fold_edge(pleat_.other_end->edge, others);
    for (const Turn& turn : others) add_notches(pleat_.other_end->edge, turn);
    return true;
  }

 private:
  bool fail(const std::string& what, const std::string& help) {
    std::vector<Label> labels{{pleat_.written, fmt::format("{} deep", in_cm(pleat_.depth))}};
    if (const DraftEdge* edge = drafted_edge(draft_, pleat_.place.edge)) labels.push_back({edge->written, "its edge"});
    findings_.error("E0333", fmt::format("pleat {} {}", quoted(pleat_.name), what), std::move(labels), help);
    return false;
  }

  // Says which stretch of the edge it takes, and whether that is beyond an end or in the way of something.
  bool no_room(const std::string& edge, const Turn& turn) {
    const double d = turn.sign * pleat_.depth;
    const double from = std::min(turn.fold - d, turn.fold + 2 * d), to = std::max(turn.fold - d, turn.fold + 2 * d);
    const DraftEdge* drafted = drafted_edge(draft_, edge);
    const double whole = drafted == nullptr ? to : drafted->curve.length();
    const bool beyond = from < -kMeets || to > whole + kMeets;
    return fail(
        fmt::format("has no room on edge {}: it takes {} to {} of it, {}", quoted(edge), in_cm(from), in_cm(to),
                    beyond ? fmt::format("and that is {} long", in_cm(whole))
                           : std::string("where a dart or another pleat stands")),
        fmt::format(
            "its fold is at {}: it turns the cloth from there to {} under, which comes to lie below that up to {}; "
            "move it, or make it less deep",
            in_cm(turn.fold), in_cm(turn.fold + 2 * d), in_cm(turn.fold - d)));
  }

  Vec2 drawn_tangent(const EdgePlace& place) const {
    const PieceEdge& edge = drawn_.loop(place.loop)[place.edge];
    const Vec2 t = edge.curve.tangent(place.s);
    return edge.against_drawing ? -t : t;
  }

  // Which way the fold of a knife pleat points: as it is pressed, else away from the centre.
  double sign_at(const EdgePlace& place) const {
    if (pleat_.style != PleatStyle::Knife) return 1;
    double centre = 0;
    for (const PieceEdge& edge : drawn_.piece.edges) {
      if (draft_.fold == edge.name) centre = edge.curve.at(edge.curve.length() / 2).x;
    }
    const double x = drawn_.loop(place.loop)[place.edge].curve.at(place.s).x;
    const Vec2 way = pleat_.pressed ? way_of(*pleat_.pressed) : Vec2{x < centre ? -1.0 : 1.0, 0};
    return dot(drawn_tangent(place), way) >= 0 ? 1 : -1;
  }

  std::vector<Turn> turns_at(double at, double sign) const {
    switch (pleat_.style) {
      case PleatStyle::Box:
        return {{at - pleat_.width / 2, -1}, {at + pleat_.width / 2, 1}};
      case PleatStyle::Inverted:
        return {{at - 2 * pleat_.depth, 1}, {at + 2 * pleat_.depth, -1}};
      case PleatStyle::Knife:
        break;
    }
    return {{at, sign}};
  }

  // The part of the edge between two places; nothing where it is cut, divided or ends.
  std::optional<EdgePlace> part_between(const std::string& edge, double a, double b) const {
    for (int l = 0; l < drawn_.loop_count(); ++l) {
      const std::vector<PieceEdge>& loop = drawn_.loop(l);
      for (int i = 0; i < static_cast<int>(loop.size()); ++i) {
        const PieceEdge& part = loop[i];
        const bool same = part.name == edge && !part.is_dart_leg &&
                          std::abs(part.drawn.from - std::min(a, b)) < kMeets &&
                          std::abs(part.drawn.to - std::max(a, b)) < kMeets;
        if (same) return EdgePlace{l, i, 0};
      }
    }
    return std::nullopt;
  }

  bool fold_edge(const std::string& edge, const std::vector<Turn>& turns) {
    for (const Turn& turn : turns) {
      const double d = turn.sign * pleat_.depth;
      for (const double at : {turn.fold - d, turn.fold, turn.fold + d, turn.fold + 2 * d}) divide_at(drawn_, edge, at);
    }
    for (const Turn& turn : turns) {
      const double d = turn.sign * pleat_.depth;
      const auto face = part_between(edge, turn.fold - d, turn.fold);
      const auto under = part_between(edge, turn.fold, turn.fold + d);
      const auto back = part_between(edge, turn.fold + d, turn.fold + 2 * d);
      const auto taken = [&](const std::optional<EdgePlace>& part) {
        return !part || drawn_.loop(part->loop)[part->edge].folded_under;
      };
      if (taken(face) || taken(under) || taken(back)) {
        return no_room(edge, turn);
      }
      for (const auto& part : {under, back}) drawn_.loop(part->loop)[part->edge].folded_under = true;
      drawn_.turns.push_back({pleat_.name, edge, turn.fold, turn.fold + d, pleat_.written});
      add_notches(edge, turn);
    }
    return true;
  }

  void add_notches(const std::string& edge, const Turn& turn) {
    for (const double at : {turn.fold, turn.fold + 2 * turn.sign * pleat_.depth}) {
      drawn_.fold_notches.push_back({edge, at, pleat_.written});
    }
  }

  // Along the edge at the other end, the same way as seen in the drawing.
  double other_at(double fold) {
    const DraftPlace& end = *pleat_.other_end;
    return end.at + other_sign_ * (fold - pleat_.place.at);
  }

  void add_lines(const std::vector<Turn>& turns, const EdgePlace& place) {
    if (pleat_.other_end) {
      const auto other = find_place(drawn_, pleat_.other_end->edge, pleat_.other_end->at);
      if (other) other_sign_ = dot(drawn_tangent(*other), drawn_tangent(place)) >= 0 ? 1 : -1;
    }
    for (const Turn& turn : turns) {
      const double d = turn.sign * pleat_.depth;
      add_line(turn.fold, LineMark::Kind::Fold, place);
      add_line(turn.fold + d, LineMark::Kind::InnerFold, place);
      add_line(turn.fold + 2 * d, LineMark::Kind::Placement, place);
    }
  }

  void add_line(double at, LineMark::Kind kind, const EdgePlace& middle) {
    const auto from = find_place(drawn_, pleat_.place.edge, at);
    if (!from) return;
    const Vec2 start = point_at(*from);
    const Vec2 inwards = perpendicular(drawn_.loop(middle.loop)[middle.edge].curve.tangent(middle.s));
    const auto to =
        pleat_.other_end ? find_place(drawn_, pleat_.other_end->edge, other_at(at)) : across(start, inwards);
    if (!to || distance(start, point_at(*to)) < kMeets) return;
    const Vec2 end = point_at(*to);
    drawn_.piece.marks.push_back({kind, line(start, end), pleat_.written});
    // A crease ends at a node of the edge opposite.
    const PieceEdge& opposite = drawn_.loop(to->loop)[to->edge];
    if (kind != LineMark::Kind::Placement && !opposite.is_dart_leg) {
      drawn_.crease_ends.push_back({opposite.name, drawn_place(drawn_, *to)});
    }
    if (pleat_.stitched > 0 && kind == LineMark::Kind::Fold) {
      const double along = std::min(pleat_.stitched, distance(start, end));
      const Vec2 tip = start + along / distance(start, end) * (end - start);
      drawn_.piece.marks.push_back({LineMark::Kind::Line, line(start, tip), pleat_.written});
    }
  }

  Vec2 point_at(const EdgePlace& place) const { return drawn_.loop(place.loop)[place.edge].curve.at(place.s); }

  // Straight into the piece, up to the edge that lies opposite.
  std::optional<EdgePlace> across(Vec2 start, Vec2 inwards) const {
    constexpr double kFar = 100;  // [m] no piece is larger
    const Curve ray = line(start, start + kFar * inwards);
    double nearest = kFar;
    std::optional<EdgePlace> met;
    for (int l = 0; l < drawn_.closed_count(); ++l) {
      for (int i = 0; i < static_cast<int>(drawn_.loop(l).size()); ++i) {
        for (const Crossing& crossing : crossings(ray, drawn_.loop(l)[i].curve)) {
          if (crossing.s_first < 1e-4 || crossing.s_first >= nearest) continue;
          nearest = crossing.s_first;
          met = EdgePlace{l, i, crossing.s_second};
        }
      }
    }
    return met;
  }

  const DraftPiece& draft_;
  const DraftPleat& pleat_;
  DrawnPiece& drawn_;
  Findings& findings_;
  double other_sign_ = 1;
};

}  // namespace

bool cut_pleats(const DraftPiece& draft, const PieceUse& use, DrawnPiece& drawn, Findings& findings) {
  const int before = findings.errors();
  for (const DraftPleat& pleat : draft.pleats) {
    if (draft.fold == pleat.place.edge || (pleat.other_end && draft.fold == pleat.other_end->edge)) {
      findings.error("E0315",
                     fmt::format("pleat {} stands on the fold of piece {}", quoted(pleat.name), quoted(draft.name)),
                     {{pleat.written, "the pleat"}, {draft.fold_written, "the fold is no edge of the unfolded piece"}});
      continue;
    }
    const bool joined = pleat.other_end && use.joined.contains(pleat.other_end->edge);
    PleatCutter(draft, pleat, drawn, findings).cut(joined);
  }
  for (const DraftPlace& end : drawn.crease_ends) {
    const bool is_folded =
        std::any_of(drawn.turns.begin(), drawn.turns.end(), [&](const CutTurn& turn) { return turn.edge == end.edge; });
    if (!is_folded) divide_at(drawn, end.edge, end.at);
  }
  return findings.errors() == before;
}

}  // namespace toile
