#include "runtime/export/svg.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

namespace toile::svg {

namespace {

using std::numbers::pi;

std::string drawn(const LineSegment& line) {
  return "L" + place(line.to);
}

// A flag of SVG's arc says "clockwise on paper"; arcs beyond a half circle are drawn in parts, so that the other flag,
// "the longer way", is never needed.
std::string drawn(const ArcSegment& arc) {
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (0.75 * pi))));
  const std::string radius = mm(arc.radius);
  std::string data;
  for (int i = 1; i <= parts; ++i) {
    const Vec2 end = arc.centre + arc.radius * direction(arc.start + arc.sweep * i / parts);
    data += fmt::format("A{} {} 0 0 {} {}", radius, radius, arc.sweep < 0 ? 1 : 0, place(end));
  }
  return data;
}

std::string drawn(const BezierSegment& bezier) {
  return fmt::format("C{} {} {}", place(bezier.p1), place(bezier.p2), place(bezier.p3));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) safe += c;
    }
  }
  return safe;
}

std::string mm(double metres) {
  std::string number = fmt::format("{:.2f}", 1000 * metres);
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number == "-0" ? "0" : number;
}

std::string place(Vec2 point) {
  return mm(point.x) + "," + mm(-point.y);
}

std::string path_data(const std::vector<const Curve*>& curves, bool closed) {
  std::string data;
  for (const Curve* curve : curves) {
    if (data.empty()) data = "M" + place(curve->start());
    for (const Segment& segment : curve->segments()) {
      data += std::visit([](const auto& s) { return drawn(s); }, segment);
    }
  }
  return closed ? data + "Z" : data;
}

std::string polygon_data(const std::vector<Vec2>& points) {
  std::string data;
  for (const Vec2 point : points) data += (data.empty() ? "M" : "L") + place(point);
  return data + "Z";
}

std::string path(std::string_view css_class, std::string_view data) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css_class, data);
}

std::string line(std::string_view css_class, Vec2 from, Vec2 to) {
  return path(css_class, "M" + place(from) + "L" + place(to));
}

std::string text(std::string_view css_class, Vec2 at, double size, std::string_view content, double angle) {
  const std::string degrees = fmt::format("{:.2f}", -angle * 180 / pi);
  // A third of the letters' size below the middle: the baseline of capitals that are centred on it.
  return fmt::format("<text class=\"{}\" font-size=\"{}\" transform=\"translate({}) rotate({})\" y=\"{}\">{}</text>\n",
                     css_class, mm(size), place(at), degrees == "-0.00" ? "0.00" : degrees, mm(0.35 * size),
                     escaped(content));
}

double text_width(std::string_view content, double size) {
  std::size_t letters = 0;
  for (const char c : content) letters += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;  // code points of UTF-8
  return 0.55 * size * static_cast<double>(letters);
}

}  // namespace toile::svg
