#include "compiler/pmesh/mesher.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/pmesh/fan.hpp"
#include "compiler/pmesh/improve.hpp"

namespace toile {
namespace {

constexpr int kRounds = 12;              // of agreeing on the outlines; then they are frozen
constexpr double kShortest = 1.0 / 128;  // of the target edge
constexpr double kMostTriangles = 4e5;
constexpr double kCreaseSpacing = 0.7;  // of the target edge: nodes on a crease see each other before they see others

/// Options that cannot ask for more triangles than a machine holds.
PMeshOptions bounded(const Garment& garment, PMeshOptions options) {
  double area = 0, length = 0;
  for (const Piece& piece : garment.pieces) {
    area += area_of(piece);
    for (int e = 0; e < piece.edge_count(); ++e) length += piece.edge(e).curve.length();
  }
  const double least = std::max({std::sqrt(area / (0.41 * kMostTriangles)), length / kMostTriangles, 1e-6});
  if (!(options.target_edge > 0)) options.target_edge = PMeshOptions{}.target_edge;
  options.target_edge = std::max(options.target_edge, least);
  options.chord_error = std::clamp(options.chord_error, 1e-6, 1.0);
  options.least_divisions = std::clamp(options.least_divisions, 1, 1000);
  return options;
}

}  // namespace

double area_of(const Piece& piece) {
  double twice = 0;
  const auto add = [&](const std::vector<PieceEdge>& loop) {
    for (const PieceEdge& edge : loop) {
      constexpr int kChords = 32;
      const double length = edge.curve.length();
      for (int i = 0; i < kChords; ++i) {
        twice += cross(edge.curve.at(length * i / kChords), edge.curve.at(length * (i + 1) / kChords));
      }
    }
  };
  add(piece.edges);
  for (const auto& hole : piece.holes) add(hole);
  return std::abs(twice) / 2;
}

GarmentMesher::GarmentMesher(const Garment& garment, const PMeshOptions& options)
    : garment_(garment),
      options_(bounded(garment, options)),
      division_(garment, options_),
      pieces_(garment.pieces.size()) {
  for (PieceState& piece : pieces_) {
    piece.size.edge = options_.target_edge;
    piece.size.shortest = kShortest * options_.target_edge;
  }
}

PlaneDomain GarmentMesher::lay_out(PieceState& piece, PieceId id) const {
  PlaneDomain domain;
  piece.outline.clear();
  piece.loop_begin.clear();
  const auto& loops = division_.bundles().loops[id];
  const int closed = division_.bundles().closed[id];
  for (int loop = 0; loop < closed; ++loop) {
    const auto& edges = loops[loop];
    piece.loop_begin.push_back(static_cast<int>(piece.outline.size()));
    std::vector<Vec2>& nodes = domain.loops.emplace_back();
    for (const int edge : edges) {
      const auto& points = division_.points(edge);
      for (int i = 0; i + 1 < static_cast<int>(points.size()); ++i) {
        nodes.push_back(points[i]);
        piece.outline.push_back({edge, i});
      }
    }
  }
  piece.loop_begin.push_back(static_cast<int>(piece.outline.size()));
  lay_out_lines(piece, id, domain);
  pin_creases(id, domain);
  pin_tucks(id, domain);
  add_pins(piece, domain);
  return domain;
}

/// Edges of lines begin and end at nodes that they share with each other, or with the outline.
void GarmentMesher::lay_out_lines(PieceState& piece, PieceId id, PlaneDomain& domain) const {
  piece.line_sides.clear();
  piece.line_points.clear();
  const Bundles& bundles = division_.bundles();
  std::vector<Vec2> corners;
  std::vector<int> corner_points;
  const int outline = static_cast<int>(piece.outline.size());
  const auto add = [&](Vec2 p) {
    domain.line_nodes.push_back(p);
    return outline + static_cast<int>(domain.line_nodes.size()) - 1;
  };
  const auto corner = [&](Vec2 p) {
    constexpr double kSameCorner = 2e-6;  // [m]
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (distance(corners[i], p) < kSameCorner) return corner_points[i];
    }
    corners.push_back(p);
    corner_points.push_back(add(p));
    return corner_points.back();
  };
  const auto& loops = bundles.loops[id];
  if (bundles.closed[id] < static_cast<int>(loops.size())) {
    int point = 0;
    for (const auto& loop : domain.loops) {
      for (const Vec2 p : loop) {
        corners.push_back(p);
        corner_points.push_back(point++);
      }
    }
  }
  for (std::size_t line = bundles.closed[id]; line < loops.size(); ++line) {
    std::vector<OutlineNode>& sides = piece.line_sides.emplace_back();
    std::vector<int>& nodes = domain.lines.emplace_back();
    for (const int edge : loops[line]) {
      const auto& places = division_.points(edge);
      std::vector<int>& own = piece.line_points.emplace_back();
      for (int i = 0; i < static_cast<int>(places.size()); ++i) {
        const bool is_end = i == 0 || i + 1 == static_cast<int>(places.size());
        own.push_back(is_end ? corner(places[i]) : add(places[i]));
        if (i > 0) sides.push_back({edge, i - 1});
      }
      nodes.insert(nodes.end(), own.begin() + (nodes.empty() ? 0 : 1), own.end());
    }
  }
  piece.points_on_lines = static_cast<int>(domain.line_nodes.size());
}

/// How far a crease is from the nearest other one of its piece [m], by their middles.
double GarmentMesher::room_beside(const LineMark& crease, const Piece& piece) {
  const Vec2 middle = crease.curve.at(crease.curve.length() / 2);
  double nearest = 1e300;
  for (const LineMark& mark : piece.marks) {
    if (&mark == &crease || !mark.folded()) continue;
    nearest = std::min(nearest, distance(middle, mark.curve.at(mark.curve.length() / 2)));
  }
  return nearest;
}

/// Nodes along creases, so that edges lie on them.
void GarmentMesher::pin_creases(PieceId id, PlaneDomain& domain) const {
  for (const LineMark& mark : garment_.pieces[id].marks) {
    if (!mark.folded()) continue;
    const double length = mark.curve.length();
    const double spacing =
        std::max(kCreaseSpacing * std::min(options_.target_edge, room_beside(mark, garment_.pieces[id])),
                 pieces_[id].size.shortest);
    const int parts = static_cast<int>(std::ceil(length / spacing));
    for (int i = 1; i < parts; ++i) domain.pins.push_back(mark.curve.at(length * i / parts));
  }
}

/// Nodes halfway between two lines that are sewn to each other: there the cloth folds.
void GarmentMesher::pin_tucks(PieceId id, PlaneDomain& domain) const {
  const Piece& piece = garment_.pieces[id];
  const auto place_on = [&](const Chain& chain, double at) {
    for (const ChainLink& link : chain) {
      const Curve& curve = piece.edge(link.edge.edge).curve;
      if (at <= curve.length() || &link == &chain.back()) return curve.at(link.forward ? at : curve.length() - at);
      at -= curve.length();
    }
    return Vec2{};
  };
  for (const Seam& seam : garment_.seams) {
    const bool own =
        std::all_of(seam.first.begin(), seam.first.end(),
                    [&](const ChainLink& link) { return link.edge.piece == id && piece.is_inside(link.edge.edge); }) &&
        std::all_of(seam.second.begin(), seam.second.end(),
                    [&](const ChainLink& link) { return link.edge.piece == id && piece.is_inside(link.edge.edge); });
    if (!own || seam.open) continue;
    double first = 0, second = 0;
    for (const ChainLink& link : seam.first) first += piece.edge(link.edge.edge).curve.length();
    for (const ChainLink& link : seam.second) second += piece.edge(link.edge.edge).curve.length();
    const double apart = distance(place_on(seam.first, first / 2), place_on(seam.second, second / 2));
    const double spacing =
        std::max(kCreaseSpacing * std::min(options_.target_edge, apart / 2), pieces_[id].size.shortest);
    const int parts = std::max(1, static_cast<int>(std::ceil(first / spacing)));
    for (int i = 1; i < parts; ++i) {
      const Vec2 a = place_on(seam.first, first * i / parts), b = place_on(seam.second, second * i / parts);
      if (distance(a, b) > 0.5 * spacing) domain.pins.push_back(0.5 * (a + b));
    }
  }
}

void GarmentMesher::add_pins(const PieceState& piece, PlaneDomain& domain) const {
  for (const Fan& fan : piece.fans) {
    for (int loop = 0; loop + 1 < static_cast<int>(piece.loop_begin.size()); ++loop) {
      const int begin = piece.loop_begin[loop], n = piece.loop_begin[loop + 1] - begin;
      for (int i = 0; i < n; ++i) {
        const OutlineNode& node = piece.outline[begin + i];
        if (node.edge != fan.edge || std::abs(division_.arcs(node.edge)[node.node] - fan.arc) > 1e-9) continue;
        add_fan(domain, loop, i, fan.sectors);
      }
    }
  }
}

std::vector<SideSplit> GarmentMesher::wishes(const PieceState& piece) const {
  std::vector<SideSplit> all;
  for (const OutlineSplit& split : piece.triangulation.wanted) {
    const int closed = static_cast<int>(piece.loop_begin.size()) - 1;
    const OutlineNode& node = split.loop < closed ? piece.outline[piece.loop_begin[split.loop] + split.from]
                                                  : piece.line_sides[split.loop - closed][split.from];
    all.push_back({node.edge, node.node, split.fraction});
  }
  return all;
}

void GarmentMesher::apply_splits() {
  for (const int edge : division_.split(splits_)) pieces_[division_.bundles().edges[edge].piece].stale = true;
  splits_.clear();
}

void GarmentMesher::triangulate_piece(PieceId id, Outline outline) {
  PieceState& piece = pieces_[id];
  piece.triangulation = triangulate(lay_out(piece, id), piece.size, outline);
  piece.stale = piece.improved = false;
  const std::vector<SideSplit> more = wishes(piece);
  splits_.insert(splits_.end(), more.begin(), more.end());
}

void GarmentMesher::settle() {
  apply_splits();
  for (int round = 0; round < kRounds; ++round) {
    for (PieceId id = 0; id < static_cast<int>(pieces_.size()); ++id) {
      if (pieces_[id].stale) triangulate_piece(id, Outline::MayAsk);
    }
    if (splits_.empty()) break;
    apply_splits();
  }
  // Out of rounds, or sides too short to divide: the rest make do with the outline as it is.
  for (PieceId id = 0; id < static_cast<int>(pieces_.size()); ++id) {
    if (pieces_[id].stale || !pieces_[id].triangulation.wanted.empty()) triangulate_piece(id, Outline::Frozen);
  }
}

int GarmentMesher::count() {
  settle();
  std::size_t triangles = 0;
  for (const PieceState& piece : pieces_) triangles += piece.triangulation.triangles.size();
  return static_cast<int>(triangles);
}

int GarmentMesher::point(EdgeNode node) const {
  const PieceId id = division_.bundles().edges[node.edge].piece;
  const PieceState& piece = pieces_[id];
  const Bundles& bundles = division_.bundles();
  if (bundles.edges[node.edge].loop >= bundles.closed[id]) {
    const int first_of_lines = bundles.loops[id][bundles.closed[id]].front();
    return first_point_[id] + piece.line_points[node.edge - first_of_lines][node.node];
  }
  // The outline lists edges in their flat order, each without its last node, which is the next one's first.
  const auto first = std::lower_bound(piece.outline.begin(), piece.outline.end(), node.edge,
                                      [](const OutlineNode& n, int edge) { return n.edge < edge; });
  int at = static_cast<int>(first - piece.outline.begin()) + node.node;
  const int loop = bundles.edges[node.edge].loop;
  if (at == piece.loop_begin[loop + 1]) at = piece.loop_begin[loop];
  return first_point_[id] + at;
}

PMesh GarmentMesher::mesh() {
  settle();
  PMesh mesh;
  first_point_.clear();
  mesh.fabric_of_piece = garment_.fabric_of_pieces();
  for (PieceId id = 0; id < static_cast<int>(pieces_.size()); ++id) {
    PieceState& piece = pieces_[id];
    Triangulation& t = piece.triangulation;
    if (!piece.improved) improve(t.points, t.triangles, t.fixed, piece.line_points);
    piece.improved = true;
    const int first = static_cast<int>(mesh.points.size());
    first_point_.push_back(first);
    mesh.points.insert(mesh.points.end(), t.points.begin(), t.points.end());
    mesh.piece_of_point.resize(mesh.points.size(), id);
    for (const auto& [a, b, c] : t.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.piece_of_triangle.resize(mesh.triangles.size(), id);
    mesh.warp_of_piece.push_back(garment_.pieces[id].warp);
    mesh.layer_of_piece.push_back(garment_.pieces[id].layer);

    auto& edge_nodes = mesh.edge_nodes.emplace_back();
    for (const auto& loop : division_.bundles().loops[id]) {
      for (const int edge : loop) {
        PMesh::EdgeNodes& nodes = edge_nodes.emplace_back();
        nodes.arc = division_.arcs(edge);
        for (int i = 0; i < static_cast<int>(nodes.arc.size()); ++i) nodes.points.push_back(point({edge, i}));
      }
    }
  }
  for (const auto& runs : division_.sewn_nodes()) {
    auto& sewn = mesh.sewn.emplace_back();
    for (const auto& run : runs) {
      PMesh::SewnRun& joined = sewn.emplace_back();
      for (const auto& [a, b] : run) {
        joined.first.push_back(point(a));
        joined.second.push_back(point(b));
      }
    }
  }
  return mesh;
}

PieceId GarmentMesher::piece_of(int point) const {
  const auto after = std::upper_bound(first_point_.begin(), first_point_.end(), point);
  return static_cast<PieceId>(after - first_point_.begin()) - 1;
}

bool GarmentMesher::is_on_outline(int point) const {
  const PieceId id = piece_of(point);
  return point - first_point_[id] < static_cast<int>(pieces_[id].outline.size());
}

bool GarmentMesher::is_on_line(int point) const {
  const PieceState& piece = pieces_[piece_of(point)];
  const int own = point - first_point_[piece_of(point)], outline = static_cast<int>(piece.outline.size());
  if (own >= outline) return own < outline + piece.points_on_lines;
  return std::any_of(piece.line_points.begin(), piece.line_points.end(),
                     [&](const std::vector<int>& points) { return points.front() == own || points.back() == own; });
}

void GarmentMesher::want_side_split(int a, int b) {
  const PieceId id =
      static_cast<PieceId>(std::upper_bound(first_point_.begin(), first_point_.end(), a) - first_point_.begin() - 1);
  const PieceState& piece = pieces_[id];
  const int from = a - first_point_[id], to = b - first_point_[id];
  for (std::size_t loop = 0; loop + 1 < piece.loop_begin.size(); ++loop) {
    const int begin = piece.loop_begin[loop], end = piece.loop_begin[loop + 1];
    if (from < begin || from >= end || to < begin || to >= end) continue;
    const auto next = [&](int i) { return i + 1 == end ? begin : i + 1; };
    const int start = next(from) == to ? from : to;
    splits_.push_back({piece.outline[start].edge, piece.outline[start].node, 0.5});
  }
}

void GarmentMesher::want_smaller(PieceId id, Vec2 centre, double radius, double edge) {
  pieces_[id].size.spots.push_back({centre, radius, edge});
  pieces_[id].size.shortest = std::min(pieces_[id].size.shortest, edge / 4);
  pieces_[id].stale = true;
}

bool GarmentMesher::want_fan(int point, int sectors) {
  if (!is_on_outline(point)) return false;
  const PieceId id = piece_of(point);
  PieceState& piece = pieces_[id];
  const OutlineNode& node = piece.outline[point - first_point_[id]];
  const double arc = division_.arcs(node.edge)[node.node];
  const bool there = std::any_of(piece.fans.begin(), piece.fans.end(),
                                 [&](const Fan& fan) { return fan.edge == node.edge && fan.arc == arc; });
  if (there) return false;
  piece.fans.push_back({node.edge, arc, sectors});
  piece.stale = true;
  return true;
}

}  // namespace toile
