#include "runtime/export/pattern_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/pattern/region.hpp"
#include "runtime/export/cut_line.hpp"

namespace toile {

namespace {

constexpr double kProportion = 1.4;  // width of the sheet to its height, roughly
constexpr int kGrid = 40;            // places looked at each way

double square_to(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  const Vec2 off = p - from - t * along;
  return dot(off, off);
}

// The straight bits that a writing must keep clear of.
std::vector<LineSegment> obstacles(const Piece& piece) {
  std::vector<LineSegment> lines;
  const auto add = [&](const std::vector<PieceEdge>& edges) {
    for (const PieceEdge& edge : edges) {
      const std::vector<double> cuts = edge.curve.divide(1e-3, 0.1);
      for (std::size_t i = 1; i < cuts.size(); ++i) {
        lines.push_back({edge.curve.at(cuts[i - 1]), edge.curve.at(cuts[i])});
      }
    }
  };
  add(piece.edges);
  for (const auto& hole : piece.holes) add(hole);
  for (const auto& line : piece.lines) add(line);
  if (piece.fold) lines.push_back(*piece.fold);
  return lines;
}

// Fills shelves of at most that width.
std::vector<Vec2> shelved(const std::vector<Box>& boxes, double gap, double limit, Vec2& size) {
  std::vector<Vec2> shifts;
  double x = 0, top = 0, shelf_height = 0;
  size = {0, 0};
  for (const Box& box : boxes) {
    if (x > 0 && x + box.width() > limit) {
      top -= shelf_height + gap;
      x = shelf_height = 0;
    }
    shifts.push_back({x - box.low.x, top - box.high.y});
    x += box.width() + gap;
    shelf_height = std::max(shelf_height, box.height());
    size = {std::max(size.x, x - gap), std::max(size.y, shelf_height - top)};
  }
  return shifts;
}

}  // namespace

void Box::add(Vec2 point) {
  low = {std::min(low.x, point.x), std::min(low.y, point.y)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y)};
}

std::vector<Vec2> on_shelves(const std::vector<Box>& boxes, double gap, Vec2& size) {
  double widest = 0;
  for (const Box& box : boxes) widest = std::max(widest, box.width());
  // The sheet is as wide as the first one, two, three … pieces together; the best proportion wins.
  std::vector<Vec2> best;
  double best_misfit = 1e300, limit = 0;
  for (const Box& last : boxes) {
    limit += last.width() + gap;
    Vec2 tried_size;
    std::vector<Vec2> tried = shelved(boxes, gap, std::max(limit, widest + gap), tried_size);
    const double misfit = std::abs(std::log(tried_size.x / tried_size.y / kProportion));
    if (misfit > best_misfit - 1e-9) continue;
    best_misfit = misfit;
    best = std::move(tried);
    size = tried_size;
  }
  return best;
}

std::vector<Vec2> on_shelves(const Garment& garment, double gap, Vec2& size) {
  std::vector<Box> boxes;
  for (const Piece& piece : garment.pieces) {
    Box box;
    for (const Vec2 point : cut_line(piece.edges)) box.add(point);
    boxes.push_back(box);
  }
  return on_shelves(boxes, gap, size);
}

Spot free_spot(const Piece& piece, const std::vector<Spot>& taken) {
  const Region outline(whole_outline(piece.edges));
  std::vector<Region> holes;
  for (const auto& hole : piece.holes) holes.emplace_back(whole_outline(hole));
  const std::vector<LineSegment> lines = obstacles(piece);
  Box box;
  for (const LineSegment& line : lines) box.add(line.from);

  // What has no more room than `least` need not be measured to the end; whether a place is inside is asked last.
  const auto clearance = [&](Vec2 p, double least) {
    double nearest = 1e150;
    for (const LineSegment& line : lines) {
      nearest = std::min(nearest, square_to(p, line.from, line.to));
      if (nearest <= least * least) return 0.0;
    }
    nearest = std::sqrt(nearest);
    for (const Spot& spot : taken) nearest = std::min(nearest, distance(p, spot.at) - 0.5 * spot.clearance);
    if (nearest <= least || !outline.contains(p)) return 0.0;
    const bool in_hole = std::any_of(holes.begin(), holes.end(), [&](const Region& hole) { return hole.contains(p); });
    return in_hole ? 0.0 : nearest;
  };
  Spot best{0.5 * (box.low + box.high), 0};
  for (int i = 1; i < kGrid; ++i) {
    for (int j = 1; j < kGrid; ++j) {
      const Vec2 p{box.low.x + box.width() * i / kGrid, box.low.y + box.height() * j / kGrid};
      const double room = clearance(p, best.clearance + 1e-6);
      if (room > 0) best = {p, room};
    }
  }
  return best;
}

}  // namespace toile
