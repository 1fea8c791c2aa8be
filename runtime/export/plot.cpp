#include "runtime/export/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/export/svg.hpp"

namespace toile {
namespace {

constexpr double panel_width = 340, panel_height = 300;  // of the drawing's own units
constexpr double margin_left = 58, margin_right = 14, margin_top = 34, margin_bottom = 46;
constexpr std::size_t plots_in_a_row = 3;
constexpr std::array<const char*, 6> plot_colours{"#1f5a99", "#b3402a", "#2f7d4f", "#7a4b9a", "#a87900", "#4a4a4a"};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double length() const { return high - low; }
};

/// 1, 2 or 5 times a power of ten, so that four to eight of them make the range.
double tick_step(double range) {
  const double raw = range / 6, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10 * power;
}

void widen(Range& range) {
  if (!(range.low <= range.high)) range = {0, 1};
  if (range.length() < 1e-12 * std::max(std::abs(range.low), 1e-300)) range.high = range.low + 1;
  const double step = tick_step(range.length());
  range.low = step * std::floor(range.low / step + 1e-9);
  range.high = step * std::ceil(range.high / step - 1e-9);
}

class Panel {
 public:
  Panel(const PlotPanel& panel, double x, double y) : panel_(panel), x_(x), y_(y) {
    for (const PlotSeries& series : panel.series) {
      for (const Vec2 p : series.points) {
        across_.take(p.x);
        up_.take(p.y);
      }
    }
    widen(across_);
    widen(up_);
    if (panel.same_scale) {
      const double scale = std::max(across_.length() / width(), up_.length() / height());
      across_.high = across_.low + scale * width();
      up_.high = up_.low + scale * height();
    }
  }

  std::string drawn() const { return axes() + curves() + legend(); }

 private:
  static double width() { return panel_width - margin_left - margin_right; }
  static double height() { return panel_height - margin_top - margin_bottom; }
  double at_x(double value) const { return x_ + margin_left + (value - across_.low) / across_.length() * width(); }
  double at_y(double value) const { return y_ + margin_top + (up_.high - value) / up_.length() * height(); }

  static std::string number(double value, double step) {
    return fmt::format("{:.{}f}", std::abs(value) < step / 1e3 ? 0.0 : value,
                       std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9));
  }

  std::string axes() const {
    std::string out;
    const double x_step = tick_step(across_.length()), y_step = tick_step(up_.length());
    for (double v = x_step * std::ceil(across_.low / x_step - 1e-9); v <= across_.high + 1e-9 * x_step; v += x_step) {
      out += fmt::format(R"(<path class="grid" d="M{:.1f},{:.1f}V{:.1f}"/>)", at_x(v), y_ + margin_top,
                         y_ + margin_top + height());
      out += fmt::format("<text class=\"tick\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at_x(v),
                         y_ + margin_top + height() + 14, number(v, x_step));
    }
    for (double v = y_step * std::ceil(up_.low / y_step - 1e-9); v <= up_.high + 1e-9 * y_step; v += y_step) {
      out += fmt::format(R"(<path class="grid" d="M{:.1f},{:.1f}H{:.1f}"/>)", x_ + margin_left, at_y(v),
                         x_ + margin_left + width());
      out += fmt::format("<text class=\"tick\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                         x_ + margin_left - 5, at_y(v) + 3.5, number(v, y_step));
    }
    out += fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                       x_ + margin_left, y_ + margin_top, width(), height());
    const double middle = x_ + margin_left + width() / 2;
    out += fmt::format("<text class=\"title\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", middle,
                       y_ + 20, svg::escaped(panel_.title));
    out += fmt::format("<text class=\"axis\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", middle,
                       y_ + panel_height - 12, svg::escaped(panel_.x_axis));
    const double side_x = x_ + 13, side_y = y_ + margin_top + height() / 2;
    out += fmt::format(
        "<text class=\"axis\" text-anchor=\"middle\" x=\"{0:.1f}\" y=\"{1:.1f}\" transform=\"rotate(-90 {0:.1f} "
        "{1:.1f})\">{2}</text>\n",
        side_x, side_y, svg::escaped(panel_.y_axis));
    return out;
  }

  std::string curves() const {
    std::string out;
    for (std::size_t s = 0; s < panel_.series.size(); ++s) {
      const PlotSeries& series = panel_.series[s];
      const char* colour = plot_colours[s % plot_colours.size()];
      if (series.marks) {
        for (const Vec2 p : series.points) {
          out +=
              fmt::format("<circle r=\"3\" fill=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\"/>\n", colour, at_x(p.x), at_y(p.y));
        }
        continue;
      }
      std::string data;
      for (const Vec2 p : series.points)
        data += fmt::format("{}{:.2f},{:.2f}", data.empty() ? "M" : "L", at_x(p.x), at_y(p.y));
      out += fmt::format("<path class=\"curve\" stroke=\"{}\" d=\"{}\"/>\n", colour, data);
    }
    return out;
  }

  /// In the corner that the fewest points are in.
  std::string legend() const {
    std::size_t lines = 0, longest = 0;
    for (const PlotSeries& series : panel_.series) {
      lines += series.name.empty() ? 0 : 1;
      longest = std::max(longest, series.name.size());
    }
    const double wide = 8 + 6 * static_cast<double>(longest), tall = 8 + 14 * static_cast<double>(lines);
    double best_x = 0, best_y = 0;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const bool below : {false, true}) {
      for (const bool beside : {false, true}) {
        const double x = x_ + margin_left + (beside ? width() - wide : 0);
        const double y = y_ + margin_top + (below ? height() - tall : 0);
        const std::size_t found = points_within(x, x + wide, y, y + tall);
        if (found >= fewest) continue;
        fewest = found;
        best_x = x;
        best_y = y;
      }
    }
    std::string out;
    double y = best_y + 15;
    for (std::size_t s = 0; s < panel_.series.size(); ++s) {
      if (panel_.series[s].name.empty()) continue;
      out += fmt::format("<text class=\"legend\" fill=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                         plot_colours[s % plot_colours.size()], best_x + 8, y, svg::escaped(panel_.series[s].name));
      y += 14;
    }
    return out;
  }

  /// Of all curves, taken ten between two given ones.
  std::size_t points_within(double low_x, double high_x, double low_y, double high_y) const {
    std::size_t count = 0;
    for (const PlotSeries& series : panel_.series) {
      for (std::size_t i = 0; i < series.points.size(); ++i) {
        const Vec2 from = series.points[i], to = series.points[std::min(i + 1, series.points.size() - 1)];
        for (int part = 0; part < 10; ++part) {
          const Vec2 p = series.marks ? from : from + 0.1 * part * (to - from);
          const double x = at_x(p.x), y = at_y(p.y);
          count += x >= low_x && x <= high_x && y >= low_y && y <= high_y ? 1 : 0;
        }
      }
    }
    return count;
  }

  const PlotPanel& panel_;
  double x_, y_;
  Range across_, up_;
};

}  // namespace

std::string plot_svg(const std::vector<PlotPanel>& panels) {
  const std::size_t columns = std::clamp<std::size_t>(panels.size(), 1, plots_in_a_row);
  const std::size_t rows = std::max<std::size_t>((panels.size() + columns - 1) / columns, 1);
  const double width = panel_width * static_cast<double>(columns), height = panel_height * static_cast<double>(rows);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\">\n<style>.grid{{stroke:#ddd;fill:none}}.frame{{stroke:#333;fill:none}}"
      ".curve{{fill:none;stroke-width:1.6}}.tick{{font-size:10px;fill:#333}}.axis{{font-size:11px;fill:#333}}"
      ".title{{font-size:13px;fill:#111}}.legend{{font-size:11px}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t column = i % columns, row = i / columns;
    out += Panel(panels[i], panel_width * static_cast<double>(column), panel_height * static_cast<double>(row)).drawn();
  }
  return out + "</svg>\n";
}

}  // namespace toile
