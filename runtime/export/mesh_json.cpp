// Both meshes as JSON, key by key as docs/formats.md has it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/export/export.hpp"
#include "runtime/export/json_layout.hpp"
#include "runtime/export/split_surface.hpp"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

Json coordinates(Vec2 point) {
  return Json::array({point.x, point.y});
}

Json edges_of_piece(const Piece& piece, const std::vector<PMesh::EdgeNodes>& nodes) {
  Json edges = Json::array();
  for (std::size_t e = 0; e < nodes.size(); ++e) {
    const PieceEdge& edge = piece.edge(static_cast<int>(e));
    edges.push_back({{"name", edge.name},
                     {"mirrored", edge.side == Side::Mirrored},
                     {"part", edge.part},
                     {"points", nodes[e].points},
                     {"arc_m", nodes[e].arc}});
  }
  return edges;
}

Json pieces(const Garment& garment, const PMesh& mesh) {
  const std::vector<PieceRange> ranges = piece_ranges(mesh, garment.pieces.size());
  Json pieces = Json::array();
  for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
    const Piece& piece = garment.pieces[i];
    pieces.push_back({{"name", piece.name},
                      {"mirrored", piece.side == Side::Mirrored},
                      {"warp", coordinates(mesh.warp_of_piece[i])},
                      {"first_point", ranges[i].first_point},
                      {"points", ranges[i].points},
                      {"first_triangle", ranges[i].first_triangle},
                      {"triangles", ranges[i].triangles},
                      {"edges", edges_of_piece(piece, mesh.edge_nodes[i])}});
  }
  return pieces;
}

Json p_mesh(const PMesh& mesh) {
  Json points = Json::array();
  for (const Vec2 point : mesh.points) points.push_back(coordinates(point));
  return {{"points_m", points}, {"triangles", mesh.triangles}};
}

Json edges(const SMesh& mesh) {
  Json edges = Json::array();
  for (const SMesh::Edge& edge : mesh.edges) {
    Json triangles = Json::array();
    for (const SMesh::Wing& wing : edge.wings) triangles.push_back(wing.triangle);
    edges.push_back({{"vertices", edge.vertices}, {"triangles", triangles}, {"seam", edge.seam}});
  }
  return edges;
}

Json worn_lines(const SMesh& mesh, const Garment& garment) {
  Json lines = Json::array();
  for (const SMesh::WornLine& worn : mesh.worn) {
    const Wear& wear = garment.wears[static_cast<std::size_t>(worn.wear)];
    lines.push_back({{"line", wear.line},
                     {"held", wear.held},
                     {"closed", worn.closed},
                     {"length_m", worn.length},
                     {"vertices", worn.vertices},
                     {"arc_m", worn.arc}});
  }
  return lines;
}

Json s_mesh(const SMesh& mesh, const Garment& garment) {
  const Topology& topology = mesh.topology;
  return {{"vertices", mesh.vertex_count},
          {"vertex_of_point", mesh.s_of_p},
          {"triangles", mesh.triangles},
          {"edges", edges(mesh)},
          {"worn", worn_lines(mesh, garment)},
          {"topology",
           {{"triangles", topology.triangles},
            {"vertices", topology.vertices},
            {"edges", topology.edges},
            {"boundary_loops", topology.boundary_loops},
            {"components", topology.components},
            {"euler", topology.euler},
            {"orientable", topology.orientable},
            {"manifold", topology.manifold}}}};
}

}  // namespace

std::string mesh_json(const Garment& garment, const SewnMesh& mesh) {
  Json seams = Json::array();
  for (const Seam& seam : garment.seams) seams.push_back(seam.name);
  const Json root{{"schema", 1},
                  {"garment", garment.name},
                  {"seams", seams},
                  {"pieces", pieces(garment, mesh.p)},
                  {"p_mesh", p_mesh(mesh.p)},
                  {"s_mesh", s_mesh(mesh.s, garment)}};
  return laid_out(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace toile
