// What can be wrong with an outline by itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "compiler/curve/places.hpp"
#include "compiler/pattern/cutting.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kOpen = 1e-6;      // [m] ends nearer than this are joined
constexpr double kNoLength = 1e-5;  // [m]
constexpr double kAbsurd = 1000;    // [m]
constexpr double kSliver = 1e-6;    // area over squared length of the outline

std::string place(Vec2 p) {
  return "(" + in_cm(p.x) + ", " + in_cm(p.y) + ")";
}

Curve loop_of(const std::vector<DraftEdge>& edges) {
  std::vector<Curve> curves;
  curves.reserve(edges.size());
  for (const DraftEdge& edge : edges) curves.push_back(edge.curve);
  return join(curves);
}

bool names_differ(const std::string& owner, const std::vector<DraftEdge>& edges, Findings& findings) {
  bool good = true;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (edges[i].name != edges[j].name) continue;
      findings.error("E0102", fmt::format("{} has two edges named {}", owner, quoted(edges[i].name)),
                     {{edges[i].written, "the second"}, {edges[j].written, "the first"}},
                     "seams and darts find an edge by its name: give each its own");
      good = false;
      break;
    }
  }
  return good;
}

bool lengths_are_sane(const std::string& owner, const std::vector<DraftEdge>& edges, Findings& findings) {
  bool good = true;
  for (const DraftEdge& edge : edges) {
    const double length = edge.curve.length();
    if (length >= kNoLength && length < kAbsurd) continue;
    good = false;
    if (length < kNoLength) {
      findings.error("E0303", fmt::format("edge {} of {} has no length", quoted(edge.name), owner),
                     {{edge.written, "ends where it starts, at " + place(edge.curve.start())}},
                     "move its end, or leave the edge out");
    } else {
      findings.error("E0324",
                     fmt::format("edge {} of {} has no length that cloth could have", quoted(edge.name), owner),
                     {{edge.written, std::isfinite(length) ? in_cm(length) + " long" : "its length is no number"}});
      return false;  // the cause spreads to the edges that follow
    }
  }
  return good;
}

bool closes(const std::string& owner, const std::vector<DraftEdge>& edges, Location written, Findings& findings) {
  bool good = true;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const DraftEdge& edge = edges[i];
    const DraftEdge& next = edges[(i + 1) % edges.size()];
    const double gap = distance(edge.curve.end(), next.curve.start());
    if (gap <= kOpen) continue;
    good = false;
    const bool last = i + 1 == edges.size();
    std::vector<Label> labels{{edge.written, "ends at " + place(edge.curve.end())}};
    if (edges.size() > 1) labels.push_back({next.written, "starts at " + place(next.curve.start())});
    if (last) labels.push_back({written, ""});
    findings.error("E0301",
                   fmt::format("the outline of {} is open: a gap of {} between the end of {} and the start of {}",
                               owner, in_cm(gap), quoted(edge.name), quoted(next.name)),
                   std::move(labels),
                   last ? fmt::format("let {} end at the start: `... to start`", quoted(edge.name)) : "");
  }
  return good;
}

std::size_t edge_at(const std::vector<DraftEdge>& edges, double s) {
  std::size_t i = 0;
  while (i + 1 < edges.size() && s > edges[i].curve.length()) s -= edges[i++].curve.length();
  return i;
}

bool crosses_itself(const std::string& owner, const std::vector<DraftEdge>& edges, Findings& findings) {
  std::set<std::size_t> reported;  // one edge gone astray may cross many
  for (const Crossing& crossing : self_crossings(loop_of(edges))) {
    const std::size_t i = edge_at(edges, crossing.s_first), j = edge_at(edges, crossing.s_second);
    if (reported.contains(i) || reported.contains(j)) continue;
    reported.insert({i, j});
    const std::string where = place(crossing.point);
    if (i == j) {
      findings.error("E0302", fmt::format("edge {} of {} crosses itself at {}", quoted(edges[i].name), owner, where),
                     {{edges[i].written, "makes a loop"}}, "an outline meets itself nowhere but at its corners");
      continue;
    }
    findings.error("E0302",
                   fmt::format("the outline of {} crosses itself: {} and {} meet at {}", owner, quoted(edges[i].name),
                               quoted(edges[j].name), where),
                   {{edges[j].written, "meets " + quoted(edges[i].name) + " at " + where}, {edges[i].written, "here"}},
                   "an outline meets itself nowhere but at its corners");
  }
  return !reported.empty();
}

bool check_loop(const std::string& owner, const std::vector<DraftEdge>& edges, Location written, Findings& findings) {
  if (edges.empty()) {
    findings.error("E0304", owner + " has no outline", {{written, ""}});
    return false;
  }
  const bool sane = lengths_are_sane(owner, edges, findings);
  if (!sane || !closes(owner, edges, written, findings) || crosses_itself(owner, edges, findings)) return false;
  const Curve loop = loop_of(edges);
  if (std::abs(signed_area(loop)) > kSliver * loop.length() * loop.length()) return true;
  findings.error("E0304", fmt::format("the outline of {} encloses no area", owner),
                 {{written, in_cm(loop.length()) + " around, and nothing inside"}});
  return false;
}

std::string hole_of(const DraftPiece& draft, const DraftInner& hole) {
  return hole.name.empty() ? "the hole in " + quoted(draft.name) : "hole " + quoted(hole.name);
}

// `piece.eye` is either an edge or a hole, and `piece.eye.rim` lies on one hole.
bool hole_names_differ(const DraftPiece& draft, Findings& findings) {
  bool good = true;
  for (std::size_t h = 0; h < draft.holes.size(); ++h) {
    const DraftInner& hole = draft.holes[h];
    if (hole.name.empty()) continue;
    std::vector<Label> labels{{hole.written, "this hole"}};
    for (const DraftEdge& edge : draft.outline) {
      if (edge.name == hole.name) labels.push_back({edge.written, "an edge of that name"});
    }
    for (std::size_t other = 0; other < h; ++other) {
      if (draft.holes[other].name == hole.name) labels.push_back({draft.holes[other].written, "a hole of that name"});
    }
    if (labels.size() == 1) continue;
    findings.error("E0102", fmt::format("the name {} is taken in piece {}", quoted(hole.name), quoted(draft.name)),
                   std::move(labels), "seams find edges and holes by their names: give each its own");
    good = false;
  }
  return good;
}

// Of a hole on the fold half is drawn: a whole one lies in cloth that is not there.
bool crosses_fold(const DraftPiece& draft, const DraftInner& hole, const Curve& rim, const std::string& owner,
                  Findings& findings) {
  for (const DraftEdge& edge : draft.outline) {
    if (draft.fold != edge.name || crossings(rim, edge.curve).empty()) continue;
    findings.error("E0314",
                   fmt::format("{} lies across the fold {} of piece {}", owner, quoted(edge.name), quoted(draft.name)),
                   {{hole.written, "this hole"}, {draft.fold_written, "the fold"}},
                   "draw half of it, from the fold to the fold, on the side of the cloth");
    return true;
  }
  return false;
}

Location fold_edge_written(const DraftPiece& draft) {
  for (const DraftEdge& edge : draft.outline) {
    if (draft.fold == edge.name) return edge.written;
  }
  return {};
}

// A hole's edges as a closed line: those of a half with the fold between their ends.
Curve rim_of(const DraftPiece& draft, const DraftInner& hole) {
  const Curve drawn = loop_of(hole.edges);
  return is_half(draft, hole) ? join({drawn, line(drawn.end(), drawn.start())}) : drawn;
}

// By itself: the edges have lengths, follow each other, cross nowhere and bound something.
bool check_rim(const DraftPiece& draft, const DraftInner& hole, const std::string& owner, Findings& findings) {
  if (!is_half(draft, hole)) return check_loop(owner, hole.edges, hole.written, findings);
  if (!lengths_are_sane(owner, hole.edges, findings) || crosses_itself(owner, hole.edges, findings)) return false;
  const Curve rim = rim_of(draft, hole);
  if (std::abs(signed_area(rim)) > kSliver * rim.length() * rim.length()) return true;
  findings.error("E0304", fmt::format("the outline of {} encloses no area", owner), {{hole.written, "on the fold"}});
  return false;
}

}  // namespace

bool check_outline(const DraftPiece& draft, Findings& findings) {
  const std::string owner = "piece " + quoted(draft.name);
  const bool named = names_differ(owner, draft.outline, findings);
  return check_loop(owner, draft.outline, draft.written, findings) && named;
}

bool check_holes(const DraftPiece& draft, Findings& findings) {
  if (draft.holes.empty()) return true;
  const int before = findings.errors();
  hole_names_differ(draft, findings);
  const Region region(loop_of(draft.outline));
  for (std::size_t h = 0; h < draft.holes.size(); ++h) {
    const DraftInner& hole = draft.holes[h];
    const std::string owner = hole_of(draft, hole);
    names_differ(owner, hole.edges, findings);
    const Curve rim = loop_of(hole.edges);
    const bool half = is_half(draft, hole);
    const bool has_length = rim.length() > kNoLength && rim.length() < kAbsurd;  // false for NaN
    if (has_length && !half && crosses_fold(draft, hole, rim, owner, findings)) continue;
    if (!check_rim(draft, hole, owner, findings)) continue;
    const auto meets = [&](const std::string& other, const Curve& curve, Location written) {
      std::vector<Crossing> found = crossings(rim, curve);
      std::erase_if(found, [&](const Crossing& crossing) {
        const bool at_end = std::min(crossing.s_first, rim.length() - crossing.s_first) < kOpen;
        return half && at_end && written == fold_edge_written(draft);
      });
      if (found.empty()) return false;
      findings.error("E0314", fmt::format("{} meets {} at {}", owner, other, place(found[0].point)),
                     {{hole.written, "this hole"}, {written, "reaches it"}}, "keep a hole clear of other edges");
      return true;
    };
    const bool crossed = std::any_of(draft.outline.begin(), draft.outline.end(), [&](const DraftEdge& edge) {
      return meets("edge " + quoted(edge.name), edge.curve, edge.written);
    });
    if (crossed) continue;
    const Vec2 inside = half ? rim.at(rim.length() / 2) : rim.start();
    if (!region.contains(inside)) {
      findings.error("E0314", fmt::format("{} lies outside of its piece", owner),
                     {{hole.written, (half ? "passes " : "starts at ") + place(inside)}, {draft.written, "the piece"}});
    }
    for (std::size_t other = 0; other < h; ++other) {
      const Curve other_rim = rim_of(draft, draft.holes[other]);
      const std::string name = hole_of(draft, draft.holes[other]);
      if (meets(name, loop_of(draft.holes[other].edges), draft.holes[other].written)) continue;
      const Vec2 on_other = other_rim.at(loop_of(draft.holes[other].edges).length() / 2);
      if (Region(other_rim).contains(rim.at(rim.length() / 2)) || Region(rim_of(draft, hole)).contains(on_other)) {
        findings.error("E0314", fmt::format("{} and {} lie one inside the other", owner, name),
                       {{hole.written, ""}, {draft.holes[other].written, ""}});
      }
    }
  }
  return findings.errors() == before;
}

}  // namespace toile
