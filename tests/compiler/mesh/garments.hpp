// Small garments put together by hand.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "compiler/pattern/pattern.hpp"

namespace toile::test {

using std::numbers::pi;

inline PieceEdge edge(std::string name, Curve curve) {
  PieceEdge e;
  e.name = std::move(name);
  e.curve = std::move(curve);
  return e;
}

inline Piece piece(std::string name, std::vector<PieceEdge> edges) {
  Piece p;
  p.name = p.drawn_name = std::move(name);
  p.edges = std::move(edges);
  return p;
}

/// Straight edges from corner to corner, "0", "1", …
inline Piece polygon(std::string name, const std::vector<Vec2>& corners) {
  std::vector<PieceEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.push_back(edge(std::to_string(i), line(corners[i], corners[(i + 1) % corners.size()])));
  }
  return piece(std::move(name), std::move(edges));
}

/// Edges 0 bottom, 1 right, 2 top, 3 left.
inline Piece rectangle(std::string name, double width, double height) {
  return polygon(std::move(name), {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

/// Edges 0 first leg (outwards), 1 the arc, 2 second leg (inwards); the tip is at the origin.
inline Piece sector(std::string name, double radius, double angle) {
  const Vec2 a{radius, 0}, b = radius * direction(angle);
  return piece(std::move(name),
               {edge("leg", line({0, 0}, a)), edge("hem", arc_through(a, radius * direction(angle / 2), b)),
                edge("other", line(b, {0, 0}))});
}

/// Two curved sides from the rim up to the tip; edges 0 rim, 1 right side, 2 left side.
inline Piece gore(std::string name, double width, double height) {
  const double w = width / 2;
  return piece(std::move(name),
               {edge("rim", line({-w, 0}, {w, 0})),
                edge("right", bezier({w, 0}, {w, 0.35 * height}, {0.6 * w, 0.7 * height}, {0, height})),
                edge("left", bezier({0, height}, {-0.6 * w, 0.7 * height}, {-w, 0.35 * height}, {-w, 0}))});
}

inline Piece disc(std::string name, double radius) {
  return piece(std::move(name), {edge("rim", circle({0, 0}, {radius, 0}))});
}

inline Chain chain(std::initializer_list<ChainLink> links) {
  return links;
}
inline ChainLink along(PieceId piece, int edge) {
  return {{piece, edge}, true};
}
inline ChainLink against(PieceId piece, int edge) {
  return {{piece, edge}, false};
}

inline void sew_chains(Garment& garment, Chain first, Chain second) {
  Seam seam;
  seam.name = std::to_string(garment.seams.size() + 1);
  seam.first = std::move(first);
  seam.second = std::move(second);
  garment.seams.push_back(std::move(seam));
}

inline Garment garment(std::string name, std::vector<Piece> pieces) {
  Garment g;
  g.name = std::move(name);
  g.pieces = std::move(pieces);
  return g;
}

inline Garment tube(double girth = 0.6, double height = 0.3) {
  Garment g = garment("tube", {rectangle("cloth", girth, height)});
  sew_chains(g, {along(0, 1)}, {against(0, 3)});
  return g;
}

inline Garment cone(double angle) {
  Garment g = garment("cone", {sector("cloth", 0.3, angle)});
  sew_chains(g, {along(0, 0)}, {against(0, 2)});
  return g;
}

inline Garment cap(int gores) {
  Garment g = garment("cap", {});
  for (int i = 0; i < gores; ++i) g.pieces.push_back(gore(std::to_string(i), 0.56 / gores, 0.18));
  for (int i = 0; i < gores; ++i) sew_chains(g, {along(i, 1)}, {against((i + 1) % gores, 2)});
  return g;
}

/// A square with its opposite edges sewn, each pair straight or turned round.
inline Garment closed_square(bool turn_sides, bool turn_ends, double width = 0.5, double height = 0.4) {
  Garment g = garment("square", {rectangle("cloth", width, height)});
  sew_chains(g, {along(0, 1)}, {turn_sides ? along(0, 3) : against(0, 3)});
  sew_chains(g, {along(0, 0)}, {turn_ends ? along(0, 2) : against(0, 2)});
  return g;
}
inline Garment torus() {
  return closed_square(false, false);
}
inline Garment klein_bottle() {
  return closed_square(true, false);
}
inline Garment projective_plane() {
  return closed_square(true, true);
}

inline Garment moebius_strip() {
  Garment g = garment("moebius", {rectangle("cloth", 0.6, 0.1)});
  sew_chains(g, {along(0, 1)}, {along(0, 3)});
  return g;
}

inline Garment sphere_of_two_discs(double radius = 0.2) {
  Garment g = garment("sphere", {disc("upper", radius), disc("lower", radius)});
  sew_chains(g, {along(0, 0)}, {against(1, 0)});
  return g;
}

/// A full flared panel with a dart at its waist. Edges: 0 waist, 1 and 2 the dart's legs, 3 waist, 4 side, 5 hem, 6
/// side.
inline Piece skirt_panel(std::string name, double waist, double length, double flare) {
  const double w = waist / 2;
  const Vec2 left{-w, 0.012}, right{w, 0.012}, low_left{-w - flare, -length}, low_right{w + flare, -length};
  const Vec2 mouth_left{-0.0125, 0}, mouth_right{0.0125, 0}, tip{0, -0.09};
  return piece(std::move(name),
               {edge("waist", tangent_curve(right, pi + 0.17, mouth_right, pi)),
                edge("dart.left", line(mouth_right, tip)), edge("dart.right", line(tip, mouth_left)),
                edge("waist", tangent_curve(mouth_left, pi, left, pi - 0.17)), edge("side", line(left, low_left)),
                edge("hem", tangent_curve(low_left, -0.25, low_right, 0.25)), edge("side", line(low_right, right))});
}

inline Garment flared_skirt() {
  Garment g = garment("skirt", {skirt_panel("front", 0.4, 0.6, 0.14), skirt_panel("back", 0.4, 0.6, 0.14)});
  sew_chains(g, {along(0, 1)}, {against(0, 2)});
  sew_chains(g, {along(1, 1)}, {against(1, 2)});
  sew_chains(g, {along(0, 4)}, {against(1, 6)});
  sew_chains(g, {along(1, 4)}, {against(0, 6)});
  g.wears.push_back({{along(0, 0), along(0, 3), along(1, 0), along(1, 3)}, "waist", true, 0, {}});
  return g;
}

}  // namespace toile::test
