#include "runtime/develop/redraw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

std::string as_name(std::string text) {
  std::replace(text.begin(), text.end(), '.', '_');
  return text;
}

class Redrawing {
 public:
  Redrawing(const Garment& garment, const SewnMesh& mesh, const Development& development, double tolerance)
      : garment_(garment), mesh_(mesh), development_(development), tolerance_(tolerance) {}

  Redrawn redraw() {
    redrawn_.draft.name = garment_.name;
    redrawn_.draft.fabric = garment_.fabric;
    redrawn_.draft.textile = garment_.textile;
    redrawn_.draft.written = garment_.written;
    for (int piece = 0; piece < static_cast<int>(garment_.pieces.size()); ++piece) redraw_piece(piece);
    for (const Seam& seam : garment_.seams) add_seam(seam);
    return std::move(redrawn_);
  }

 private:
  void name_edges(int number) {
    const Piece& piece = garment_.pieces[index(number)];
    std::map<std::pair<std::string, Side>, int> parts;
    for (int e = 0; e < piece.edge_count(); ++e) ++parts[{piece.edge(e).name, piece.edge(e).side}];
    std::vector<std::string>& names = names_.emplace_back();
    for (int e = 0; e < piece.edge_count(); ++e) {
      const PieceEdge& edge = piece.edge(e);
      std::string name = as_name(edge.name);
      if (parts[{edge.name, edge.side}] > 1) name += fmt::format("_{}", edge.part + 1);
      if (edge.side == Side::Mirrored) name += "_mirrored";
      while (std::find(names.begin(), names.end(), name) != names.end()) name += "_";
      names.push_back(name);
    }
  }

  RedrawnEdge redraw_edge(int piece, int edge) {
    std::vector<Vec2> solved;
    for (const int point : mesh_.p.edge_nodes[index(piece)][index(edge)].points) {
      solved.push_back(development_.points[index(point)]);
    }
    RedrawnEdge redrawn{names_[index(piece)][index(edge)], fit_curve(solved, tolerance_)};
    redrawn_.error = std::max(redrawn_.error, redrawn.fitted.error);
    return redrawn;
  }

  static DraftEdge draft_edge(const RedrawnEdge& edge, Location written) {
    return {edge.name, edge.fitted.curve, written};
  }

  void redraw_piece(int number) {
    const Piece& piece = garment_.pieces[index(number)];
    name_edges(number);
    RedrawnPiece& redrawn = redrawn_.pieces.emplace_back();
    DraftPiece draft;
    draft.name = as_name(piece.name);
    draft.quantity = piece.quantity;
    draft.warp = development_.warp_of_piece[index(number)];
    draft.written = piece.written;
    const int outer = static_cast<int>(piece.edges.size());
    for (int e = 0; e < outer; ++e) {
      redrawn.outline.push_back(redraw_edge(number, e));
      draft.outline.push_back(draft_edge(redrawn.outline.back(), piece.edges[index(e)].written));
      if (piece.edges[index(e)].allowance > 0) {
        draft.allowances.push_back(
            {redrawn.outline.back().name, piece.edges[index(e)].allowance, piece.edges[index(e)].written});
      }
    }
    int next = outer;
    for (std::size_t h = 0; h < piece.holes.size(); ++h) {
      RedrawnHole& hole = redrawn.holes.emplace_back();
      hole.name = fmt::format("hole{}", h + 1);
      DraftHole draft_hole{hole.name, {}, piece.written};
      for (std::size_t e = 0; e < piece.holes[h].size(); ++e, ++next) {
        hole.edges.push_back(redraw_edge(number, next));
        draft_hole.edges.push_back(draft_edge(hole.edges.back(), piece.holes[h][e].written));
      }
      draft.holes.push_back(std::move(draft_hole));
    }
    for (const Notch& notch : piece.notches) add_notch(number, notch, redrawn, draft);
    redrawn_.draft.pieces.push_back(std::move(draft));
  }

  /// At the same fraction of the way between the same two points of the mesh.
  void add_notch(int piece, const Notch& notch, const RedrawnPiece& redrawn, DraftPiece& draft) {
    const PMesh::EdgeNodes& nodes = mesh_.p.edge_nodes[index(piece)][index(notch.edge)];
    double solved = 0, at = 0;
    for (std::size_t i = 0; i + 1 < nodes.points.size(); ++i) {
      const double side =
          distance(development_.points[index(nodes.points[i])], development_.points[index(nodes.points[i + 1])]);
      const double share = (notch.at - nodes.arc[i]) / std::max(nodes.arc[i + 1] - nodes.arc[i], 1e-12);
      at += std::clamp(share, 0.0, 1.0) * side;
      solved += side;
    }
    const RedrawnEdge& edge = redrawn.outline[index(notch.edge)];
    draft.notches.push_back({edge.name, at / std::max(solved, 1e-12) * edge.fitted.curve.length(), notch.written});
  }

  std::vector<DraftEdgeRef> references(const Chain& chain) const {
    std::vector<DraftEdgeRef> all;
    for (const ChainLink& link : chain) {
      const Piece& piece = garment_.pieces[index(link.edge.piece)];
      const int outer = static_cast<int>(piece.edges.size());
      std::string name = names_[index(link.edge.piece)][index(link.edge.edge)];
      if (link.edge.edge >= outer) {
        int first = outer;
        for (std::size_t h = 0; h < piece.holes.size(); ++h) {
          const int count = static_cast<int>(piece.holes[h].size());
          if (link.edge.edge < first + count) name = fmt::format("hole{}.", h + 1) + name;
          if (link.edge.edge < first + count) break;
          first += count;
        }
      }
      all.push_back({as_name(piece.name), name, std::nullopt, piece.edge(link.edge.edge).written});
    }
    return all;
  }

  void add_seam(const Seam& seam) {
    DraftSeam draft;
    draft.first = references(seam.first);
    draft.second = references(seam.second);
    draft.reversed = seam.first.front().forward == seam.second.front().forward;
    draft.fullness = seam.fullness;
    if (seam.stated > 0) draft.stated = seam.stated;
    draft.written = seam.written;
    redrawn_.draft.seams.push_back(std::move(draft));
  }

  const Garment& garment_;
  const SewnMesh& mesh_;
  const Development& development_;
  double tolerance_;
  std::vector<std::vector<std::string>> names_;  // [piece][edge]
  Redrawn redrawn_;
};

}  // namespace

Redrawn redraw(const Garment& garment, const SewnMesh& mesh, const Development& development, double tolerance) {
  return Redrawing(garment, mesh, development, tolerance).redraw();
}

}  // namespace toile
