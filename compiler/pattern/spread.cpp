// Slash and spread: a piece cut along straight lines, its panels moved apart, its edges drawn anew over the gaps.
#include "compiler/pattern/spread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/curve/shape.hpp"
#include "compiler/pattern/region.hpp"

namespace toile {
namespace {

constexpr double kApart = 1e-3;  // [m] that slashes keep from each other on an edge
constexpr double kNone = 1e-9;   // [m]

Vec2 rotated(Vec2 v, double angle) {
  return std::cos(angle) * v + std::sin(angle) * perpendicular(v);
}

/// Of a panel: a turn about the origin, then a shift.
struct Motion {
  double angle = 0;
  Vec2 shift;

  Vec2 operator()(Vec2 p) const { return rotated(p, angle) + shift; }
  Curve operator()(const Curve& curve) const { return curve.rotated(angle, {0, 0}).moved(shift); }
  Motion after(const Motion& first) const { return {angle + first.angle, rotated(first.shift, angle) + shift}; }
  Motion inverse() const { return {-angle, -rotated(shift, -angle)}; }
};

/// Where a slash meets the outline.
struct End {
  std::size_t slash = 0;
  bool opened = false;  // the end that `by` is told of
  std::size_t edge = 0;
  double s = 0;      // [m] along the edge
  double along = 0;  // [m] along the outline
  double gap = 0;    // [m]
};

class Spreading {
 public:
  Spreading(const DraftPiece& draft, Findings& findings) : draft_(draft), findings_(findings) {}

  std::optional<SpreadPiece> run() {
    if (!find_ends() || !ways_are_free() || !find_panels()) return std::nullopt;
    find_motions();
    SpreadPiece made{draft_, {}};
    made.piece.spreads.clear();
    for (std::size_t e = 0; e < draft_.outline.size(); ++e) {
      made.piece.outline[e].curve = redrawn(e);
      for (const End& end : ends_) {
        if (end.edge == e && end.gap > 0) made.gaps.push_back({draft_.outline[e].name, end.s, end.gap});
      }
    }
    move_details(made);
    return made;
  }

 private:
  bool fail(const DraftSpread& spread, const std::string& message, std::vector<Label> more = {},
            const std::string& help = "") {
    more.insert(more.begin(), {spread.written, "this slash"});
    findings_.error("E0332", message, std::move(more), help);
    return false;
  }

  bool find_ends() {
    for (std::size_t i = 0; i < draft_.spreads.size(); ++i) {
      const DraftSpread& spread = draft_.spreads[i];
      for (const bool opened : {true, false}) {
        const DraftPlace& place = opened ? spread.opened : spread.other;
        double along = 0;
        std::size_t e = 0;
        while (e < draft_.outline.size() && draft_.outline[e].name != place.edge) {
          along += draft_.outline[e++].curve.length();
        }
        if (e == draft_.outline.size()) {
          return fail(spread, "a piece is slashed from one place of its outline to another", {},
                      "the edges of holes cannot be opened");
        }
        if (draft_.fold == place.edge) {
          return fail(spread, fmt::format("the fold of piece {} cannot be opened", quoted(draft_.name)),
                      {{draft_.fold_written, "the fold"}});
        }
        const double gap = opened ? spread.by : spread.other_by;
        const bool at_corner = place.at < kApart || place.at > draft_.outline[e].curve.length() - kApart;
        if (at_corner && gap > 0) {
          return fail(spread, fmt::format("edge {} cannot be opened at its end", quoted(place.edge)),
                      {{draft_.outline[e].written, "the edge"}}, "slash further along, so that the gap lies within it");
        }
        ends_.push_back({i, opened, e, place.at, along + place.at, gap});
      }
    }
    std::stable_sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.along < b.along; });
    for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
      if (ends_[i + 1].along - ends_[i].along > kApart) continue;
      return fail(draft_.spreads[ends_[i + 1].slash], "two slashes meet in one place",
                  {{draft_.spreads[ends_[i].slash].written, "and this one"}}, "let them end a little apart");
    }
    return true;
  }

  Vec2 point(const DraftPlace& place) const { return drafted_edge(draft_, place.edge)->curve.at(place.at); }

  bool ways_are_free() {
    std::vector<Curve> curves;
    for (const DraftEdge& edge : draft_.outline) curves.push_back(edge.curve);
    const Region region(join(curves));
    for (const DraftSpread& spread : draft_.spreads) {
      const Curve way = line(point(spread.opened), point(spread.other));
      const double length = way.length();
      if (std::abs(spread.by - spread.other_by) >= 1.9 * length) {
        return fail(spread, fmt::format("a slash of {} cannot open by {}", in_cm(length), in_cm(spread.by)));
      }
      const auto blocks = [&](const DraftEdge& edge) {
        const std::vector<Crossing> met = crossings(way, edge.curve);
        return std::any_of(met.begin(), met.end(), [&](const Crossing& c) {
          return c.s_first > kApart / 10 && c.s_first < length - kApart / 10;
        });
      };
      const DraftEdge* obstacle = nullptr;
      for (const DraftEdge& edge : draft_.outline) obstacle = blocks(edge) ? &edge : obstacle;
      for (const auto* inner : {&draft_.holes, &draft_.lines}) {
        for (const DraftInner& each : *inner) {
          for (const DraftEdge& own : each.edges) obstacle = blocks(own) ? &own : obstacle;
        }
      }
      if (obstacle == nullptr && region.contains(way.at(length / 2))) continue;
      std::vector<Label> labels;
      if (obstacle != nullptr) labels.push_back({obstacle->written, "crossed on the way"});
      return fail(spread, "the slash leaves the cloth", labels, "a slash runs straight from one place to the other");
    }
    return true;
  }

  // The outline between two ends belongs to one panel. Each slash parts the panel of its second end from the rest.
  bool find_panels() {
    std::vector<std::size_t> open;
    parent_.assign(draft_.spreads.size() + 1, 0);
    first_.assign(draft_.spreads.size(), nullptr);
    panel_behind_.clear();
    for (const End& end : ends_) {
      if (first_[end.slash] == nullptr) {
        first_[end.slash] = &end;
        parent_[end.slash + 1] = open.empty() ? 0 : open.back() + 1;
        open.push_back(end.slash);
      } else if (open.back() == end.slash) {
        open.pop_back();
      } else {
        return fail(draft_.spreads[end.slash], "two slashes cross each other",
                    {{draft_.spreads[open.back()].written, "and this one"}});
      }
      panel_behind_.push_back(open.empty() ? 0 : open.back() + 1);
    }
    return true;
  }

  // How a panel moves against the one that it was cut from: the gap is a trapezium with the slash for both its legs.
  Motion opening(std::size_t slash, double turn) const {
    const DraftSpread& spread = draft_.spreads[slash];
    const Vec2 p = point(spread.opened), q = point(spread.other), u = p - q;
    const double side = (first_[slash]->opened ? 1 : -1) * turn;  // of the panel, seen from q to p
    const double angle = side * 2 * std::asin((spread.by - spread.other_by) / (2 * norm(u)));
    const Vec2 across = side * perpendicular(rotated(u / norm(u), angle / 2));
    return {angle, q + spread.other_by * across - rotated(q, angle)};
  }

  void find_motions() {
    std::vector<Curve> curves;
    for (const DraftEdge& edge : draft_.outline) curves.push_back(edge.curve);
    const double turn = signed_area(join(curves)) > 0 ? 1 : -1;
    motions_.assign(parent_.size(), {});
    // A panel's parent was cut earlier along the outline, though perhaps written later.
    for (const End& end : ends_) {
      if (first_[end.slash] != &end) continue;
      motions_[end.slash + 1] = motions_[parent_[end.slash + 1]].after(opening(end.slash, turn));
    }
    std::size_t still = 0;
    for (std::size_t e = 0; e < draft_.outline.size(); ++e) {
      if (draft_.fold == draft_.outline[e].name) still = panel_at(e, draft_.outline[e].curve.length() / 2);
    }
    const Motion back = motions_[still].inverse();
    for (Motion& motion : motions_) motion = back.after(motion);
  }

  std::size_t panel_at(std::size_t edge, double s) const {
    std::size_t panel = 0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (std::pair(ends_[i].edge, ends_[i].s) < std::pair(edge, s)) panel = panel_behind_[i];
    }
    return panel;
  }

  // The parts of an edge in their new places, and what they and the gaps between them come to.
  Curve redrawn(std::size_t edge) const {
    const Curve& before = draft_.outline[edge].curve;
    std::vector<double> cuts{0};
    double wanted = before.length();
    for (const End& end : ends_) {
      if (end.edge != edge) continue;
      if (end.s > kApart && end.s < before.length() - kApart) cuts.push_back(end.s);
      wanted += end.gap;
    }
    cuts.push_back(before.length());
    std::vector<Curve> parts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Motion& motion = motions_[panel_at(edge, (cuts[i] + cuts[i + 1]) / 2)];
      parts.push_back(motion(cuts.size() == 2 ? before : before.part(cuts[i], cuts[i + 1])));
    }
    if (parts.size() == 1) return parts[0];
    Curve smooth = smoothed(parts);
    if (std::abs(smooth.length() - wanted) < kNone) return smooth;
    if (const auto exact = of_length(smooth, wanted)) return *exact;
    // A straight edge that cannot bend: its parts as they lie, joined by straight lines.
    std::vector<Curve> joined;
    for (const Curve& part : parts) {
      if (!joined.empty() && distance(joined.back().end(), part.start()) > kNone) {
        joined.push_back(line(joined.back().end(), part.start()));
      }
      joined.push_back(part);
    }
    return join(joined);
  }

  // From the middle of each part to the middle of the next the edge is drawn anew.
  static Curve smoothed(const std::vector<Curve>& parts) {
    const auto angle = [](Vec2 v) { return std::atan2(v.y, v.x); };
    std::vector<Curve> drawn{parts.front().part(0, parts.front().length() / 2)};
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      const double a = parts[i].length() / 2, b = parts[i + 1].length() / 2;
      drawn.push_back(tangent_curve(parts[i].at(a), angle(parts[i].tangent(a)), parts[i + 1].at(b),
                                    angle(parts[i + 1].tangent(b))));
    }
    drawn.push_back(parts.back().part(parts.back().length() / 2, parts.back().length()));
    return join(drawn);
  }

  // Panels as closed curves, for finding what lies on them.
  std::size_t panel_of(Vec2 p) const {
    std::size_t found = 0;
    double smallest = 1e300;
    for (std::size_t slash = 0; slash < first_.size(); ++slash) {
      const End& first = *first_[slash];
      const auto last = std::find_if(ends_.begin(), ends_.end(),
                                     [&](const End& end) { return end.slash == slash && &end != first_[slash]; });
      const Curve rim = outline_between(first, *last);
      const double area = std::abs(signed_area(rim));
      if (area < smallest && Region(rim).contains(p)) {
        smallest = area;
        found = slash + 1;
      }
    }
    return found;
  }

  Curve outline_between(const End& first, const End& last) const {
    std::vector<Curve> curves;
    for (std::size_t e = first.edge; e <= last.edge; ++e) {
      const Curve& curve = draft_.outline[e].curve;
      const double from = e == first.edge ? first.s : 0, to = e == last.edge ? last.s : curve.length();
      if (to - from > kNone) curves.push_back(curve.part(from, to));
    }
    curves.push_back(line(curves.back().end(), curves.front().start()));
    return join(curves);
  }

  void move_details(SpreadPiece& made) const {
    DraftPiece& piece = made.piece;
    const auto move = [&](Vec2& p) { p = motions_[panel_of(p)](p); };
    for (DraftDart& dart : piece.darts) {
      if (dart.edge.empty()) {
        const Motion& motion = motions_[panel_of(0.5 * (dart.inside.from + dart.inside.to))];
        dart.inside = {motion(dart.inside.from), motion(dart.inside.to)};
      }
      dart.at = made.moved(dart.edge, dart.at);
      if (dart.tip) move(*dart.tip);
    }
    for (DraftPivot& pivot : piece.pivots) pivot.at = made.moved(pivot.edge, pivot.at);
    for (DraftNotch& notch : piece.notches) notch.at = made.moved(notch.edge, notch.at);
    for (DraftPleat& pleat : piece.pleats) {
      pleat.place.at = made.moved(pleat.place.edge, pleat.place.at);
      if (pleat.other_end) pleat.other_end->at = made.moved(pleat.other_end->edge, pleat.other_end->at);
    }
    for (auto* inner : {&piece.holes, &piece.lines}) {
      for (DraftInner& each : *inner) {
        const Curve& first = each.edges.front().curve;
        const Motion& motion = motions_[panel_of(first.at(first.length() / 2))];
        for (DraftEdge& edge : each.edges) edge.curve = motion(edge.curve);
      }
    }
    for (LineMark& mark : piece.marks) {
      mark.curve = motions_[panel_of(mark.curve.at(mark.curve.length() / 2))](mark.curve);
    }
    for (PointMark& spot : piece.spots) {
      const Motion& motion = motions_[panel_of(spot.at)];
      spot.at = motion(spot.at);
      spot.angle += motion.angle;
    }
  }

  const DraftPiece& draft_;
  Findings& findings_;
  std::vector<End> ends_;                  // in the order of the outline
  std::vector<const End*> first_;          // of each slash
  std::vector<std::size_t> parent_;        // of each panel: that of slash i is i + 1, the rest is 0
  std::vector<std::size_t> panel_behind_;  // of each end
  std::vector<Motion> motions_;            // of each panel
};

}  // namespace

double SpreadPiece::moved(const std::string& edge, double at) const {
  double sum = at;
  for (const Gap& gap : gaps) {
    if (gap.edge == edge && gap.at < at) sum += gap.width;
  }
  return sum;
}

std::optional<SpreadPiece> spread_out(const DraftPiece& draft, Findings& findings) {
  return Spreading(draft, findings).run();
}

}  // namespace toile
