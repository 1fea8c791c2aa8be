// Darts cut as wedges into the drawn outline, and notches set on what remains of their edges.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kSame = 1e-6;  // [m] places nearer than this along an edge are one

// A dart whose place on its edge is known. Arc lengths run as the outline does.
struct Wedge {
  const DraftDart* draft;
  int edge;  // in the outline before cutting
  double begin, end;
  Vec2 from, to, tip;
};

std::string described(const DraftDart& dart) {
  return fmt::format("dart {}", quoted(dart.name));
}

int outline_index(const DrawnPiece& drawn, int drafted) {
  const int n = static_cast<int>(drawn.piece.edges.size());
  return drawn.as_drawn ? drafted : n - 1 - drafted;
}

double outline_arc(const DrawnPiece& drawn, int edge, double at) {
  return drawn.as_drawn ? at : drawn.piece.edges[edge].curve.length() - at;
}

std::optional<Wedge> place_dart(const DraftPiece& draft, const DrawnPiece& drawn, const DraftDart& dart,
                                Findings& findings) {
  const std::optional<int> drafted = find_edge(draft, dart.edge, dart.written, findings);
  if (!drafted) return std::nullopt;
  const DraftEdge& host = draft.outline[*drafted];
  if (draft.fold && dart.edge == *draft.fold) {
    findings.error("E0315", fmt::format("{} stands on the fold of piece {}", described(dart), quoted(draft.name)),
                   {{dart.written, "the dart"}, {draft.fold_written, "the fold is no edge of the unfolded piece"}});
    return std::nullopt;
  }
  if (!(dart.width > 0) || !(dart.depth > 0)) {
    findings.error("E0310", fmt::format("{} needs a width and a depth", described(dart)),
                   {{dart.written, fmt::format("{} wide, {} deep", in_cm(dart.width), in_cm(dart.depth))}});
    return std::nullopt;
  }
  const int edge = outline_index(drawn, *drafted);
  const Curve& curve = drawn.piece.edges[edge].curve;
  const double length = curve.length(), middle = outline_arc(drawn, edge, dart.at);
  const double begin = middle - dart.width / 2, end = middle + dart.width / 2;
  if (dart.width > length - kSame || !(begin > -kSame) || !(end < length + kSame)) {
    const std::string problem = dart.width > length - kSame
                                    ? fmt::format("{} wide on an edge of {}", in_cm(dart.width), in_cm(length))
                                    : fmt::format("its mouth runs from {} to {} of {}", in_cm(dart.at - dart.width / 2),
                                                  in_cm(dart.at + dart.width / 2), in_cm(length));
    findings.error("E0310", fmt::format("{} is wider than its place on edge {}", described(dart), quoted(dart.edge)),
                   {{dart.written, problem}, {host.written, in_cm(length) + " long"}},
                   "move it along the edge, or make it narrower");
    return std::nullopt;
  }
  Wedge wedge{&dart, edge, std::max(begin, 0.0), std::min(end, length), {}, {}, {}};
  wedge.from = curve.at(wedge.begin);
  wedge.to = curve.at(wedge.end);
  const Vec2 mouth = wedge.to - wedge.from;
  if (norm(mouth) < kSame) {
    findings.error("E0310", fmt::format("{} has no mouth: its edge turns back there", described(dart)),
                   {{dart.written, ""}, {host.written, ""}});
    return std::nullopt;
  }
  wedge.tip = dart.tip.value_or(0.5 * (wedge.from + wedge.to) + dart.depth * perpendicular(mouth) / norm(mouth));
  return wedge;
}

// How deep the piece is below the middle of the mouth [m], up to `depth`.
double room_for(const DrawnPiece& drawn, const Wedge& wedge) {
  const Vec2 middle = 0.5 * (wedge.from + wedge.to);
  const Curve axis = line(middle, wedge.tip);
  double room = axis.length();
  for (int i = 0; i < static_cast<int>(drawn.piece.edges.size()); ++i) {
    for (const Crossing& crossing : crossings(axis, drawn.piece.edges[i].curve)) {
      const bool own_mouth = i == wedge.edge && crossing.s_second > wedge.begin && crossing.s_second < wedge.end;
      if (!own_mouth) room = std::min(room, crossing.s_first);
    }
  }
  return room;
}

// What of the outline a dart's legs must keep clear of: all edges but the mouth.
bool fits(const DraftPiece& draft, const DrawnPiece& drawn, const Region& region, const Wedge& wedge,
          Findings& findings) {
  const DraftDart& dart = *wedge.draft;
  const double room = room_for(drawn, wedge);
  const double depth = distance(0.5 * (wedge.from + wedge.to), wedge.tip);
  if (room < depth - kSame || !region.contains(wedge.tip)) {
    findings.error("E0311", fmt::format("{} is deeper than piece {} there", described(dart), quoted(draft.name)),
                   {{dart.written, fmt::format("{} deep, where the piece is {} deep", in_cm(dart.depth), in_cm(room))},
                    {draft.written, "the piece"}},
                   "make it less deep, or move it");
    return false;
  }
  for (int i = 0; i < static_cast<int>(drawn.piece.edges.size()); ++i) {
    const PieceEdge& edge = drawn.piece.edges[i];
    const double length = edge.curve.length();
    for (const Curve& leg : {line(wedge.from, wedge.tip), line(wedge.to, wedge.tip)}) {
      for (const Crossing& crossing : crossings(leg, edge.curve)) {
        const bool at_mouth = crossing.s_first < kSame;
        const bool own =
            i == wedge.edge && crossing.s_second > wedge.begin - kSame && crossing.s_second < wedge.end + kSame;
        if (at_mouth && (own || crossing.s_second < kSame || crossing.s_second > length - kSame)) continue;
        if (own) continue;
        findings.error(
            "E0311",
            fmt::format("{} crosses edge {} of piece {}", described(dart), quoted(edge.name), quoted(draft.name)),
            {{dart.written, in_cm(dart.depth) + " deep"}, {edge.written, "crossed by a leg of the dart"}},
            "make it less deep or narrower, or move it");
        return false;
      }
    }
  }
  return true;
}

bool overlap(const Wedge& a, const Wedge& b) {
  if (a.edge == b.edge && a.begin < b.end - kSame && b.begin < a.end - kSame) return true;
  for (const Curve& leg : {line(a.from, a.tip), line(a.to, a.tip)}) {
    for (const Curve& other : {line(b.from, b.tip), line(b.to, b.tip)}) {
      if (!crossings(leg, other).empty()) return true;
    }
  }
  return distance(a.tip, b.tip) < kSame;
}

std::vector<Wedge> place_darts(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings) {
  std::vector<Wedge> wedges;
  if (draft.darts.empty()) return wedges;
  const Region region(whole_outline(drawn.piece.edges));
  for (const DraftDart& dart : draft.darts) {
    const std::optional<Wedge> wedge = place_dart(draft, drawn, dart, findings);
    if (!wedge || !fits(draft, drawn, region, *wedge, findings)) continue;
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

// A stretch of an edge that the darts leave over, and where it went.
struct Remnant {
  int edge;
  double begin, end;  // on the edge before cutting
  int now;            // index after cutting
};

PieceEdge leg(const Wedge& wedge, const char* name, Vec2 from, Vec2 to) {
  return {wedge.draft->name + name, Side::Drawn, 0, true, line(from, to), 0, wedge.draft->written};
}

void add_wedge(const Wedge& wedge, Piece& piece) {
  const int left = static_cast<int>(piece.edges.size());
  piece.edges.push_back(leg(wedge, ".left", wedge.from, wedge.tip));
  piece.edges.push_back(leg(wedge, ".right", wedge.tip, wedge.to));
  piece.darts.push_back({wedge.draft->name, left, left + 1, wedge.tip, distance(wedge.from, wedge.to),
                         wedge.draft->depth, wedge.draft->written});
}

// Walks the outline and puts the legs of each dart in the place of its mouth. Parts are numbered as they were drawn.
std::vector<Remnant> split_edges(const std::vector<Wedge>& wedges, DrawnPiece& drawn) {
  std::vector<Remnant> remnants;
  Piece& piece = drawn.piece;
  const std::vector<PieceEdge> before = std::move(piece.edges);
  piece.edges.clear();
  for (int i = 0; i < static_cast<int>(before.size()); ++i) {
    const std::size_t first = remnants.size();
    const double length = before[i].curve.length();
    double reached = 0;
    const auto keep_until = [&](double s) {
      if (s - reached < kSame) return;
      remnants.push_back({i, reached, s, static_cast<int>(piece.edges.size())});
      piece.edges.push_back(before[i]);
      if (reached > 0 || s < length) piece.edges.back().curve = before[i].curve.part(reached, s);
    };
    for (const Wedge& wedge : wedges) {
      if (wedge.edge != i) continue;
      keep_until(wedge.begin);
      add_wedge(wedge, piece);
      reached = wedge.end;
    }
    keep_until(length);
    const std::size_t parts = remnants.size() - first;
    for (std::size_t k = 0; k < parts; ++k) {
      piece.edges[remnants[first + k].now].part = static_cast<int>(drawn.as_drawn ? k : parts - 1 - k);
    }
  }
  return remnants;
}

void set_notch(const DraftPiece& draft, const DraftNotch& notch, int drafted, double length,
               const std::vector<Remnant>& remnants, DrawnPiece& drawn, Findings& findings) {
  const int edge = drawn.as_drawn ? drafted : static_cast<int>(draft.outline.size()) - 1 - drafted;
  const double at = drawn.as_drawn ? notch.at : length - notch.at;
  for (const Remnant& remnant : remnants) {
    if (remnant.edge != edge || at < remnant.begin - kSame || at > remnant.end + kSame) continue;
    const double within = std::clamp(at - remnant.begin, 0.0, remnant.end - remnant.begin);
    drawn.piece.notches.push_back({remnant.now, within, notch.written});
    return;
  }
  const bool off = !(notch.at >= 0 && notch.at <= length);
  findings.error("E0313",
                 off ? fmt::format("a notch lies off edge {} of piece {}", quoted(notch.edge), quoted(draft.name))
                     : fmt::format("a notch lies in the mouth of a dart on edge {}", quoted(notch.edge)),
                 {{notch.written, "at " + in_cm(notch.at)}, {draft.outline[drafted].written, in_cm(length) + " long"}},
                 off ? "a notch stands between the ends of its edge" : "set it beside the dart");
}

}  // namespace

bool cut_darts_and_notches(const DraftPiece& draft, DrawnPiece& drawn, Findings& findings) {
  const int before = findings.errors();
  std::vector<Wedge> wedges = place_darts(draft, drawn, findings);
  if (findings.errors() != before) return false;
  std::sort(wedges.begin(), wedges.end(),
            [](const Wedge& a, const Wedge& b) { return a.edge != b.edge ? a.edge < b.edge : a.begin < b.begin; });
  const std::vector<Remnant> remnants = split_edges(wedges, drawn);
  for (const DraftNotch& notch : draft.notches) {
    const std::optional<int> drafted = find_edge(draft, notch.edge, notch.written, findings);
    if (!drafted) continue;
    if (draft.fold && notch.edge == *draft.fold) {
      findings.error("E0315", fmt::format("a notch stands on the fold of piece {}", quoted(draft.name)),
                     {{notch.written, "the notch"}, {draft.fold_written, "the fold is no edge of the unfolded piece"}});
      continue;
    }
    set_notch(draft, notch, *drafted, draft.outline[*drafted].curve.length(), remnants, drawn, findings);
  }
  return findings.errors() == before;
}

}  // namespace toile
