// Darts cut into the drawn loops: wedges at the edges, and darts inside the piece as holes with four corners.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kSame = 1e-6;  // [m] places nearer than this along an edge are one

// A dart whose place is known. Arc lengths run as the loop does. A dart inside the piece has two tips and no edge:
// `from` lies on the left of the way from the other tip to the tip.
struct Wedge {
  const DraftDart* draft = nullptr;
  EdgePlace edge;  // before cutting
  double begin = 0, end = 0;
  Vec2 from, to, tip, other_tip;

  bool inside() const { return draft->edge.empty(); }
  // Its sides, from one end of the mouth to the other.
  std::vector<Curve> sides() const {
    if (inside()) return {line(other_tip, from), line(from, tip), line(tip, to), line(to, other_tip)};
    return {line(from, tip), line(tip, to)};
  }
  // The same, of a dart on an edge, but for the very mouth: there they meet that edge.
  std::vector<Curve> sides_off_mouth() const {
    constexpr double kOff = 1e-4;  // [m]
    const auto off = [&](Vec2 mouth) { return mouth + std::min(kOff / distance(mouth, tip), 0.25) * (tip - mouth); };
    return {line(off(from), tip), line(tip, off(to))};
  }
};

std::string described(const DraftDart& dart) {
  return fmt::format("dart {}", quoted(dart.name));
}

double depth_of(const Wedge& wedge) {
  return wedge.inside() ? distance(wedge.tip, wedge.other_tip) : distance(0.5 * (wedge.from + wedge.to), wedge.tip);
}

bool sizes_are_sound(const DraftDart& dart, double depth, Findings& findings) {
  if (dart.width > 0 && depth > 0 && dart.short_of_tip >= 0 && dart.short_of_tip < depth) return true;
  const std::string found = fmt::format("{} wide, {} deep", in_cm(dart.width), in_cm(depth));
  if (dart.short_of_tip > 0 && depth > 0) {
    findings.error("E0310", fmt::format("{} ends before it begins", described(dart)),
                   {{dart.written, fmt::format("{}, and short of its tip by {}", found, in_cm(dart.short_of_tip))}});
  } else {
    findings.error("E0310", fmt::format("{} needs a width and a depth", described(dart)), {{dart.written, found}});
  }
  return false;
}

std::optional<Wedge> place_inside(const DraftDart& dart, Findings& findings) {
  const Vec2 way = dart.inside.to - dart.inside.from;
  const double depth = norm(way);
  if (!sizes_are_sound(dart, depth, findings)) return std::nullopt;
  if (!(dart.widest > kSame) || !(dart.widest < depth - kSame)) {
    findings.error("E0310", fmt::format("{} is widest beyond its ends", described(dart)),
                   {{dart.written, fmt::format("at {} of {}", in_cm(dart.widest), in_cm(depth))}});
    return std::nullopt;
  }
  const Vec2 middle = dart.inside.from + dart.widest / depth * way;
  const Vec2 half = dart.width / 2 / depth * perpendicular(way);
  return Wedge{&dart, {}, 0, 0, middle + half, middle - half, dart.inside.to, dart.inside.from};
}

std::optional<Wedge> place_dart(const DraftPiece& draft, const DrawnPiece& drawn, const DraftDart& dart,
                                Findings& findings) {
  if (dart.edge.empty()) return place_inside(dart, findings);
  const DraftEdge* host = find_edge(draft, dart.edge, dart.written, findings);
  if (host == nullptr) return std::nullopt;
  if (draft.fold && dart.edge == *draft.fold) {
    findings.error("E0315", fmt::format("{} stands on the fold of piece {}", described(dart), quoted(draft.name)),
                   {{dart.written, "the dart"}, {draft.fold_written, "the fold is no edge of the unfolded piece"}});
    return std::nullopt;
  }
  if (!dart.tip && !sizes_are_sound(dart, dart.depth, findings)) return std::nullopt;
  const EdgePlace edge = find_place(drawn, dart.edge, std::clamp(dart.at, 0.0, host->curve.length())).value();
  const Curve& curve = drawn.loop(edge.loop)[edge.edge].curve;
  const double length = curve.length();
  const double begin = edge.s - dart.width / 2, end = edge.s + dart.width / 2;
  if (dart.width > length - kSame || !(begin > -kSame) || !(end < length + kSame)) {
    const std::string problem = dart.width > length - kSame
                                    ? fmt::format("{} wide on an edge of {}", in_cm(dart.width), in_cm(length))
                                    : fmt::format("its mouth runs from {} to {} of {}", in_cm(dart.at - dart.width / 2),
                                                  in_cm(dart.at + dart.width / 2), in_cm(length));
    findings.error("E0310", fmt::format("{} is wider than its place on edge {}", described(dart), quoted(dart.edge)),
                   {{dart.written, problem}, {host->written, in_cm(length) + " long"}},
                   "move it along the edge, or make it narrower");
    return std::nullopt;
  }
  Wedge wedge{&dart, edge, std::max(begin, 0.0), std::min(end, length), {}, {}, {}, {}};
  wedge.from = curve.at(wedge.begin);
  wedge.to = curve.at(wedge.end);
  const Vec2 mouth = wedge.to - wedge.from;
  if (norm(mouth) < kSame) {
    findings.error("E0310", fmt::format("{} has no mouth: its edge turns back there", described(dart)),
                   {{dart.written, ""}, {host->written, ""}});
    return std::nullopt;
  }
  wedge.tip = dart.tip.value_or(0.5 * (wedge.from + wedge.to) + dart.depth * perpendicular(mouth) / norm(mouth));
  if (dart.tip && !sizes_are_sound(dart, depth_of(wedge), findings)) return std::nullopt;
  return wedge;
}

// How deep the piece is below the middle of the mouth [m], up to the tip.
double room_for(const DrawnPiece& drawn, const Wedge& wedge) {
  const Vec2 middle = 0.5 * (wedge.from + wedge.to);
  const Curve axis = line(wedge.inside() ? wedge.other_tip : middle, wedge.tip);
  double room = axis.length();
  const int own = wedge.inside() ? -1 : drawn.number(wedge.edge.loop, wedge.edge.edge);
  for (int i = 0; i < drawn.piece.edge_count(); ++i) {
    for (const Crossing& crossing : crossings(axis, drawn.piece.edge(i).curve)) {
      const bool own_mouth = i == own && crossing.s_second > wedge.begin && crossing.s_second < wedge.end;
      if (!own_mouth) room = std::min(room, crossing.s_first);
    }
  }
  return room;
}

// The edge that a side of the dart crosses, other than in its own mouth.
const PieceEdge* crossed_edge(const DrawnPiece& drawn, const Wedge& wedge) {
  const int own_edge = wedge.inside() ? -1 : drawn.number(wedge.edge.loop, wedge.edge.edge);
  for (int i = 0; i < drawn.piece.edge_count(); ++i) {
    const PieceEdge& edge = drawn.piece.edge(i);
    const double length = edge.curve.length();
    for (const Curve& side : i == own_edge ? wedge.sides_off_mouth() : wedge.sides()) {
      for (const Crossing& crossing : crossings(side, edge.curve)) {
        const bool at_mouth = !wedge.inside() && (crossing.s_first < kSame || crossing.s_first > side.length() - kSame);
        const bool own =
            i == own_edge && crossing.s_second > wedge.begin - kSame && crossing.s_second < wedge.end + kSame;
        if (own || (at_mouth && (crossing.s_second < kSame || crossing.s_second > length - kSame))) continue;
        return &edge;
      }
    }
  }
  return nullptr;
}

// A dart keeps clear of all edges but its mouth.
bool fits(const DraftPiece& draft, const DrawnPiece& drawn, const Wedge& wedge, Findings& findings) {
  const DraftDart& dart = *wedge.draft;
  const double room = room_for(drawn, wedge), depth = depth_of(wedge);
  // From its mouth a dart leads into the cloth; a tip of its own may lie anywhere.
  const bool has_own_tip = wedge.inside() || dart.tip;
  if (room < depth - kSame || (has_own_tip && !in_cloth(drawn, wedge.tip))) {
    findings.error("E0311", fmt::format("{} is deeper than piece {} there", described(dart), quoted(draft.name)),
                   {{dart.written, fmt::format("{} deep, where the piece is {} deep", in_cm(depth), in_cm(room))},
                    {draft.written, "the piece"}},
                   "make it less deep, or move it");
    return false;
  }
  if (const PieceEdge* edge = crossed_edge(drawn, wedge)) {
    findings.error(
        "E0311", fmt::format("{} crosses edge {} of piece {}", described(dart), quoted(edge->name), quoted(draft.name)),
        {{dart.written, in_cm(depth) + " deep"}, {edge->written, "crossed by a leg of the dart"}},
        "make it less deep or narrower, or move it");
    return false;
  }
  return true;
}

bool overlap(const Wedge& a, const Wedge& b) {
  const bool one_edge = !a.inside() && !b.inside() && a.edge.loop == b.edge.loop && a.edge.edge == b.edge.edge;
  if (one_edge && a.begin < b.end - kSame && b.begin < a.end - kSame) return true;
  // Darts that aim at one point and end before it keep clear of each other there.
  const bool aim_at_one = distance(a.tip, b.tip) < kSame;
  for (const Curve& side : a.sides()) {
    for (const Curve& other : b.sides()) {
      const std::vector<Crossing> found = crossings(side, other);
      if (std::any_of(found.begin(), found.end(), [&](const Crossing& crossing) {
            return !aim_at_one || distance(crossing.point, a.tip) > kSame;
          })) {
        return true;
      }
    }
  }
  return aim_at_one && a.draft->short_of_tip == 0 && b.draft->short_of_tip == 0;
}

std::vector<Wedge> place_darts(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings) {
  std::vector<Wedge> wedges;
  for (const DraftDart& dart : draft.darts) {
    const std::optional<Wedge> wedge = place_dart(draft, drawn, dart, findings);
    if (!wedge || !fits(draft, drawn, *wedge, findings)) continue;
    for (const Wedge& other : wedges) {
      if (!overlap(*wedge, other)) continue;
      findings.error("E0312", fmt::format("{} and {} overlap", described(*other.draft), described(dart)),
                     {{dart.written, "this dart"}, {other.draft->written, "reaches into this one"}},
                     "move them apart, or make them narrower");
      break;
    }
    wedges.push_back(*wedge);
  }
  return wedges;
}

PieceEdge leg(const Wedge& wedge, const char* name, Curve curve) {
  return {wedge.draft->name + name, Side::Drawn, 0, true, std::move(curve), 0, wedge.draft->written};
}

void cut_wedge(const Wedge& wedge, DrawnPiece& drawn) {
  std::vector<PieceEdge>& loop = drawn.loop(wedge.edge.loop);
  const int at = wedge.edge.edge;
  const bool as_drawn = !drawn.loop(wedge.edge.loop)[at].against_drawing;
  const double a = drawn_place(drawn, {wedge.edge.loop, at, wedge.begin});
  const double b = drawn_place(drawn, {wedge.edge.loop, at, wedge.end});
  drawn.darts.push_back(
      {wedge.draft, wedge.draft->name, wedge.tip, wedge.draft->edge, {std::min(a, b), std::max(a, b)}, false});
  const PieceEdge host = loop[at];
  const double length = host.curve.length();
  std::vector<PieceEdge> parts;
  const auto keep = [&](double from, double to, DrawnSpan span) {
    if (to - from < kSame) return;
    PieceEdge& part = parts.emplace_back(host);
    part.curve = host.curve.part(from, to);
    part.drawn = span;
  };
  keep(0, wedge.begin, as_drawn ? DrawnSpan{host.drawn.from, a} : DrawnSpan{a, host.drawn.to});
  parts.push_back(leg(wedge, ".left", line(wedge.from, wedge.tip)));
  parts.push_back(leg(wedge, ".right", line(wedge.tip, wedge.to)));
  keep(wedge.end, length, as_drawn ? DrawnSpan{b, host.drawn.to} : DrawnSpan{host.drawn.from, b});
  loop.erase(loop.begin() + at);
  loop.insert(loop.begin() + at, parts.begin(), parts.end());
}

// A hole, walked clockwise as holes are.
void cut_inside(const Wedge& wedge, DrawnPiece& drawn) {
  drawn.piece.holes.push_back(
      {leg(wedge, ".left", join({line(wedge.other_tip, wedge.from), line(wedge.from, wedge.tip)})),
       leg(wedge, ".right", join({line(wedge.tip, wedge.to), line(wedge.to, wedge.other_tip)}))});
  drawn.darts.push_back({wedge.draft, wedge.draft->name, wedge.tip, "", {}, false});
}

}  // namespace

bool cut_darts(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings) {
  const int before = findings.errors();
  std::vector<Wedge> wedges = place_darts(draft, drawn, findings);
  if (findings.errors() != before) return false;
  // From the last place of each loop to the first, so that places not yet cut stay what they are.
  std::stable_sort(wedges.begin(), wedges.end(), [](const Wedge& a, const Wedge& b) {
    return std::tuple(a.inside(), a.edge.loop, a.edge.edge, a.begin) >
           std::tuple(b.inside(), b.edge.loop, b.edge.edge, b.begin);
  });
  for (const Wedge& wedge : wedges) {
    if (!wedge.inside()) cut_wedge(wedge, drawn);
  }
  // Darts are told in the order in which the loops come by them, then those inside as they were written.
  std::reverse(drawn.darts.begin(), drawn.darts.end());
  for (const Wedge& wedge : wedges) {
    if (wedge.inside()) cut_inside(wedge, drawn);
  }
  return true;
}

}  // namespace toile
