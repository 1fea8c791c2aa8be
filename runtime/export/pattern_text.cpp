#include "runtime/export/pattern_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

namespace toile {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gram_force = 0.00980665;  // [N]

std::string plain(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string in_cm_text(double metres) {
  return plain(100 * metres, 4) + "cm";
}
std::string point_text(Vec2 point) {
  return fmt::format("({}, {})", in_cm_text(point.x), in_cm_text(point.y));
}
std::string angle_text(double angle) {
  return plain(angle / degree, 3) + "deg";
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

  void row(const char* name, const std::optional<WarpWeft>& value, double unit, const char* written) {
    if (!value) return;
    put("  {} {:.10g}{}", name, value->warp / unit, written);
    if (value->weft != value->warp) put(", {:.10g}{}", value->weft / unit, written);
    put("\n");
  }
  void row(const char* name, const std::optional<double>& value, double unit, const char* written) {
    if (value) put("  {} {:.10g}{}\n", name, *value / unit, written);
  }

  std::string write_fabric(const std::string& source) {
    const FabricSheet& sheet = redrawn_.draft.fabric;
    std::string name = (sheet.name.empty() ? "cloth" : sheet.name) + "_of_" + redrawn_.draft.name;
    put("// Developed by {}: each edge lies within {} mm of the solved outline.\n", source,
        plain(1000 * std::max(redrawn_.error, 1e-5), 2));
    for (const std::string& note : notes_) put("// {}\n", note);
    put("\n");
    put("fabric {} {{\n", name);
    row("LT", sheet.lt, 1, "");
    row("WT", sheet.wt, 100 * gram_force, " gf*cm/cm^2");
    row("RT", sheet.rt, 0.01, "%");
    row("EMT", sheet.emt, 0.01, "%");
    row("G", sheet.g, 100 * gram_force / degree, " gf/cm/deg");
    row("2HG", sheet.hg, 100 * gram_force, " gf/cm");
    row("2HG5", sheet.hg5, 100 * gram_force, " gf/cm");
    row("B", sheet.b, 0.01 * gram_force, " gf*cm^2/cm");
    row("2HB", sheet.hb, gram_force, " gf*cm/cm");
    row("twist", sheet.twist, 0.01 * gram_force, " gf*cm^2/cm");
    row("LC", sheet.lc, 1, "");
    row("WC", sheet.wc, 100 * gram_force, " gf*cm/cm^2");
    row("RC", sheet.rc, 0.01, "%");
    row("T0", sheet.t0, 0.001, "mm");
    row("Tm", sheet.tm, 0.001, "mm");
    row("W", sheet.weight, 0.01, " mg/cm^2");
    row("MIU", sheet.miu, 1, "");
    row("MMD", sheet.mmd, 1, "");
    row("SMD", sheet.smd, 1e-6, "um");
    row("stretch", sheet.stretch, 1, " N/m");
    row("shear", sheet.shear, 1, " N/m");
    row("B45", sheet.b45, 0.01 * gram_force, " gf*cm^2/cm");
    row("E5", sheet.e5, 0.01, "%");
    row("E20", sheet.e20, 0.01, "%");
    row("E100", sheet.e100, 0.01, "%");
    row("EB5", sheet.eb5, 0.01, "%");
    row("C", sheet.c, 0.001, "mm");
    row("C45", sheet.c45, 0.001, "mm");
    row("T2", sheet.t2, 0.001, "mm");
    row("T100", sheet.t100, 0.001, "mm");
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
