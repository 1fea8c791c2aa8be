// The order of sewing, step by step, in words.
#include "runtime/export/sewing_instructions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "runtime/export/export.hpp"

namespace toile {

namespace {

std::string cm(double metres) {
  return fmt::format("{:.1f} cm", 100 * metres);
}

const char* operation(const SewingStep& step) {
  constexpr const char* words[] = {"dart", "pleat", "seam", "closure", "hem", "buttons"};
  return words[static_cast<int>(step.kind)];
}

class SewingPlan {
 public:
  explicit SewingPlan(const Garment& garment) : garment_(garment), steps_(sewing_order(garment)) {}

  std::string text() const {
    std::string all = fmt::format("{}: order of sewing\n", garment_.name);
    if (!garment_.fabric.name.empty()) all += fmt::format("cloth: {}\n", garment_.fabric.name);
    all += "\ncut\n";
    for (const Piece& piece : garment_.pieces) {
      all += fmt::format("    {} x {}{}{}\n", piece.quantity, piece.name,
                         piece.has_own_cloth() ? " in " + piece.own_cloth() : "",
                         piece.label.empty() ? "" : ": " + piece.label);
    }
    all += "\nsew\n";
    int number = 0;
    for (const SewingStep& step : steps_) {
      all += fmt::format("{:3}. {:<8}{}\n", ++number, operation(step), headline(step));
      for (const std::string& line : instructions(step)) all += "             " + line + "\n";
    }
    return all;
  }

  std::vector<SewingInstruction> instructed() const {
    std::vector<SewingInstruction> all;
    for (const SewingStep& step : steps_) all.push_back({step, operation(step), headline(step), instructions(step)});
    return all;
  }

 private:
  const PieceEdge& edge(const ChainLink& link) const { return garment_.pieces[link.edge.piece].edge(link.edge.edge); }

  bool is_line(const Chain& chain) const {
    const EdgeRef& edge = chain.front().edge;
    return garment_.pieces[edge.piece].is_inside(edge.edge);
  }

  double length(const Chain& chain) const {
    double sum = 0;
    for (const ChainLink& link : chain) sum += edge(link).curve.length();
    return sum;
  }

  std::string allowances(const Chain& chain) const {
    std::set<double> widths;
    for (const ChainLink& link : chain) widths.insert(edge(link).allowance);
    std::string text;
    for (const double width : widths) text += (text.empty() ? "" : "/") + cm(width);
    return text;
  }

  std::string headline(const SewingStep& step) const {
    if (step.kind == SewingStep::Kind::Buttons) return "all buttons and buttonholes";
    if (step.kind == SewingStep::Kind::Hem) {
      const EdgeRef& first = step.edges.front();
      return garment_.pieces[first.piece].drawn_name + "." + garment_.pieces[first.piece].edge(first.edge).name;
    }
    std::string text;
    std::set<std::string> told;
    for (const int seam : step.seams) {
      const std::string& name = garment_.seams[seam].name;
      if (told.insert(name).second) text += (text.empty() ? "" : "; ") + name;
    }
    return text;
  }

  std::vector<std::string> instructions(const SewingStep& step) const {
    switch (step.kind) {
      case SewingStep::Kind::Dart:
        return dart(garment_.seams[step.seams.front()]);
      case SewingStep::Kind::Pleat:
        return pleat(step);
      case SewingStep::Kind::Hem:
        return hem(step);
      case SewingStep::Kind::Buttons:
        return {"work the buttonholes as marked, sew the buttons on where they come to lie"};
      case SewingStep::Kind::Seam:
      case SewingStep::Kind::Closure:
        break;
    }
    return seam(step);
  }

  static const char* way(Vec2 v) {
    if (std::abs(v.x) >= std::abs(v.y)) return v.x < 0 ? "to the left" : "to the right";
    return v.y < 0 ? "down" : "up";
  }

  std::vector<std::string> dart(const Seam& seam) const {
    const ChainLink& link = seam.first.front();
    const Piece& piece = garment_.pieces[link.edge.piece];
    for (const Dart& each : piece.darts) {
      if (each.left_leg != link.edge.edge) continue;
      const PieceEdge &left = piece.edge(each.left_leg), &right = piece.edge(each.right_leg);
      const Vec2 a = left.curve.at(each.other_tip ? left.curve.length() / 2 : 0);
      const Vec2 b = right.curve.at(right.curve.length() * (each.other_tip ? 0.5 : 1));
      const std::string press = left.pressed_onto ? way(a - b) : right.pressed_onto ? way(b - a) : "open";
      return {fmt::format("fold along its centre, right sides together; {} wide, {} {}", cm(each.width), cm(each.depth),
                          each.other_tip ? "from tip to tip" : "deep"),
              each.other_tip ? "stitch from its widest place to either tip, backstitch nowhere"
                             : "stitch from the edge to the tip, run off the fold",
              "press " + press + ", as seen in the drawing"};
    }
    return {};
  }

  std::vector<std::string> pleat(const SewingStep& step) const {
    std::vector<std::string> lines;
    // Two seams a turn, the layer on top and the next one first; copies on the other side are folded alike.
    for (std::size_t i = 0; i < step.seams.size(); i += 2) {
      const ChainLink& upper = garment_.seams[step.seams[i]].first.front();
      if (edge(upper).side == Side::Mirrored || garment_.pieces[upper.edge.piece].side == Side::Mirrored) continue;
      const Curve& face = edge(upper).curve;
      const Vec2 back = upper.forward ? face.tangent(0) : -face.tangent(face.length());
      lines.push_back(fmt::format("fold on the fold line, {} deep, the fold pointing {}; lay it on the placement line",
                                  cm(face.length()), way(-1 * back)));
    }
    lines.push_back(
        fmt::format("baste the layers together along {}", edge(garment_.seams[step.seams.front()].first.front()).name));
    return lines;
  }

  std::vector<std::string> hem(const SewingStep& step) const {
    double sum = 0;
    for (const EdgeRef& each : step.edges) sum += garment_.pieces[each.piece].edge(each.edge).curve.length();
    const double width = garment_.pieces[step.edges.front().piece].edge(step.edges.front().edge).allowance;
    std::vector<std::string> lines{fmt::format("turn up {}, {} in all, and stitch", cm(width), cm(sum))};
    for (const Wear& wear : garment_.wears) {
      const bool worn = std::any_of(wear.chain.begin(), wear.chain.end(), [&](const ChainLink& link) {
        return std::find(step.edges.begin(), step.edges.end(), link.edge) != step.edges.end();
      });
      if (worn)
        lines = {fmt::format("finish the edge, {} in all, allowance {}: it is worn at the {}", cm(sum), cm(width),
                             wear.line)};
    }
    return lines;
  }

  std::vector<std::string> seam(const SewingStep& step) const {
    const Seam& first = garment_.seams[step.seams.front()];
    const double a = length(first.first), b = length(first.second);
    std::vector<std::string> lines;
    const bool on_first = is_line(first.first), on_second = is_line(first.second);
    if (on_first && on_second) {
      lines.push_back(
          first.first.front().edge.piece == first.second.front().edge.piece
              ? fmt::format("fold the cloth so that the two lines meet, and stitch along them, {}", cm(a))
              : fmt::format("lay the pieces on each other, the lines meeting, and stitch along them, {}", cm(a)));
    } else if (on_first || on_second) {
      const Chain& own = on_first ? first.second : first.first;
      lines.push_back(
          fmt::format("press under the allowance, {}; lay it right side up with its edge on the line, {} on {}, "
                      "and stitch close to the edge",
                      allowances(own), cm(on_first ? b : a), cm(on_first ? a : b)));
    } else {
      lines.push_back(fmt::format("right sides together: {} to {}, allowances {} and {}", cm(a), cm(b),
                                  allowances(first.first), allowances(first.second)));
    }
    for (const int i : step.seams) {
      const Seam& layer = garment_.seams[i];
      if (layer.is_layer) {
        lines.push_back(fmt::format("between them {} ({})", layer.name.substr(layer.name.rfind(" to ") + 4),
                                    cm(length(layer.second))));
      }
    }
    for (const std::string& line : fullness(first, a, b)) lines.push_back(line);
    if (!first.notches.empty()) lines.push_back("match the notches" + places(first, first.notches));
    if (first.closure == Seam::Closure::Zipped) lines.emplace_back("set a zip in place of the seam");
    if (first.closure == Seam::Closure::Buttoned)
      lines.emplace_back("finish both edges; they are buttoned over each other");
    if (first.closure == Seam::Closure::Sewn && !first.open && !on_first && !on_second) {
      lines.emplace_back(first.fullness == Seam::Fullness::Gather ? "press the allowances away from the gathers"
                                                                  : "press the allowances open");
    }
    if (first.open) lines.emplace_back("leave it open: that is how it is worn");
    return lines;
  }

  // Told from where the line named first begins as drawn, as the script tells them.
  std::string places(const Seam& seam, std::vector<std::array<double, 2>> pairs) const {
    const ChainLink& link = seam.first.front();
    if (edge(link).against_drawing == link.forward) {
      for (auto& pair : pairs) pair = {length(seam.first) - pair[0], length(seam.second) - pair[1]};
    }
    std::sort(pairs.begin(), pairs.end());
    std::string text;
    for (const auto& pair : pairs)
      text += fmt::format("{} {} / {}", text.empty() ? " at" : ",", cm(pair[0]), cm(pair[1]));
    return text;
  }

  std::vector<std::string> fullness(const Seam& seam, double a, double b) const {
    const char* word = seam.fullness == Seam::Fullness::Ease     ? "ease in"
                       : seam.fullness == Seam::Fullness::Gather ? "gather"
                                                                 : "stretch";
    if (seam.fullness == Seam::Fullness::None || std::abs(a - b) < 5e-4) return {};
    const bool stretched = seam.fullness == Seam::Fullness::Stretch;
    const std::string which = (a > b) != stretched ? "the first" : "the second";
    std::string line = fmt::format("{} {} by {}", word, which, cm(std::abs(a - b)));
    std::vector<std::array<double, 2>> stretch;
    for (const auto& tie : seam.ties) {
      if (std::find(seam.notches.begin(), seam.notches.end(), tie) == seam.notches.end()) stretch.push_back(tie);
    }
    if (!stretch.empty()) line += ", only between the places" + places(seam, stretch);
    return {line};
  }

  const Garment& garment_;
  std::vector<SewingStep> steps_;
};

}  // namespace

std::string sewing_text(const Garment& garment) {
  return SewingPlan(garment).text();
}

std::vector<SewingInstruction> sewing_instructions(const Garment& garment) {
  return SewingPlan(garment).instructed();
}

}  // namespace toile
