// Seams of darts and of the script: which copies of the edges meet, and in which direction (see draft.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

using FoundChain = std::vector<FoundEdge>;

Side other(Side side) {
  return side == Side::Drawn ? Side::Mirrored : Side::Drawn;
}

const Chain& drawn_copy(const FoundEdge& edge) {
  return *edge.copies[static_cast<std::size_t>(Side::Drawn)];
}

// From start to end of the drawn line, walked with its cloth on the left; none of a line that closes upon itself, as
// the rim of a hole does.
Vec2 chord(const std::vector<Piece>& pieces, const FoundEdge& edge) {
  const Chain& links = drawn_copy(edge);
  const Piece& piece = pieces[links.front().edge.piece];
  const Vec2 way = piece.edge(links.back().edge.edge).curve.end() - piece.edge(links.front().edge.edge).curve.start();
  return norm(way) > 1e-6 ? way : Vec2{};
}

bool is_line(const std::vector<Piece>& pieces, const ChainLink& link) {
  return pieces[link.edge.piece].is_inside(link.edge.edge);
}

// From its start to its end; of one that closes the way round is told by `area` instead.
struct Course {
  Vec2 way;
  double area = 0;  // [m2] to its left
};

Course course_of(const std::vector<Piece>& pieces, const Chain& chain) {
  std::vector<Vec2> points;
  for (const ChainLink& link : chain) {
    const Curve& edge = pieces[link.edge.piece].edge(link.edge.edge).curve;
    const std::vector<Vec2> along = (link.forward ? edge : edge.reversed()).polygon(1e-3);
    points.insert(points.end(), along.begin(), along.end());
  }
  Course course{points.back() - points.front(), 0};
  if (norm(course.way) > 1e-6) return course;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) course.area += cross(points[i], points[i + 1]) / 2;
  return course;
}

// Whether two chains run the same way as the pieces lie in the drawing, one on the other; where they lie across each
// other, as they are drawn.
bool run_alike(const std::vector<Piece>& pieces, const Chain& first, const Chain& second) {
  constexpr double kAcross = 0.2;  // cosine
  const Course a = course_of(pieces, first), b = course_of(pieces, second);
  if (a.area != 0 && b.area != 0) return a.area * b.area > 0;
  const double alike = dot(a.way, b.way);
  if (std::abs(alike) > kAcross * norm(a.way) * norm(b.way)) return alike > 0;
  const auto as_drawn = [&](const ChainLink& link) {
    return pieces[link.edge.piece].edge(link.edge.edge).against_drawing != link.forward;
  };
  return as_drawn(first.front()) == as_drawn(second.front());
}

bool any_free(const FoundChain& chain) {
  return std::any_of(chain.begin(), chain.end(), [](const FoundEdge& e) { return e.free(); });
}
bool any_single(const FoundChain& chain) {
  return std::any_of(chain.begin(), chain.end(), [](const FoundEdge& e) { return !e.copied; });
}
bool any_stated(const FoundChain& chain) {
  return std::any_of(chain.begin(), chain.end(), [](const FoundEdge& e) { return e.written->side.has_value(); });
}
bool all_cut(const FoundChain& chain) {
  return std::all_of(chain.begin(), chain.end(), [](const FoundEdge& e) { return e.cut(); });
}

// Finds the seams that one `sew` stands for.
class Pairing {
 public:
  Pairing(const DraftSeam& draft, FoundChain first, FoundChain second, const std::vector<Piece>& pieces,
          const SewnCorners& corners)
      : draft_(draft),
        first_(std::move(first)),
        second_(std::move(second)),
        pieces_(pieces),
        corners_(corners),
        is_upon_(is_line(pieces, drawn_copy(first_.front()).front()) ||
                 is_line(pieces, drawn_copy(second_.front()).front())) {}

  std::vector<Seam> seams() const {
    const bool free = any_free(first_) || any_free(second_);
    const bool single = any_single(first_) || any_single(second_);
    const bool stated = any_stated(first_) || any_stated(second_);
    if (!free || single) return {seam(whole(first_, true), whole(second_, draft_.reversed))};
    if (stated) return {pair(stated_side())};
    Seam drawn = pair(Side::Drawn), mirrored = pair(Side::Mirrored);
    if (same_edges(drawn, mirrored)) return {std::move(drawn)};
    return {std::move(drawn), std::move(mirrored)};
  }

 private:
  // Two lines that face the same side are mirror images of each other in the garment: drawn meets mirrored.
  bool same_way() const { return dot(chord(pieces_, first_.front()), chord(pieces_, second_.front())) > 0; }

  // What is laid upon a line inside a piece lies on its own copy.
  Side partner(Side side) const { return !is_upon_ && same_way() ? other(side) : side; }

  Side stated_side() const {
    if (first_.front().written->side) return *first_.front().written->side;
    if (second_.front().written->side) return partner(*second_.front().written->side);
    return Side::Drawn;
  }

  Strand strand(const FoundChain& chain, std::size_t i, Side side, bool cloth_on_left) const {
    const Chain& links = *chain[i].copies[static_cast<std::size_t>(side)];
    return {static_cast<int>(i), side, cloth_on_left ? links : reversed(links)};
  }

  // Every copy of every edge as one line.
  std::vector<Strand> whole(const FoundChain& chain, bool cloth_on_left) const {
    std::vector<Strand> strands;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (chain[i].free()) {
        for (Strand& copy : both_copies(chain[i], static_cast<int>(i), cloth_on_left, corners_)) {
          strands.push_back(std::move(copy));
        }
      } else {
        strands.push_back(strand(chain, i, chain[i].written->side.value_or(Side::Drawn), cloth_on_left));
      }
    }
    return completed(line_up(strands, false, corners_), false);
  }

  // One copy of every edge: that of the leading one is given, the others are those that run on from it.
  std::vector<Strand> one_side(const FoundChain& chain, Side leading, bool cloth_on_left) const {
    std::vector<Strand> strands;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const std::optional<Side> stated = chain[i].written->side;
      if (i == 0 || stated) {
        strands.push_back(strand(chain, i, stated.value_or(leading), cloth_on_left));
        continue;
      }
      // Where nothing joins them yet, edges that face the same side are taken for mirror images.
      const bool like_leading = dot(chord(pieces_, chain[0]), chord(pieces_, chain[i])) <= 0;
      const Side likely = like_leading ? leading : other(leading);
      strands.push_back(strand(chain, i, likely, cloth_on_left));
      strands.push_back(strand(chain, i, other(likely), cloth_on_left));
    }
    return completed(line_up(strands, true, corners_), true);
  }

  // Edges that nothing joins yet are joined by this very seam, in the order of the script.
  static std::vector<Strand> completed(LinedUp lined_up, bool one_of_each) {
    std::vector<Strand> strands = std::move(lined_up.strands);
    for (Strand& rest : lined_up.left_over) {
      const bool served = one_of_each && std::any_of(strands.begin(), strands.end(),
                                                     [&](const Strand& s) { return s.reference == rest.reference; });
      if (!served) strands.push_back(std::move(rest));
    }
    return strands;
  }

  Seam pair(Side leading) const {
    return seam(one_side(first_, leading, true), one_side(second_, partner(leading), draft_.reversed));
  }

  std::string chain_name(const FoundChain& chain, const std::vector<Strand>& strands) const {
    std::string name;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      std::vector<Side> sides;
      for (const Strand& s : strands) {
        if (s.reference == static_cast<int>(i)) sides.push_back(s.side);
      }
      name += (i > 0 ? " + " : "") + edge_name(chain[i], sides.size() == 1 ? std::optional(sides[0]) : std::nullopt);
    }
    return name;
  }

  Seam seam(const std::vector<Strand>& first, const std::vector<Strand>& second) const {
    Seam made;
    made.name = chain_name(first_, first) + " to " + chain_name(second_, second);
    made.first = joined(first);
    made.second = joined(second);
    if (is_upon_ && run_alike(pieces_, made.first, made.second) == draft_.reversed) {
      made.second = reversed(made.second);
    }
    made.fullness = draft_.fullness;
    made.stated = draft_.stated.value_or(0);
    made.written = draft_.written;
    made.is_layer = draft_.is_layer;
    made.closure = draft_.closure;
    made.open = draft_.open;
    made.step = draft_.step;
    made.angle = draft_.angle;
    return made;
  }

  static std::vector<std::pair<int, int>> edges_of(const Seam& seam) {
    std::vector<std::pair<int, int>> edges;
    for (const Chain* chain : {&seam.first, &seam.second}) {
      for (const ChainLink& link : *chain) edges.emplace_back(link.edge.piece, link.edge.edge);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }
  static bool same_edges(const Seam& a, const Seam& b) { return edges_of(a) == edges_of(b); }

  const DraftSeam& draft_;
  FoundChain first_, second_;
  const std::vector<Piece>& pieces_;
  const SewnCorners& corners_;
  bool is_upon_;  // a line inside a piece
};

// The copies of one edge alone can be paired without knowing what else is sewn; chains need to know.
bool needs_corners(const FoundChain& first, const FoundChain& second) {
  if (first.size() > 1 || second.size() > 1) return true;
  return (any_free(first) || any_free(second)) && (any_single(first) || any_single(second));
}

// Two parts of an edge that lie on each other because the cloth is folded between them, sewn from the fold on.
Seam layers(int piece, int upper, int lower) {
  Seam seam;
  seam.is_pleat = true;
  const bool in_order = lower > upper;
  seam.first = {{{piece, upper}, !in_order}};
  seam.second = {{{piece, lower}, in_order}};
  return seam;
}

}  // namespace

bool is_sewn_upon(const Seam& seam, const std::vector<Piece>& pieces) {
  const auto any = [&](const Chain& chain) {
    return std::any_of(chain.begin(), chain.end(), [&](const ChainLink& link) { return is_line(pieces, link); });
  };
  return any(seam.first) || any(seam.second);
}

std::vector<Seam> dart_seams(const std::vector<Piece>& pieces, SewnCorners& corners) {
  std::vector<Seam> seams;
  for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
    for (const Dart& dart : pieces[p].darts) {
      Seam seam;
      seam.name = pieces[p].drawn_name + "." + dart.name;
      if (pieces[p].edge(dart.left_leg).side == Side::Mirrored) seam.name += ".mirrored";
      seam.first = {{{p, dart.left_leg}, true}};
      seam.second = {{{p, dart.right_leg}, false}};
      seam.is_dart = true;
      seam.written = dart.written;
      corners.sew(seam);
      seams.push_back(std::move(seam));
    }
    for (const Pleat& pleat : pieces[p].pleats) {
      for (const auto& [upper, lower] : {std::pair(pleat.face, pleat.under), std::pair(pleat.under, pleat.back)}) {
        Seam seam = layers(p, upper, lower);
        seam.name = pieces[p].drawn_name + "." + pleat.name;
        if (pieces[p].edge(upper).side == Side::Mirrored) seam.name += ".mirrored";
        seam.written = pleat.written;
        corners.sew(seam);
        seams.push_back(std::move(seam));
      }
    }
  }
  return seams;
}

std::vector<std::vector<Seam>> resolve_seams(const DraftGarment& draft, const std::vector<Piece>& pieces,
                                             SewnCorners& corners, Findings& findings) {
  const EdgeFinder finder(draft, pieces);
  std::vector<std::optional<std::pair<FoundChain, FoundChain>>> found;
  for (const DraftSeam& seam : draft.seams) {
    std::optional<FoundChain> first = finder.find(seam.first, "sewn", findings);
    std::optional<FoundChain> second = finder.find(seam.second, "sewn", findings);
    const bool ready = first && second && all_cut(*first) && all_cut(*second);
    found.push_back(ready ? std::optional(std::pair(std::move(*first), std::move(*second))) : std::nullopt);
  }
  std::vector<std::vector<Seam>> seams(draft.seams.size());
  for (const bool chains : {false, true}) {
    for (std::size_t i = 0; i < seams.size(); ++i) {
      if (!found[i] || needs_corners(found[i]->first, found[i]->second) != chains) continue;
      seams[i] = Pairing(draft.seams[i], found[i]->first, found[i]->second, pieces, corners).seams();
      for (Seam& seam : seams[i]) {
        if (!tie_places(draft.seams[i], pieces, seam, findings)) break;
        if (!seam.open) corners.sew(seam);
      }
    }
  }
  return seams;
}

}  // namespace toile
