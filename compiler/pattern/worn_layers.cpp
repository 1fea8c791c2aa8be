#include <fmt/format.h>

#include <algorithm>

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
  std::vector<FabricSheet> all;
  for (const WornLayer& layer : layers) all.push_back(layer.fabric);
  if (layers.empty()) all.push_back(fabric);
  for (const Piece& piece : pieces) {
    if (!piece.has_own_cloth()) continue;
    FabricSheet own = piece.fabric ? *piece.fabric : all[static_cast<std::size_t>(piece.layer)];
    own.plies = piece.plies;
    all.push_back(std::move(own));
  }
  return all;
}

std::vector<int> Garment::fabric_of_pieces() const {
  std::vector<int> numbers;
  int next = std::max(1, static_cast<int>(layers.size()));
  for (const Piece& piece : pieces) numbers.push_back(piece.has_own_cloth() ? next++ : piece.layer);
  return numbers;
}

std::string Piece::own_cloth() const {
  std::string told = fabric ? fabric->name : "";
  if (plies > 1) told += fmt::format("{}{} plies", told.empty() ? "" : ", ", plies);
  return told;
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
