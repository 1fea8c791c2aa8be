#include <fmt/format.h>

#include "compiler/pattern/pattern.hpp"

namespace toile {
namespace {

void number_on(Chain& chain, PieceId first) {
  for (ChainLink& link : chain) link.edge.piece += first;
}

void add(const Garment& garment, Garment& all) {
  const auto first = static_cast<PieceId>(all.pieces.size());
  const auto layer = static_cast<int>(all.layers.size());
  for (Piece piece : garment.pieces) {
    piece.name = fmt::format("{}.{}", garment.name, piece.name);
    piece.drawn_name = fmt::format("{}.{}", garment.name, piece.drawn_name);
    piece.layer = layer;
    all.pieces.push_back(std::move(piece));
  }
  for (Seam seam : garment.seams) {
    number_on(seam.first, first);
    number_on(seam.second, first);
    all.seams.push_back(std::move(seam));
  }
  for (Wear wear : garment.wears) {
    number_on(wear.chain, first);
    all.wears.push_back(std::move(wear));
  }
  for (Arrangement at : garment.arrangements) {
    at.piece += first;
    all.arrangements.push_back(at);
  }
  all.layers.push_back({garment.name, garment.fabric, garment.textile});
}

}  // namespace

std::vector<FabricSheet> Garment::fabrics() const {
  if (layers.empty()) return {fabric};
  std::vector<FabricSheet> all;
  for (const WornLayer& layer : layers) all.push_back(layer.fabric);
  return all;
}

Garment worn_over_each_other(const std::vector<Garment>& inside_out) {
  if (inside_out.size() == 1) return inside_out.front();
  Garment all;
  for (const Garment& garment : inside_out) {
    add(garment, all);
    all.name = all.name.empty() ? garment.name : fmt::format("{} over {}", garment.name, all.name);
  }
  const Garment& outermost = inside_out.back();
  all.fabric = outermost.fabric;
  all.textile = outermost.textile;
  all.written = outermost.written;
  return all;
}

}  // namespace toile
