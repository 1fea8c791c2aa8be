#include "runtime/render/scale_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "runtime/render/stroke_font.hpp"

namespace toile {
namespace {

constexpr Colour kInk{58, 58, 62};

/// Lengths on a picture of 800 pixels grow and shrink with it.
double unit(int width, int height) {
  return std::min(width, height) / 800.0;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return distance(p, a + t * along);
}

class Drawing {
 public:
  explicit Drawing(Image& image) : image_(image) {}

  void blend(int x, int y, Colour colour, double cover) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || !(cover > 0)) return;
    const std::size_t at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x));
    const auto channel = [&](std::size_t c, std::uint8_t value) {
      const double mixed = (1 - cover) * image_.rgb[at + c] + cover * value;
      image_.rgb[at + c] = static_cast<std::uint8_t>(std::lround(mixed));
    };
    channel(0, colour.r);
    channel(1, colour.g);
    channel(2, colour.b);
  }

  /// A polyline with round ends, in pixels.
  void stroke(const Stroke& points, double width, Colour colour) {
    Vec2 low = points.front();
    Vec2 high = low;
    for (const Vec2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double reach = width / 2 + 1;
    for (int y = clamped(low.y - reach, image_.height); y <= clamped(high.y + reach, image_.height); ++y) {
      for (int x = clamped(low.x - reach, image_.width); x <= clamped(high.x + reach, image_.width); ++x) {
        const Vec2 centre{x + 0.5, y + 0.5};
        double off = distance(centre, points.front());
        for (std::size_t i = 1; i < points.size(); ++i) {
          off = std::min(off, distance_to_segment(centre, points[i - 1], points[i]));
        }
        blend(x, y, colour, std::clamp(width / 2 - off + 0.5, 0.0, 1.0));
      }
    }
  }

  /// Capitals `height` pixels high, the baseline's left end at `at`.
  void text(std::string_view words, Vec2 at, double height) {
    for (Stroke stroke_points : text_strokes(words)) {
      for (Vec2& p : stroke_points) p = {at.x + height * p.x, at.y - height * p.y};
      stroke(stroke_points, std::max(1.0, 0.13 * height), kInk);
    }
  }

 private:
  static int clamped(double x, int size) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(size - 1)));
  }

  Image& image_;
};

/// The bar itself; beyond its ends it runs out in a point where values do.
void draw_colours(Drawing& drawing, const BarPlace& bar, const FieldScale& scale) {
  const double middle = (bar.left + bar.right) / 2.0;
  const double half = (bar.right - bar.left) / 2.0;
  const int tip = static_cast<int>(std::lround(half));
  const double span = bar.bottom - bar.top;
  for (int y = bar.top - tip; y < bar.bottom + tip; ++y) {
    double reach = half;
    if (y < bar.top) reach = scale.greatest() > scale.high() ? half - (bar.top - y - 0.5) : 0;
    if (y >= bar.bottom) reach = scale.least() < scale.low() ? half - (y + 0.5 - bar.bottom) : 0;
    if (reach <= 0) continue;
    const double t = std::clamp((bar.bottom - y - 0.5) / span, 0.0, 1.0);
    const Colour colour = srgb(scale.colour(scale.low() + t * (scale.high() - scale.low())));
    for (int x = bar.left; x < bar.right; ++x) {
      drawing.blend(x, y, colour, std::clamp(reach - std::abs(x + 0.5 - middle) + 0.5, 0.0, 1.0));
    }
  }
}

}  // namespace

double scale_bar_width(int width, int height) {
  return std::min(0.3 * width, 150 * unit(width, height));
}

BarPlace scale_bar_place(int width, int height) {
  const double strip = scale_bar_width(width, height);
  const int left = static_cast<int>(std::lround(width - 0.86 * strip));
  const int thick = std::max(2, static_cast<int>(std::lround(0.15 * strip)));
  return {left, left + thick, static_cast<int>(std::lround(0.22 * height)),
          std::max(static_cast<int>(std::lround(0.22 * height)) + 1, static_cast<int>(std::lround(0.80 * height)))};
}

void draw_scale_bar(Image& image, const FieldScale& scale) {
  Drawing drawing(image);
  const double u = unit(image.width, image.height);
  const BarPlace bar = scale_bar_place(image.width, image.height);
  draw_colours(drawing, bar, scale);

  const double letters = 10.5 * u;
  const double room = image.width - bar.left - 10 * u;
  const auto fitted = [&](std::string_view words, double height) {
    return std::min(height, room / std::max(text_width(words), 1e-9));
  };
  const auto line = [&](std::string_view words, double baseline, double height) {
    drawing.text(words, {static_cast<double>(bar.left), baseline}, fitted(words, height));
  };
  line(scale.name(), bar.top - 62 * u, 1.15 * letters);
  const auto extreme = [&](std::string_view which, double value) {
    const double shown = value * scale.to_unit();
    return fmt::format("{} {}", which, tick_label(shown, std::max(std::abs(shown) / 150, 1e-3)));
  };
  line(fmt::format("in {}", scale.unit()), bar.top - 42 * u, letters);
  line(extreme("max", scale.greatest()), bar.top - 19 * u, letters);
  line(extreme("min", scale.least()), bar.bottom + 29 * u, letters);

  const std::vector<double> ticks = scale.ticks();
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
  const double low = scale.low() * scale.to_unit();
  const double high = scale.high() * scale.to_unit();
  for (const double tick : ticks) {
    const double y = bar.bottom - (tick - low) / (high - low) * (bar.bottom - bar.top);
    const double x = bar.right + 2 * u;
    drawing.stroke({{x, y}, {x + 4 * u, y}}, std::max(1.0, 1.3 * u), kInk);
    drawing.text(tick_label(tick, step), {x + 14 * u, y + letters / 2}, letters);
  }
}

}  // namespace toile
