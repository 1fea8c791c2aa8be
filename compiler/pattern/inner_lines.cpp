// Lines inside a piece that it can be sewn along.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/curve/places.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kTouches = 1e-6;  // [m]

const DraftInner* line_with(const DraftPiece& draft, const std::string& edge) {
  for (const DraftInner& line : draft.lines) {
    for (const DraftEdge& own : line.edges) {
      if (line.name + "." + own.name == edge) return &line;
    }
  }
  return nullptr;
}

bool is_end(const Curve& curve, double s) {
  return s < kTouches || s > curve.length() - kTouches;
}

class LineCheck {
 public:
  LineCheck(const DraftPiece& draft, const DrawnPiece& drawn, std::size_t line, Findings& findings)
      : draft_(draft),
        drawn_(drawn),
        written_(draft.lines[line]),
        edges_(drawn.piece.lines[line]),
        findings_(findings) {}

  bool run() {
    for (const PieceEdge& edge : edges_) {
      if (!(edge.curve.length() > kTouches)) {
        return fail(fmt::format("has an edge without length, {}", quoted(edge.name)), edge.written,
                    "ends where it starts", "");
      }
    }
    const Curve whole = whole_outline(edges_);
    const std::vector<Crossing> own = self_crossings(whole);
    if (!own.empty()) return fail("crosses itself", written_.written, at(own.front().point), "");
    for (int l = 0; l < drawn_.closed_count(); ++l) {
      for (const PieceEdge& rim : drawn_.loop(l)) {
        if (!keeps_clear(whole, rim)) return false;
      }
    }
    for (const PieceEdge& edge : edges_) {
      const Vec2 middle = edge.curve.at(edge.curve.length() / 2);
      if (!in_cloth(drawn_, middle)) {
        return fail("lies outside of the cloth", edge.written, at(middle), "a line is drawn on the cloth of its piece");
      }
    }
    return true;
  }

  bool meets(const std::vector<PieceEdge>& other, const DraftInner& written) {
    const Curve a = whole_outline(edges_), b = whole_outline(other);
    for (const Crossing& crossing : crossings(a, b)) {
      const bool ends = is_end(a, crossing.s_first) && is_end(b, crossing.s_second);
      const bool corners = is_corner(edges_, crossing.point) && is_corner(other, crossing.point);
      if (ends || corners) continue;
      return fail(fmt::format("crosses line {}", quoted(written.name)), written.written, at(crossing.point),
                  "lines may meet where an edge of either ends: draw them in parts");
    }
    return true;
  }

 private:
  static std::string at(Vec2 p) { return fmt::format("at ({}, {})", in_cm(p.x), in_cm(p.y)); }

  static bool is_corner(const std::vector<PieceEdge>& edges, Vec2 p) {
    return std::any_of(edges.begin(), edges.end(), [&](const PieceEdge& edge) {
      return distance(edge.curve.start(), p) < kTouches || distance(edge.curve.end(), p) < kTouches;
    });
  }

  bool fail(const std::string& what, Location where, const std::string& label, const std::string& help) {
    std::vector<Label> labels{{written_.written, "this line"}};
    if (where.span.begin != written_.written.span.begin) {
      labels.push_back({where, label});
    } else {
      labels.front().text = label;
    }
    findings_.error("E0339", fmt::format("line {} of piece {} {}", quoted(written_.name), quoted(draft_.name), what),
                    std::move(labels), help);
    return false;
  }

  // Only an end of a line may lie on the rim of the cloth, and none where that is folded or cut away.
  bool keeps_clear(const Curve& whole, const PieceEdge& rim) {
    const double middle = rim.curve.length() / 2, beside = nearest_place(whole, rim.curve.at(middle));
    const bool covered = distance(whole.at(beside), rim.curve.at(middle)) < kTouches && !is_end(whole, beside);
    const bool covers = std::any_of(edges_.begin(), edges_.end(), [&](const PieceEdge& edge) {
      const Vec2 on = edge.curve.at(edge.curve.length() / 2);
      return distance(rim.curve.at(nearest_place(rim.curve, on)), on) < kTouches;
    });
    if (covered || covers) {
      return fail(fmt::format("runs along edge {}", quoted(rim.name)), rim.written, "the edge",
                  "what is sewn there is sewn to the edge itself");
    }
    for (const Crossing& crossing : crossings(whole, rim.curve)) {
      if (!is_end(whole, crossing.s_first)) {
        return fail(fmt::format("meets edge {}", quoted(rim.name)), rim.written, at(crossing.point),
                    "a line keeps inside of the cloth; only its ends may lie on an edge");
      }
    }
    for (const Vec2 end : {whole.start(), whole.end()}) {
      const double met = nearest_place(rim.curve, end);
      if (distance(rim.curve.at(met), end) > kTouches) continue;
      if (rim.is_dart_leg || rim.folded_under || lies_in_pleat(rim, met)) {
        return fail(fmt::format("ends in a {}", rim.is_dart_leg ? "dart" : "pleat"), rim.written, at(end),
                    "let it end beside");
      }
    }
    return true;
  }

  bool lies_in_pleat(const PieceEdge& rim, double s) const {
    const double place = rim.against_drawing ? rim.drawn.to - s : rim.drawn.from + s;
    return std::any_of(drawn_.turns.begin(), drawn_.turns.end(), [&](const CutTurn& turn) {
      const double depth = turn.inner_fold - turn.fold;
      const auto [low, high] = std::minmax({turn.fold - depth, turn.fold + 2 * depth});
      return turn.edge == rim.name && place > low - kTouches && place < high + kTouches;
    });
  }

  const DraftPiece& draft_;
  const DrawnPiece& drawn_;
  const DraftInner& written_;
  const std::vector<PieceEdge>& edges_;
  Findings& findings_;
};

}  // namespace

bool check_rims(const DraftPiece& draft, Findings& findings) {
  const int before = findings.errors();
  const auto check = [&](const std::string& edge, const char* what, Location written) {
    const DraftInner* const line = line_with(draft, edge);
    if (line == nullptr) return;
    findings.error("E0339",
                   fmt::format("{} is a line inside piece {}: {} only where the cloth ends", quoted(edge),
                               quoted(draft.name), what),
                   {{written, "here"}, {line->written, "the line"}}, "name an edge of the outline, or of a hole");
  };
  if (draft.chart && !draft.lines.empty()) {
    findings.error("E0339",
                   fmt::format("piece {} is drawn on a body, where no line inside it is sewn", quoted(draft.name)),
                   {{draft.lines.front().written, "this line"}, {draft.written, "the piece"}},
                   "develop it, and draw the line in the flat pattern");
  }
  for (const DraftAllowance& allowance : draft.allowances) {
    check(allowance.edge, "there are allowances", allowance.written);
  }
  for (const DraftDart& dart : draft.darts) check(dart.edge, "darts are cut", dart.written);
  for (const DraftPivot& pivot : draft.pivots) check(pivot.edge, "darts are cut", pivot.written);
  for (const DraftPleat& pleat : draft.pleats) {
    check(pleat.place.edge, "pleats are laid", pleat.written);
    if (pleat.other_end) check(pleat.other_end->edge, "pleats are laid", pleat.written);
  }
  return findings.errors() == before;
}

bool check_lines(const DraftPiece& draft, const DrawnPiece& drawn, Findings& findings) {
  if (draft.lines.empty()) return true;
  const int before = findings.errors();
  for (std::size_t i = 0; i < draft.lines.size(); ++i) {
    if (draft.lines[i].edges.empty()) {
      findings.error("E0339",
                     fmt::format("line {} of piece {} has no edges", quoted(draft.lines[i].name), quoted(draft.name)),
                     {{draft.lines[i].written, ""}}, "line pocket from (5cm, -20cm) { foot = line to (20cm, -20cm) }");
      continue;
    }
    LineCheck check(draft, drawn, i, findings);
    if (!check.run()) continue;
    for (std::size_t other = 0; other < i; ++other) {
      if (!draft.lines[other].edges.empty() && !check.meets(drawn.piece.lines[other], draft.lines[other])) break;
    }
  }
  return findings.errors() == before;
}

void divide_at_lines(const DraftPiece& draft, DrawnPiece& drawn) {
  for (const std::vector<PieceEdge>& line : drawn.piece.lines) {
    for (const Vec2 end : {line.front().curve.start(), line.back().curve.end()}) {
      for (int l = 0; l < drawn.closed_count(); ++l) {
        for (int i = 0; i < static_cast<int>(drawn.loop(l).size()); ++i) {
          if (draft.fold == drawn.loop(l)[i].name) continue;  // there the line runs on into its mirror image
          const Curve& edge = drawn.loop(l)[i].curve;
          const double s = nearest_place(edge, end);
          if (distance(edge.at(s), end) < kTouches && !is_end(edge, s)) divide_edge(drawn, {l, i, s});
        }
      }
    }
  }
}

}  // namespace toile
