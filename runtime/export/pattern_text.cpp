#include "runtime/export/pattern_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <variant>

#include "compiler/pattern/decimal.hpp"
#include "compiler/pattern/fabric_rows.hpp"

namespace toile {
namespace {

constexpr double degree = std::numbers::pi / 180;

std::string in_cm_text(double metres) {
  return decimal(100 * metres, 4) + "cm";
}
std::string point_text(Vec2 point) {
  return fmt::format("({}, {})", in_cm_text(point.x), in_cm_text(point.y));
}
std::string angle_text(double angle) {
  return decimal(angle / degree, 3) + "deg";
}

class PatternWriter {
 public:
  PatternWriter(const Redrawn& redrawn, const std::vector<std::string>& notes) : redrawn_(redrawn), notes_(notes) {}

  std::string write(const std::string& source) {
    const std::string cloth = write_fabric(source);
    put("garment {} in {} {{\n", redrawn_.draft.name, cloth);
    for (std::size_t i = 0; i < redrawn_.pieces.size(); ++i) write_piece(i);
    if (!redrawn_.draft.seams.empty()) put("\n");
    for (const DraftSeam& seam : redrawn_.draft.seams) write_seam(seam);
    put("}}\n");
    return std::move(text_);
  }

 private:
  template <typename... Values>
  void put(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
  }

  void write_row(const FabricRow& row, const FabricSheet& sheet) {
    const bool compound = row.unit.find_first_of("*/") != std::string_view::npos;
    const std::string unit = row.unit == "1" ? "" : (compound ? " " : "") + std::string(row.unit);
    const auto write = [&](double warp, double weft) {
      put("  {} {:.10g}{}", row.name, warp / row.size, unit);
      if (weft != warp) put(", {:.10g}{}", weft / row.size, unit);
      put("\n");
    };
    if (const auto* both = std::get_if<std::optional<WarpWeft> FabricSheet::*>(&row.place)) {
      if (sheet.*(*both)) write((sheet.*(*both))->warp, (sheet.*(*both))->weft);
    } else if (const auto& value = sheet.*std::get<std::optional<double> FabricSheet::*>(row.place)) {
      write(*value, *value);
    }
  }

  std::string write_fabric(const std::string& source) {
    const FabricSheet& sheet = redrawn_.draft.fabric;
    std::string name = (sheet.name.empty() ? "cloth" : sheet.name) + "_of_" + redrawn_.draft.name;
    put("// Developed by {}: each edge lies within {} mm of the solved outline.\n", source,
        decimal(1000 * std::max(redrawn_.error, 1e-5), 2));
    for (const std::string& note : notes_) put("// {}\n", note);
    put("\n");
    put("fabric {} {{\n", name);
    for (const FabricRow& row : fabric_rows()) write_row(row, sheet);
    put("}}\n\n");
    return name;
  }

  void write_edges(const std::vector<RedrawnEdge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const FittedCurve& fitted = edges[i].fitted;
      const std::string to = i + 1 == edges.size() ? "start" : point_text(fitted.points.back());
      put("      {} = {} to {}", edges[i].name, fitted.straight() ? "line" : "curve", to);
      for (std::size_t k = 1; k + 1 < fitted.points.size(); ++k) {
        put("{}{}", k == 1 ? " through " : ", ", point_text(fitted.points[k]));
      }
      if (!fitted.straight()) put(" leaving {} arriving {}", angle_text(*fitted.leaving), angle_text(*fitted.arriving));
      put("\n");
    }
  }

  void write_piece(std::size_t number) {
    const RedrawnPiece& piece = redrawn_.pieces[number];
    const DraftPiece& draft = redrawn_.draft.pieces[number];
    put("{}  piece {} {{\n    outline from {} {{\n", number == 0 ? "" : "\n", draft.name,
        point_text(piece.outline.front().fitted.points.front()));
    write_edges(piece.outline);
    put("    }}\n");
    for (const RedrawnHole& hole : piece.holes) {
      put("    hole {} from {} {{\n", hole.name, point_text(hole.edges.front().fitted.points.front()));
      write_edges(hole.edges);
      put("    }}\n");
    }
    if (draft.fold) put("    fold {}\n", *draft.fold);
    if (draft.quantity > 1) put("    cut {}{}\n", draft.quantity, draft.mirrored ? " mirrored" : "");
    put("    grain {}\n", angle_text(std::atan2(draft.warp.y, draft.warp.x)));
    for (const DraftNotch& notch : draft.notches) put("    notch at {} of {}\n", in_cm_text(notch.at), notch.edge);
    if (!draft.allowances.empty()) {
      put("    allowance 0cm");
      for (const DraftAllowance& allowance : draft.allowances) {
        put(", {} {}", allowance.edge, in_cm_text(allowance.width));
      }
      put("\n");
    }
    put("  }}\n");
  }

  static std::string chain(const std::vector<DraftEdgeRef>& edges) {
    std::string text;
    for (const DraftEdgeRef& edge : edges) {
      text += (text.empty() ? "" : " + ") + edge.piece + "." + edge.edge;
      if (edge.side) text += *edge.side == Side::Mirrored ? ".mirrored" : ".drawn";
    }
    return text;
  }

  void write_seam(const DraftSeam& seam) {
    put("  sew {} to {}{}", chain(seam.first), chain(seam.second), seam.reversed ? " reversed" : "");
    if (seam.fullness != Seam::Fullness::None) {
      put(" {}", seam.fullness == Seam::Fullness::Ease     ? "ease"
                 : seam.fullness == Seam::Fullness::Gather ? "gather"
                                                           : "stretch");
      if (seam.stated) put(" {}", in_cm_text(*seam.stated));
    }
    put("\n");
  }

  const Redrawn& redrawn_;
  const std::vector<std::string>& notes_;
  std::string text_;
};

}  // namespace

std::string slit_text(const DraftDart& dart) {
  const std::string to = dart.tip ? "tip " + point_text(rounded(*dart.tip)) : "depth " + in_cm_text(dart.depth);
  return fmt::format("dart {} at {} of {} {{ {} }}", dart.name, in_cm_text(dart.at), dart.edge, to);
}

std::string pattern_text(const Redrawn& redrawn, const std::string& source, const std::vector<std::string>& notes) {
  return PatternWriter(redrawn, notes).write(source);
}

}  // namespace toile
