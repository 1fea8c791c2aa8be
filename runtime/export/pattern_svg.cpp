// The flat pattern on paper, at true scale.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "runtime/export/cut_line.hpp"
#include "runtime/export/export.hpp"
#include "runtime/export/pattern_layout.hpp"
#include "runtime/export/pattern_marks.hpp"
#include "runtime/export/svg.hpp"

namespace toile {

namespace {

using std::numbers::pi;
constexpr double kMargin = 0.02, kGap = 0.025;  // [m] around the sheet, between pieces
constexpr double kTitle = 0.011, kNote = 0.0055,
                 kLine = 0.0085;                        // [m] letters and line spacing of the sheet's own text
constexpr double kFullSize = 0.07;                      // [m] what is written at shorter edges is smaller, down to half
constexpr double kEdgeText = 0.0062, kInside = 0.0085;  // [m] letters along edges, and how far inside they run
constexpr double kMarkText = 0.0055;                    // [m] letters at the fold and the grain
constexpr double kBadge = 0.005;                        // [m] radius of a seam's letter

constexpr const char* kStyle = R"(<style>
path { fill: none; stroke: #22252b; stroke-linejoin: round; stroke-linecap: round }
.cloth { fill: #fbf8f1; stroke-width: .7 }
.opening { fill: #ffffff; stroke-width: .7 }
.stitch { stroke: #5b6270; stroke-width: .4; stroke-dasharray: 4 2 }
.grain { stroke-width: .55 }
.head { fill: #22252b; stroke: none }
.bar { stroke-width: .5; stroke-linecap: butt }
.ink { fill: #22252b; stroke: none }
text { font-family: Helvetica, Arial, "Liberation Sans", sans-serif; fill: #22252b; text-anchor: middle;
       paint-order: stroke; stroke: #fbf8f1; stroke-width: 1 }
.left { text-anchor: start }
.bold { font-weight: bold }
.soft { fill: #5b6270 }
.badge { fill: #ffffff; stroke: none; font-weight: bold }
)";

// Inks that stay apart in print and for the colour-blind (after Okabe and Ito), dark enough for white letters.
constexpr const char* kInks[] = {"#0072b2", "#b8500a", "#00795a", "#9b3d7d",
                                 "#4b4f9c", "#8a6d00", "#2f6f7e", "#7a3b2e"};

struct Letter {
  std::string text;  // A … Z, AA …
  std::string ink;
};

Letter letter(int index) {
  std::string text;
  for (int rest = index; rest >= 0; rest = rest / 26 - 1) text.insert(text.begin(), static_cast<char>('A' + rest % 26));
  return {text, kInks[static_cast<std::size_t>(index) % std::size(kInks)]};
}

std::string centimetres(double metres) {
  return fmt::format("{:.1f} cm", 100 * metres);
}

// What the edges of a piece take part in, by piece and edge.
struct Roles {
  std::map<std::pair<int, int>, Letter> sewn;
  std::map<std::pair<int, int>, std::string> worn;
  std::vector<std::pair<Letter, std::string>> legend;
};

std::string legend_text(const Seam& seam) {
  switch (seam.fullness) {
    case Seam::Fullness::None:
      return seam.name;
    case Seam::Fullness::Ease:
      return seam.name + ", eased" + (seam.stated > 0 ? " " + centimetres(seam.stated) : "");
    case Seam::Fullness::Gather:
      return seam.name + ", gathered" + (seam.stated > 0 ? " " + centimetres(seam.stated) : "");
    case Seam::Fullness::Stretch:
      return seam.name + ", stretched" + (seam.stated > 0 ? " " + centimetres(seam.stated) : "");
  }
  return seam.name;
}

Roles roles_of(const Garment& garment) {
  Roles roles;
  for (const Seam& seam : garment.seams) {
    if (seam.is_dart || seam.is_pleat) continue;
    const Letter sign = letter(static_cast<int>(roles.legend.size()));
    roles.legend.emplace_back(sign, legend_text(seam));
    for (const Chain* chain : {&seam.first, &seam.second}) {
      for (const ChainLink& link : *chain) roles.sewn[{link.edge.piece, link.edge.edge}] = sign;
    }
  }
  for (const Wear& wear : garment.wears) {
    for (const ChainLink& link : wear.chain) roles.worn[{link.edge.piece, link.edge.edge}] = wear.line;
  }
  return roles;
}

std::string badge(Vec2 at, const Letter& sign, double scale = 1) {
  const double radius = scale * (sign.text.size() > 1 ? 1.3 * kBadge : kBadge);
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", svg::mm(at.x), svg::mm(-at.y),
                     svg::mm(radius), sign.ink) +
         svg::text("badge", at, scale * 1.25 * kBadge, sign.text);
}

// Text along a line is never upside down.
double upright(Vec2 tangent) {
  const double angle = std::atan2(tangent.y, tangent.x);
  return angle > pi / 2 + 1e-6 ? angle - pi : angle <= -pi / 2 + 1e-6 ? angle + pi : angle;
}

std::string arrow(Vec2 middle, Vec2 along, double length) {
  std::string drawing;
  for (const double end : {-1.0, 1.0}) {
    const Vec2 tip = middle + end * length / 2 * along, side = 0.0017 * perpendicular(along);
    const Vec2 base = tip - end * 0.006 * along;
    drawing += svg::line("grain", middle, base) + svg::path("head", svg::polygon_data({tip, base + side, base - side}));
  }
  return drawing;
}

// Draws one piece, in its own coordinates.
class Sheet {
 public:
  Sheet(const Piece& piece, int index, const Roles& roles) : piece_(piece), index_(index), roles_(roles) {}

  std::string drawn() const { return cloth() + lines() + marks_svg(piece_) + writing() + edges(); }

 private:
  static std::vector<const Curve*> curves(const std::vector<PieceEdge>& edges, bool legs) {
    std::vector<const Curve*> found;
    for (const PieceEdge& edge : edges) {
      if (legs || !edge.is_dart_leg) found.push_back(&edge.curve);
    }
    return found;
  }

  // Cloth up to the cut line, and the stitching line within where there is an allowance.
  static std::string loop(const std::vector<PieceEdge>& edges, const char* fill) {
    const bool allowed =
        std::any_of(edges.begin(), edges.end(), [](const PieceEdge& edge) { return edge.allowance > 0; });
    if (!allowed) return svg::path(fill, svg::path_data(curves(edges, true), true));
    std::string drawing = svg::path(fill, svg::polygon_data(cut_line(edges)));
    for (const Curve* curve : curves(edges, false)) drawing += svg::path("stitch", svg::path_data({curve}, false));
    return drawing;
  }

  std::string cloth() const {
    std::string drawing = loop(piece_.edges, "cloth");
    for (const auto& hole : piece_.holes) {
      const bool is_dart = std::all_of(hole.begin(), hole.end(), [](const PieceEdge& e) { return e.is_dart_leg; });
      if (!is_dart) drawing += loop(hole, "opening");
    }
    return drawing;
  }

  std::string lines() const {
    std::string drawing;
    for (const auto& line : piece_.lines) drawing += svg::path("stitch", svg::path_data(curves(line, true), false));
    return drawing;
  }

  std::string writing() const {
    const Spot name = free_spot(piece_, {});
    const double size = std::clamp(name.clearance / 4.5, 0.004, 0.013);
    const std::string quantity = fmt::format("cut {}{}{}", piece_.quantity, piece_.fold ? ", unfolded" : "",
                                             piece_.has_own_cloth() ? ", " + piece_.own_cloth() : "");
    std::string drawing = svg::text("bold", name.at + Vec2{0, 0.6 * size}, size, piece_.name) +
                          svg::text("soft", name.at - Vec2{0, 0.6 * size}, 0.6 * size, quantity);
    if (!piece_.label.empty()) {
      drawing += svg::text("soft", name.at - Vec2{0, 1.5 * size}, 0.6 * size, piece_.label);
    }
    const Spot grain = free_spot(piece_, {name});
    const double length = std::clamp(1.5 * grain.clearance, 0.02, 0.18);
    drawing += arrow(grain.at, piece_.warp, length);
    const double beside = 0.006;
    const double angle = upright(piece_.warp);
    drawing += svg::text("soft", grain.at + beside * perpendicular(direction(angle)), kMarkText, "grain", angle);
    if (piece_.fold) drawing += fold_text();
    return drawing;
  }

  std::string fold_text() const {
    const Vec2 along = piece_.fold->to - piece_.fold->from;
    const double angle = upright(along / norm(along));
    const Vec2 at = 0.5 * (piece_.fold->from + piece_.fold->to) + 0.0045 * perpendicular(direction(angle));
    return svg::text("soft", at, kMarkText, "fold", angle);
  }

  // A divided edge is labelled once, on its longest part; parts that are sewn elsewhere have their own letters.
  std::string edges() const {
    std::map<std::pair<std::string, Side>, std::pair<int, double>> labelled;  // longest part, whole length
    for (int i = 0; i < piece_.edge_count(); ++i) {
      const PieceEdge& edge = piece_.edge(i);
      if (edge.is_dart_leg || edge.folded_under) continue;
      auto [entry, fresh] = labelled.insert({{edge.name, edge.side}, {i, edge.curve.length()}});
      if (fresh) continue;
      auto& [longest, length] = entry->second;
      length += edge.curve.length();
      if (edge.curve.length() > piece_.edge(longest).curve.length()) longest = i;
    }
    std::string drawing;
    for (const auto& [name, where] : labelled) drawing += edge_label(where.first, where.second);
    for (int i = 0; i < piece_.edge_count(); ++i) {
      const PieceEdge& edge = piece_.edge(i);
      const auto sewn = roles_.sewn.find({index_, i});
      const auto label = labelled.find({edge.name, edge.side});
      if (sewn == roles_.sewn.end() || label == labelled.end() || label->second.first == i) continue;
      const auto main = roles_.sewn.find({index_, label->second.first});
      if (main != roles_.sewn.end() && main->second.text == sewn->second.text) continue;
      const double middle = edge.curve.length() / 2, scale = scale_of(edge);
      const Vec2 inwards = perpendicular(edge.curve.tangent(middle));
      drawing += badge(edge.curve.at(middle) + scale * kInside * inwards, sewn->second, scale);
    }
    return drawing;
  }

  static double scale_of(const PieceEdge& edge) { return std::clamp(edge.curve.length() / kFullSize, 0.5, 1.0); }

  std::string edge_label(int i, double whole) const {
    const PieceEdge& edge = piece_.edge(i);
    const std::pair<int, int> key{index_, i};
    const auto sewn = roles_.sewn.find(key);
    const auto worn = roles_.worn.find(key);
    const double scale = scale_of(edge), text = scale * kEdgeText;
    const double room = 0.9 * edge.curve.length(), sign_room = sewn != roles_.sewn.end() ? scale * 4 * kBadge : 0;

    const std::string length = " · " + centimetres(whole);
    const std::string line = worn != roles_.worn.end() ? " · worn at " + worn->second : "";
    std::string words;  // as much as there is room for
    for (const std::string& wording :
         {fmt::format("{}{}{}", edge.name, length, line), edge.name + line, edge.name + length, edge.name}) {
      if (svg::text_width(wording, text) + sign_room > room) continue;
      words = wording;
      break;
    }

    const double middle = edge.curve.length() / 2;
    const Vec2 tangent = edge.curve.tangent(middle);
    const Vec2 at = edge.curve.at(middle) + scale * kInside * perpendicular(tangent);
    const double angle = upright(tangent);
    const double width = words.empty() ? 0 : svg::text_width(words, text);
    std::string drawing;
    if (!words.empty()) drawing += svg::text("soft", at + sign_room / 2 * direction(angle), text, words, angle);
    if (sewn != roles_.sewn.end()) {
      drawing += badge(at - (words.empty() ? 0 : width / 2 + sign_room / 4) * direction(angle), sewn->second, scale);
    }
    return drawing;
  }

  const Piece& piece_;
  int index_;
  const Roles& roles_;
};

std::string scale_bar(Vec2 at) {
  std::string drawing;
  for (int i = 0; i < 10; ++i) {
    if (i % 2 == 0) {
      const Vec2 a = at + Vec2{0.01 * i, 0}, b = a + Vec2{0.01, 0.003};
      drawing += svg::path("ink", svg::polygon_data({a, {b.x, a.y}, b, {a.x, b.y}}));
    }
  }
  drawing += svg::path("bar", svg::polygon_data({at, at + Vec2{0.1, 0}, at + Vec2{0.1, 0.003}, at + Vec2{0, 0.003}}));
  return drawing + svg::text("left soft", at + Vec2{0.104, 0.0015}, kNote, "10 cm: print at 100 %");
}

// Title above the pieces, the list of seams and the scale below; y = 0 is the top of the pieces.
struct Frame {
  double above = 0, below = 0, width = 0;
  std::string drawing;
};

Frame frame(const Garment& garment, const Roles& roles, Vec2 size) {
  Frame frame;
  frame.above = 2.6 * kTitle;
  frame.drawing = svg::text("left bold", {0, 1.6 * kTitle}, kTitle, garment.name);
  std::string note = "flat pattern at true scale";
  if (!garment.fabric.name.empty()) note += "  ·  " + garment.fabric.name;
  const double beside = svg::text_width(garment.name, kTitle) * 1.15 + 0.01;
  frame.drawing += svg::text("left soft", {beside, 1.52 * kTitle}, kNote, note);

  double widest = svg::text_width("10 cm: print at 100 %", kNote) + 0.11;
  for (const auto& [sign, text] : roles.legend) widest = std::max(widest, svg::text_width(text, kNote) + 0.03);
  frame.width = std::max({size.x, widest, beside + svg::text_width(note, kNote)});
  const int columns = std::max(1, static_cast<int>(frame.width / widest));
  const int count = static_cast<int>(roles.legend.size()), rows = (count + columns - 1) / columns;
  double y = -size.y - 1.6 * kGap;
  for (int i = 0; i < count; ++i) {
    const auto& [sign, text] = roles.legend[static_cast<std::size_t>(i)];
    const int column = i / rows, row = i % rows;
    const Vec2 at{widest * column + kBadge, y - 1.25 * kLine * row};
    frame.drawing += badge(at, sign) + svg::text("left", at + Vec2{2 * kBadge, 0}, kNote, text);
  }
  y -= 1.25 * kLine * rows + 0.3 * kLine;
  frame.drawing += scale_bar({0, y});
  frame.below = -y;
  return frame;
}

}  // namespace

std::string pattern_svg(const Garment& garment) {
  const Roles roles = roles_of(garment);
  Vec2 size;
  const std::vector<Vec2> shifts = on_shelves(garment, kGap, size);
  const Frame around = frame(garment, roles, size);
  const double width = around.width + 2 * kMargin, height = around.above + around.below + 2 * kMargin;

  std::string document = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} {3} {0} {1}\">\n"
      "<title>{4}: flat pattern</title>\n",
      svg::mm(width), svg::mm(height), svg::mm(-kMargin), svg::mm(-around.above - kMargin), svg::escaped(garment.name));
  document += kStyle + marks_style() + "</style>\n";
  document += around.drawing;
  for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
    document += fmt::format("<g id=\"piece-{}\" transform=\"translate({})\">\n", i + 1, svg::place(shifts[i]));
    document += Sheet(garment.pieces[i], static_cast<int>(i), roles).drawn() + "</g>\n";
  }
  return document + "</svg>\n";
}

}  // namespace toile
