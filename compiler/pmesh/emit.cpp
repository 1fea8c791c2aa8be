#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compiler/pmesh/pmesh.hpp"

namespace toile {
namespace {

/// Millimetres with four decimals; a rounded zero has no sign.
std::string mm(double metres) {
  std::string text = fmt::format("{:.4f}", metres * 1000);
  return text == "-0.0000" ? "0.0000" : text;
}

std::string side_of(const PieceEdge& edge) {
  std::string text = edge.name;
  if (edge.side == Side::Mirrored) text += ".mirrored";
  if (edge.part > 0) text += fmt::format("[{}]", edge.part);
  return text;
}

void emit_piece(const PMesh& mesh, const Garment& garment, PieceId piece, fmt::memory_buffer& out) {
  const auto to = std::back_inserter(out);
  const auto range = [&](const std::vector<PieceId>& owners) {
    const auto [first, last] = std::equal_range(owners.begin(), owners.end(), piece);
    return std::pair(static_cast<int>(first - owners.begin()), static_cast<int>(last - owners.begin()));
  };
  const auto [point_begin, point_end] = range(mesh.piece_of_point);
  const auto [triangle_begin, triangle_end] = range(mesh.piece_of_triangle);
  const Vec2 warp = mesh.warp_of_piece[piece];
  fmt::format_to(to, "piece {}: {} vertices, {} triangles, warp {} {}\n", garment.pieces[piece].name,
                 point_end - point_begin, triangle_end - triangle_begin, mm(warp.x / 1000), mm(warp.y / 1000));
  for (std::size_t e = 0; e < mesh.edge_nodes[piece].size(); ++e) {
    fmt::format_to(to, "  edge {}:", side_of(garment.pieces[piece].edge(static_cast<int>(e))));
    for (const int p : mesh.edge_nodes[piece][e].points) fmt::format_to(to, " {}", p);
    fmt::format_to(to, "\n  at:");
    for (const double s : mesh.edge_nodes[piece][e].arc) fmt::format_to(to, " {}", mm(s));
    fmt::format_to(to, "\n");
  }
  for (int p = point_begin; p < point_end; ++p) {
    fmt::format_to(to, "  v {} {} {}\n", p, mm(mesh.points[p].x), mm(mesh.points[p].y));
  }
  for (int t = triangle_begin; t < triangle_end; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    fmt::format_to(to, "  t {} {} {} {}\n", t, a, b, c);
  }
}

}  // namespace

std::string emit(const PMesh& mesh, const Garment& garment) {
  fmt::memory_buffer out;
  fmt::format_to(std::back_inserter(out), "pmesh {}: {} pieces, {} vertices, {} triangles, lengths in mm\n",
                 garment.name, garment.pieces.size(), mesh.points.size(), mesh.triangles.size());
  for (PieceId piece = 0; piece < static_cast<int>(garment.pieces.size()); ++piece) {
    emit_piece(mesh, garment, piece, out);
  }
  for (std::size_t s = 0; s < mesh.sewn.size(); ++s) {
    fmt::format_to(std::back_inserter(out), "seam {}:", garment.seams[s].name);
    for (const PMesh::SewnRun& run : mesh.sewn[s]) {
      for (std::size_t i = 0; i < run.first.size(); ++i) {
        fmt::format_to(std::back_inserter(out), " {}{}={}", i == 0 ? "| " : "", run.first[i], run.second[i]);
      }
    }
    fmt::format_to(std::back_inserter(out), "\n");
  }
  return fmt::to_string(out);
}

}  // namespace toile
