#include "runtime/develop/redraw.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "runtime/develop/edge_names.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

class Redrawing {
 public:
  Redrawing(const Garment& garment, const SewnMesh& mesh, const Development& development, double tolerance)
      : garment_(garment),
        mesh_(mesh),
        development_(development),
        tolerance_(tolerance),
        halved_(is_symmetric()),
        names_(garment, halved_) {}

  Redrawn redraw() {
    redrawn_.draft.name = garment_.name;
    redrawn_.draft.fabric = garment_.fabric;
    redrawn_.draft.textile = garment_.textile;
    redrawn_.draft.written = garment_.written;
    for (int piece = 0; piece < static_cast<int>(garment_.pieces.size()); ++piece) {
      if (!halved_ || garment_.pieces[index(piece)].side == Side::Drawn) redraw_piece(piece);
    }
    add_seams();
    return std::move(redrawn_);
  }

 private:
  std::vector<Vec2> solved(int piece, int edge) const {
    std::vector<Vec2> points;
    for (const int point : mesh_.p.edge_nodes[index(piece)][index(edge)].points) {
      points.push_back(development_.points[index(point)]);
    }
    return points;
  }

  /// Whether copies came out like what they are copies of, so that halves and pairs can be redrawn as such.
  bool is_symmetric() const {
    std::map<std::tuple<std::string, std::string, int>, double> drawn;  // lengths of edges
    const auto key = [&](const Piece& piece, const PieceEdge& edge) {
      return std::tuple(piece.drawn_name, edge.name, edge.part);
    };
    const auto length = [&](int piece, int edge) {
      const std::vector<Vec2> points = solved(piece, edge);
      double sum = 0;
      for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
      return sum;
    };
    for (const bool copies : {false, true}) {
      for (int p = 0; p < static_cast<int>(garment_.pieces.size()); ++p) {
        const Piece& piece = garment_.pieces[index(p)];
        for (int e = 0; e < piece.edge_count(); ++e) {
          const PieceEdge& edge = piece.edge(e);
          if ((edge.side == Side::Mirrored || piece.side == Side::Mirrored) != copies) continue;
          const auto [known, is_new] = drawn.try_emplace(key(piece, edge), length(p, e));
          if (copies && !is_new && std::abs(known->second - length(p, e)) > 2 * tolerance_) return false;
        }
      }
    }
    return std::all_of(garment_.pieces.begin(), garment_.pieces.end(), [](const Piece& piece) {
      if (!piece.fold) return true;
      const Vec2 way = piece.fold->to - piece.fold->from;  // a half on the bias has another warp than its other half
      return std::abs(dot(way, piece.warp) * cross(way, piece.warp)) < 1e-6 * dot(way, way) && piece.holes.empty();
    });
  }

  RedrawnEdge redraw_edge(int piece, int edge) {
    RedrawnEdge redrawn{names_.of(piece, edge), fit_curve(solved(piece, edge), tolerance_)};
    redrawn_.error = std::max(redrawn_.error, redrawn.fitted.error);
    return redrawn;
  }

  static DraftEdge draft_edge(const RedrawnEdge& edge, Location written) {
    return {edge.name, edge.fitted.curve, written};
  }

  void redraw_piece(int number) {
    const Piece& piece = garment_.pieces[index(number)];
    RedrawnPiece& redrawn = redrawn_.pieces.emplace_back();
    DraftPiece draft;
    draft.name = names_.of_piece(number);
    draft.quantity = piece.quantity;
    draft.warp = development_.warp_of_piece[index(number)];
    draft.written = piece.written;
    if (halved_ && is_paired(piece)) {
      draft.mirrored = true;
      draft.quantity = 2 * piece.quantity;
    }
    for (int e = 0; e < static_cast<int>(piece.edges.size()); ++e) {
      const PieceEdge& edge = piece.edges[index(e)];
      if (halved_ && piece.fold && edge.side == Side::Mirrored) continue;
      redrawn.outline.push_back(redraw_edge(number, e));
      draft.outline.push_back(draft_edge(redrawn.outline.back(), edge.written));
      if (edge.allowance > 0) draft.allowances.push_back({redrawn.outline.back().name, edge.allowance, edge.written});
    }
    if (halved_ && piece.fold) add_fold(redrawn, draft);
    add_holes(number, redrawn, draft);
    for (const Notch& notch : piece.notches) add_notch(number, notch, redrawn, draft);
    redrawn_.draft.pieces.push_back(std::move(draft));
  }

  bool is_paired(const Piece& piece) const {
    return std::any_of(garment_.pieces.begin(), garment_.pieces.end(), [&](const Piece& other) {
      return other.drawn_name == piece.drawn_name && other.side == Side::Mirrored;
    });
  }

  static void add_fold(RedrawnPiece& redrawn, DraftPiece& draft) {
    RedrawnEdge fold;
    fold.name = "on_the_fold";
    fold.fitted.points = {redrawn.outline.back().fitted.points.back(), redrawn.outline.front().fitted.points.front()};
    fold.fitted.curve = line(fold.fitted.points.front(), fold.fitted.points.back());
    draft.outline.push_back(draft_edge(fold, draft.written));
    draft.fold = fold.name;
    draft.fold_written = draft.written;
    redrawn.outline.push_back(std::move(fold));
  }

  void add_holes(int number, RedrawnPiece& redrawn, DraftPiece& draft) {
    const Piece& piece = garment_.pieces[index(number)];
    int next = static_cast<int>(piece.edges.size());
    for (std::size_t h = 0; h < piece.holes.size(); ++h) {
      RedrawnHole& hole = redrawn.holes.emplace_back();
      hole.name = EdgeNames::of_hole(h);
      DraftInner draft_hole{hole.name, {}, piece.written};
      for (std::size_t e = 0; e < piece.holes[h].size(); ++e, ++next) {
        hole.edges.push_back(redraw_edge(number, next));
        draft_hole.edges.push_back(draft_edge(hole.edges.back(), piece.holes[h][e].written));
      }
      draft.holes.push_back(std::move(draft_hole));
    }
  }

  /// At the same fraction of the way between the same two points of the mesh.
  void add_notch(int piece, const Notch& notch, const RedrawnPiece& redrawn, DraftPiece& draft) {
    const std::string name = names_.of(piece, notch.edge);
    const auto edge = std::find_if(redrawn.outline.begin(), redrawn.outline.end(),
                                   [&](const RedrawnEdge& each) { return each.name == name; });
    if (edge == redrawn.outline.end() || garment_.pieces[index(piece)].edge(notch.edge).side == Side::Mirrored) return;
    const PMesh::EdgeNodes& nodes = mesh_.p.edge_nodes[index(piece)][index(notch.edge)];
    double whole = 0, at = 0;
    for (std::size_t i = 0; i + 1 < nodes.points.size(); ++i) {
      const double side =
          distance(development_.points[index(nodes.points[i])], development_.points[index(nodes.points[i + 1])]);
      const double share = (notch.at - nodes.arc[i]) / std::max(nodes.arc[i + 1] - nodes.arc[i], 1e-12);
      at += std::clamp(share, 0.0, 1.0) * side;
      whole += side;
    }
    draft.notches.push_back({edge->name, at / std::max(whole, 1e-12) * edge->fitted.curve.length(), notch.written});
  }

  std::vector<DraftEdgeRef> references(const Chain& chain, bool with_sides) const {
    std::vector<DraftEdgeRef> all;
    for (const ChainLink& link : chain) {
      const Piece& piece = garment_.pieces[index(link.edge.piece)];
      const PieceEdge& edge = piece.edge(link.edge.edge);
      DraftEdgeRef reference{names_.of_piece(link.edge.piece), names_.reference(link.edge), std::nullopt, edge.written};
      const bool copied = halved_ && (piece.fold || is_paired(piece));
      if (with_sides && copied) {
        reference.side = edge.side == Side::Mirrored || piece.side == Side::Mirrored ? Side::Mirrored : Side::Drawn;
      }
      all.push_back(std::move(reference));
    }
    return all;
  }

  static std::string described(const std::vector<DraftEdgeRef>& chain) {
    std::string text;
    for (const DraftEdgeRef& edge : chain) text += edge.piece + "." + edge.edge + " ";
    return text;
  }

  /// A seam and its mirror image are written once, without sides.
  void add_seams() {
    std::map<std::string, int> times;
    const auto name = [&](const Seam& seam) {
      std::string first = described(references(seam.first, false)), second = described(references(seam.second, false));
      return std::min(first, second) + "| " + std::max(first, second);
    };
    for (const Seam& seam : garment_.seams) ++times[name(seam)];
    std::set<std::string> written;
    for (const Seam& seam : garment_.seams) {
      if (!written.insert(name(seam)).second) continue;
      const bool with_sides = times[name(seam)] == 1;
      DraftSeam draft;
      draft.first = references(seam.first, with_sides);
      draft.second = references(seam.second, with_sides);
      draft.reversed = seam.first.front().forward == seam.second.front().forward;
      draft.fullness = seam.fullness;
      if (seam.stated > 0) draft.stated = seam.stated;
      draft.written = seam.written;
      redrawn_.draft.seams.push_back(std::move(draft));
    }
  }

  const Garment& garment_;
  const SewnMesh& mesh_;
  const Development& development_;
  double tolerance_;
  bool halved_;  // pieces on the fold are redrawn as halves, pairs once
  EdgeNames names_;
  Redrawn redrawn_;
};

}  // namespace

Redrawn redraw(const Garment& garment, const SewnMesh& mesh, const Development& development, double tolerance) {
  return Redrawing(garment, mesh, development, tolerance).redraw();
}

}  // namespace toile
