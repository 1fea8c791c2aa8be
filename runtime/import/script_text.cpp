#include "runtime/import/script_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string_view>

#include "compiler/pattern/decimal.hpp"
#include "grammar/scan.hpp"
#include "runtime/import/arrangement.hpp"
#include "runtime/import/names.hpp"

namespace toile {
namespace {

// What a seam's sides may differ by without a word: as make_garment() has it.
constexpr double length_tolerance = 0.5e-3;  // [m]
constexpr double relative_tolerance = 1e-3;
constexpr double most_ease = 0.1;  // of the longer side
constexpr const char* waist_label = "lower_interface";
constexpr double most_gather = 4;  // times the shorter side; nobody gathers more

/// To 10 nm.
std::string written(double metres) {
  return decimal(100 * metres, 6) + "cm";
}

std::string written(Vec2 point) {
  return fmt::format("({}, {})", written(point.x), written(point.y));
}

/// To 0.1 mm, less than what a seam lets pass in addition to what is stated.
std::string rough(double metres) {
  return decimal(100 * metres, 2) + "cm";
}

/// For a comment: one line of readable text, whatever a file or its name says.
std::string in_one_line(std::string_view text) {
  std::string line;
  for (std::uint32_t at = 0; at < text.size();) {
    const std::uint32_t length = syntax::code_point_length(text, at);
    const auto first = static_cast<unsigned char>(text[at]);
    const bool is_kept = length > 0 && first >= 0x20 && first != 0x7f;
    line += is_kept ? text.substr(at, length) : std::string_view(" ");
    at += std::max(length, 1u);
  }
  return line;
}

double twice_area(const ForeignPanel& panel) {
  double sum = 0;
  for (const ForeignEdge& edge : panel.edges) {
    // Curves by their middle: a panel of two edges has all its area between curve and chord.
    const Vec2 middle = edge.curve.at(edge.curve.length() / 2);
    sum += cross(edge.from, middle) + cross(middle, edge.to);
  }
  return sum;
}

class Writer {
 public:
  Writer(const ForeignPattern& pattern, const std::string& source) : pattern_(pattern), source_(source) {}

  ImportedScript write() {
    name_all();
    const std::string garment = name_like(std::filesystem::path(source_).stem().string(), "garment_1");
    put("// Imported from {}, a pattern of GarmentCode.\n", in_one_line(source_));
    const bool is_arranged =
        std::ranges::any_of(pattern_.panels, [](const ForeignPanel& panel) { return panel.placement.has_value(); });
    if (is_arranged) put("import bodies\n");
    put("import fabrics\n\n");
    if (is_arranged)
      put("// The source does not bring its body; any may stand here.\nbody form = bodies.dress_form()\n\n");
    put("// The source names no cloth; any may stand here.\ngarment {} in fabrics.cotton_shirting {{\n", garment);
    for (std::size_t i = 0; i < pattern_.panels.size(); ++i) write_piece(i);
    if (!pattern_.stitches.empty()) put("\n");
    for (const ForeignStitch& stitch : pattern_.stitches) write_seam(stitch);
    const bool turned = std::ranges::any_of(pattern_.stitches, &ForeignStitch::to_wrong_side);
    if (turned) put("// The source sews a right side to a wrong one.\nallow W0337\n");
    if (is_arranged) write_wear();
    put("\n");
    for (std::size_t i = 0; i < pattern_.panels.size(); ++i) write_arrangement(i);
    put("}}\n");
    if (is_arranged) put("\ndrape {} on form as worn\n", garment);
    return std::move(script_);
  }

 private:
  template <typename... Values>
  void put(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(script_.text), form, std::forward<Values>(values)...);
  }

  void name_all() {
    Names pieces;
    for (const char* taken : {"fabrics", "bodies", "form"}) pieces.take(taken);  // a piece would hide what is called so
    for (const ForeignPanel& panel : pattern_.panels) {
      piece_names_.push_back(pieces.take(name_like(panel.name, "panel")));
      Names edges;
      std::vector<std::string>& names = edge_names_.emplace_back();
      for (const ForeignEdge& edge : panel.edges) {
        names.push_back(edges.take(name_like(edge.label, fmt::format("e{}", names.size()))));
      }
    }
  }

  void write_piece(std::size_t number) {
    const ForeignPanel& panel = pattern_.panels[number];
    // A script shows the cloth's right side; a panel that runs clockwise shows its wrong one.
    const bool is_mirrored = twice_area(panel) < 0;
    put("\n");
    write_origin(panel);
    if (is_mirrored) put("// The source shows the wrong side: its x is -x here.\n");
    const auto shown = [is_mirrored](Vec2 point) { return is_mirrored ? Vec2{-point.x, point.y} : point; };
    put("piece {} {{\noutline from {} {{\n", piece_names_[number], written(shown(panel.edges.front().from)));
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
      const std::string to = i + 1 == panel.edges.size() ? "start" : written(shown(panel.edges[i].to));
      put("{} = {}\n", edge_names_[number][i], edge_text(panel.edges[i].curve, to, shown));
    }
    put("}}\n}}\n");
  }

  void write_origin(const ForeignPanel& panel) {
    const std::string line = in_one_line(panel.part);
    if (!line.empty()) put("// {}\n", line);
  }

  void write_arrangement(std::size_t number) {
    const ForeignPanel& panel = pattern_.panels[number];
    if (!panel.placement) return;
    const ScriptPlace place = script_place(*panel.placement, twice_area(panel) < 0);
    put("arrange {} at ({}, {}, {})", piece_names_[number], written(place.at[0]), written(place.at[1]),
        written(place.at[2]));
    const auto angle = [](double degrees) { return decimal(degrees, 4) + "deg"; };
    if (std::ranges::any_of(place.turn, [](double degrees) { return std::abs(degrees) > 1e-6; })) {
      put(" turned ({}, {}, {})", angle(place.turn[0]), angle(place.turn[1]), angle(place.turn[2]));
    }
    put("\n");
  }

  /// The source marks edges that its simulation holds at the waist. The one named first comes to the front.
  void write_wear() {
    std::vector<ForeignEnd> ends;
    for (std::size_t i = 0; i < pattern_.panels.size(); ++i) {
      for (std::size_t e = 0; e < pattern_.panels[i].edges.size(); ++e) {
        if (pattern_.panels[i].edges[e].label == waist_label && !is_sewn({i, e})) ends.push_back({i, e});
      }
    }
    const auto in_front = [&](const ForeignEnd& end) {
      const auto& placement = pattern_.panels[end.panel].placement;
      return placement ? placement->translation[2] : 0.0;
    };
    std::ranges::stable_sort(ends, std::greater<>(), in_front);
    std::vector<std::string> held;
    for (const ForeignEnd& end : ends) held.push_back(end_name(end));
    if (!held.empty()) put("\nwear {} at form.waist\n", fmt::join(held, " + "));
  }

  bool is_sewn(const ForeignEnd& end) const {
    const auto same = [&](const ForeignEnd& other) { return other.panel == end.panel && other.edge == end.edge; };
    return std::ranges::any_of(pattern_.stitches,
                               [&](const ForeignStitch& stitch) { return same(stitch.first) || same(stitch.second); });
  }

  template <typename Shown>
  static std::string edge_text(const Curve& curve, const std::string& to, const Shown& shown) {
    const Segment& segment = curve.segments().front();
    if (const auto* cubic = std::get_if<BezierSegment>(&segment)) {
      return fmt::format("bezier to {} via {}, {}", to, written(shown(cubic->p1)), written(shown(cubic->p2)));
    }
    // By a point and not by its radius, which near a half circle says little about the arc.
    if (std::holds_alternative<ArcSegment>(segment)) {
      return fmt::format("arc to {} through {}", to, written(shown(curve.at(curve.length() / 2))));
    }
    return "line to " + to;
  }

  std::string end_name(const ForeignEnd& end) const {
    return piece_names_[end.panel] + "." + edge_names_[end.panel][end.edge];
  }

  double length(const ForeignEnd& end) const { return pattern_.panels[end.panel].edges[end.edge].curve.length(); }

  void write_seam(const ForeignStitch& stitch) {
    const double first = length(stitch.first), second = length(stitch.second);
    const auto [shorter, longer] = std::minmax(first, second);
    const double difference = longer - shorter;
    put("sew {} to {}{}", end_name(stitch.first), end_name(stitch.second), stitch.to_wrong_side ? " reversed" : "");
    if (difference > std::max(length_tolerance, relative_tolerance * longer)) {
      const bool is_eased = difference <= most_ease * longer;
      const bool is_plausible = longer <= most_gather * shorter;
      if (is_plausible) put(" {} {}", is_eased ? "ease" : "gather", rough(difference));
      put(" // {} to {}", rough(first), rough(second));
      if (!is_plausible || (is_eased && is_within_a_part(stitch))) doubt(stitch, rough(first), rough(second));
    }
    put("\n");
  }

  /// Cuffs, sleeves and waistbands join parts of the body, and fullness there is meant; front and back of one leg are
  /// of the same length but by mistake.
  bool is_within_a_part(const ForeignStitch& stitch) const {
    return pattern_.panels[stitch.first.panel].part == pattern_.panels[stitch.second.panel].part;
  }

  void doubt(const ForeignStitch& stitch, const std::string& first, const std::string& second) {
    put(", a mistake of the source?");
    script_.notes.push_back(fmt::format("{} is {} long and {}, sewn to it, {}: a mistake of the source?",
                                        end_name(stitch.first), first, end_name(stitch.second), second));
  }

  const ForeignPattern& pattern_;
  const std::string& source_;
  std::vector<std::string> piece_names_;
  std::vector<std::vector<std::string>> edge_names_;
  ImportedScript script_;
};

}  // namespace

ImportedScript script_text(const ForeignPattern& pattern, const std::string& source) {
  return Writer(pattern, source).write();
}

}  // namespace toile
