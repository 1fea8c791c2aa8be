// All sizes of a flat pattern on one sheet, each drawn over the others, at true scale.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runtime/export/cut_line.hpp"
#include "runtime/export/export.hpp"
#include "runtime/export/pattern_layout.hpp"
#include "runtime/export/svg.hpp"

namespace toile {

namespace {

constexpr double kSheetMargin = 0.02, kBetween = 0.03;    // [m] around the sheet, between pieces
constexpr double kHeading = 0.011, kSmall = 0.0055;       // [m] letters
constexpr double kBesideCorner = 0.007, kSwatch = 0.012;  // [m] of a size's name from its corner; of the legend's lines

// Told apart in print and by the colour-blind (after Okabe and Ito).
constexpr const char* kSizeInks[] = {"#0072b2", "#b8500a", "#00795a", "#9b3d7d",
                                     "#4b4f9c", "#8a6d00", "#2f6f7e", "#7a3b2e"};

const char* ink(std::size_t size) {
  return kSizeInks[size % std::size(kSizeInks)];
}

const Piece* piece_called(const Garment& garment, const std::string& name) {
  const auto found = std::find_if(garment.pieces.begin(), garment.pieces.end(),
                                  [&](const Piece& piece) { return piece.name == name; });
  return found == garment.pieces.end() ? nullptr : &*found;
}

// One piece in all the sizes that have it.
class Nest {
 public:
  Nest(const std::vector<SizedGarment>& sizes, const std::string& name) : sizes_(sizes) {
    for (const SizedGarment& sized : sizes) pieces_.push_back(piece_called(sized.garment, name));
    for (const Piece* piece : pieces_) {
      if (piece == nullptr) continue;
      if (first_ == nullptr) first_ = piece;
      last_ = piece;
      for (const Vec2 point : cut_line(piece->edges)) box_.add(point);
    }
  }

  const Box& box() const { return box_; }

  std::string drawn() const {
    std::string drawing;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i] == nullptr) continue;
      drawing +=
          fmt::format("<g stroke=\"{0}\" fill=\"{0}\">\n", ink(i)) + lines(*pieces_[i]) + size_name(i) + "</g>\n";
    }
    const Spot name = free_spot(*first_, {});
    const double letters = std::clamp(name.clearance / 4.5, 0.004, 0.013);
    drawing += svg::text("bold", name.at + Vec2{0, 0.6 * letters}, letters, first_->name);
    drawing +=
        svg::text("soft", name.at - Vec2{0, 0.6 * letters}, 0.6 * letters, fmt::format("cut {}", first_->quantity));
    const Spot grain = free_spot(*first_, {name});
    const Vec2 half = std::clamp(0.75 * grain.clearance, 0.01, 0.09) * first_->warp;
    return drawing + svg::line("grain", grain.at - half, grain.at + half);
  }

 private:
  static std::string lines(const Piece& piece) {
    std::string drawing = svg::path("cut", svg::polygon_data(cut_line(piece.edges)));
    const auto stitched = [&](const std::vector<PieceEdge>& edges) {
      for (const PieceEdge& edge : edges) drawing += svg::path("stitch", svg::path_data({&edge.curve}, false));
    };
    stitched(piece.edges);
    for (const auto& hole : piece.holes) stitched(hole);
    for (const auto& line : piece.lines) stitched(line);
    for (const Notch& notch : piece.notches) {
      const PieceEdge& edge = piece.edge(notch.edge);
      const Vec2 at = edge.curve.at(notch.at), out = -perpendicular(edge.curve.tangent(notch.at));
      drawing += svg::line("cut", at - 0.002 * out, at + std::max(0.002, edge.allowance) * out);
    }
    return drawing;
  }

  // The corner that moves most from the first size to the last: there the sizes are told apart best.
  std::size_t telling_corner() const {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t e = 0; e < std::min(first_->edges.size(), last_->edges.size()); ++e) {
      const double moved = distance(first_->edges[e].curve.start(), last_->edges[e].curve.start());
      if (moved > most + 1e-9) {
        most = moved;
        best = e;
      }
    }
    return best;
  }

  std::string size_name(std::size_t size) const {
    const Piece& piece = *pieces_[size];
    const std::size_t corner = telling_corner();
    if (corner >= piece.edges.size()) return "";
    const Vec2 at = piece.edges[corner].curve.start(), inwards = 0.5 * (box_.low + box_.high) - at;
    const Vec2 beside = norm(inwards) > 0 ? kBesideCorner / norm(inwards) * inwards : Vec2{};
    return svg::text("size", at + beside, kSmall, sizes_[size].size);
  }

  const std::vector<SizedGarment>& sizes_;
  std::vector<const Piece*> pieces_;  // of each size, or null
  const Piece *first_ = nullptr, *last_ = nullptr;
  Box box_;
};

std::vector<std::string> piece_names(const std::vector<SizedGarment>& sizes) {
  std::vector<std::string> names;
  for (const SizedGarment& sized : sizes) {
    for (const Piece& piece : sized.garment.pieces) {
      if (std::find(names.begin(), names.end(), piece.name) == names.end()) names.push_back(piece.name);
    }
  }
  return names;
}

std::string legend(const std::vector<SizedGarment>& sizes, Vec2 at, double& width) {
  std::string drawing;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    drawing += fmt::format("<g stroke=\"{}\">\n", ink(i)) + svg::line("cut", at, at + Vec2{kSwatch, 0}) + "</g>\n";
    drawing += svg::text("left", at + Vec2{kSwatch + 0.003, 0}, kSmall, sizes[i].size);
    at.x += kSwatch + 0.012 + svg::text_width(sizes[i].size, kSmall);
  }
  width = at.x;
  return drawing;
}

}  // namespace

std::string nested_svg(const std::vector<SizedGarment>& sizes) {
  std::vector<Nest> nests;
  std::vector<Box> boxes;
  for (const std::string& name : piece_names(sizes)) {
    nests.emplace_back(sizes, name);
    boxes.push_back(nests.back().box());
  }
  Vec2 size;
  const std::vector<Vec2> shifts = on_shelves(boxes, kBetween, size);
  const double above = 3.4 * kHeading;
  double legend_width = 0;
  const std::string key = legend(sizes, {0, 0.7 * kHeading}, legend_width);
  const double width = std::max(size.x, legend_width) + 2 * kSheetMargin, height = above + size.y + 2 * kSheetMargin;
  std::string document = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} {3} {0} {1}\">\n"
      "<title>{4}: flat pattern, all sizes</title>\n",
      svg::mm(width), svg::mm(height), svg::mm(-kSheetMargin), svg::mm(-above - kSheetMargin),
      svg::escaped(sizes.front().garment.name));
  document +=
      "<style>\n"
      "path { fill: none; stroke-linejoin: round }\n"
      ".cut { stroke-width: .5; fill: none }\n"
      ".stitch { stroke-width: .3; stroke-dasharray: 4 2 }\n"
      ".grain { stroke: #22252b; stroke-width: .5 }\n"
      "text { font-family: Helvetica, Arial, \"Liberation Sans\", sans-serif; text-anchor: middle; fill: #22252b; "
      "stroke: "
      "none }\n"
      ".size { fill: inherit }\n"
      ".left { text-anchor: start }\n"
      ".bold { font-weight: bold }\n"
      ".soft { fill: #5b6270 }\n"
      "</style>\n";
  document += svg::text("left bold", {0, 2.2 * kHeading}, kHeading, sizes.front().garment.name) + key;
  for (std::size_t i = 0; i < nests.size(); ++i) {
    document += fmt::format("<g transform=\"translate({})\">\n", svg::place(shifts[i])) + nests[i].drawn() + "</g>\n";
  }
  return document + "</svg>\n";
}

}  // namespace toile
