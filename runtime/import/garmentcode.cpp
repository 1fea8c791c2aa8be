#include "runtime/import/garmentcode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

// Far beyond any garment; a file that claims more is none.
constexpr std::size_t most_bytes = std::size_t{16} << 20;
constexpr int most_nesting = 64;
constexpr std::size_t most_panels = 1000;
constexpr std::size_t most_edges = 2000;  // of a panel
constexpr std::size_t most_stitches = 20000;
constexpr double longest = 100;           // [m]
constexpr double shortest = 1e-6;         // [m] an edge
constexpr double least_sagitta = 1e-7;    // [m] of what is still an arc
constexpr double radius_rounding = 1e-6;  // by which the radius of a half circle may fall short

/// Ends the reading; caught by read_garmentcode().
struct Refused {
  std::string why;
};

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw Refused{where.empty() ? why : where + ": " + why};
}

const Json& member(const Json& object, const char* key, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end()) refuse(where, fmt::format("there is no \"{}\"", key));
  return *found;
}

const Json& list(const Json& json, std::size_t most, const std::string& what, const std::string& where) {
  if (!json.is_array()) refuse(where, fmt::format("{} are no list", what));
  if (json.size() > most) refuse(where, fmt::format("{} {}, more than {}", json.size(), what, most));
  return json;
}

double number(const Json& json, const std::string& what, const std::string& where) {
  if (!json.is_number()) refuse(where, what + " is no number");
  const double value = json.get<double>();
  if (!std::isfinite(value)) refuse(where, what + " is not finite");
  return value;
}

std::size_t index(const Json& json, std::size_t count, const std::string& what, const std::string& where) {
  if (!json.is_number_integer()) refuse(where, what + " is no whole number");
  const auto value = json.get<std::int64_t>();
  if (value < 0 || static_cast<std::uint64_t>(value) >= count) {
    refuse(where, fmt::format("there is no {} {}; they count from 0 and there are {}", what, value, count));
  }
  return static_cast<std::size_t>(value);
}

std::string member_text(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

bool flag(const Json& json, const std::string& what, const std::string& where) {
  if (json.is_boolean()) return json.get<bool>();
  return number(json, what, where) != 0;
}

/// Two numbers, in whatever unit.
Vec2 pair(const Json& json, const std::string& what, const std::string& where) {
  if (!json.is_array() || json.size() != 2) refuse(where, what + " is no pair of numbers");
  return {number(json[0], what, where), number(json[1], what, where)};
}

std::array<double, 3> triple(const Json& panel, const char* key, const std::string& where) {
  std::array<double, 3> values{};
  const auto found = panel.find(key);
  if (found == panel.end()) return values;
  if (!found->is_array() || found->size() != 3) refuse(where, fmt::format("\"{}\" has not three numbers", key));
  for (std::size_t i = 0; i < 3; ++i) values[i] = number((*found)[i], fmt::format("\"{}\"", key), where);
  return values;
}

/// From the edge's own frame (x along it, y to its left, its length the unit).
Vec2 control_point(Vec2 relative, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  return from + relative.x * along + relative.y * Vec2{-along.y, along.x};
}

class Reader {
 public:
  ForeignPattern read(const Json& file) {
    if (!file.is_object()) refuse("", "the file holds no pattern");
    read_properties(file);
    const Json& pattern = member(file, "pattern", "");
    if (!pattern.is_object()) refuse("", "\"pattern\" is no object");
    const Json& panels = member(pattern, "panels", "");
    if (!panels.is_object() || panels.empty()) refuse("", "there are no panels");
    if (panels.size() > most_panels) refuse("", fmt::format("{} panels, more than {}", panels.size(), most_panels));
    for (const auto& [name, panel] : panels.items()) pattern_.panels.push_back(read_panel(name, panel));
    if (const auto stitches = pattern.find("stitches"); stitches != pattern.end()) read_stitches(*stitches);
    return std::move(pattern_);
  }

 private:
  void read_properties(const Json& file) {
    const auto properties = file.find("properties");
    if (properties == file.end() || !properties->is_object()) return;
    if (const auto units = properties->find("units_in_meter"); units != properties->end()) {
      units_in_metre_ = number(*units, "\"units_in_meter\"", "");
      if (!(units_in_metre_ >= 1e-3 && units_in_metre_ <= 1e6)) refuse("", "\"units_in_meter\" is no unit of length");
    }
    if (const std::string frame = member_text(*properties, "curvature_coords"); !frame.empty() && frame != "relative") {
      refuse("", fmt::format(R"("curvature_coords" are "{}"; only "relative" ones are read)", frame));
    }
  }

  Vec2 point(const Json& json, const std::string& what, const std::string& where) const {
    const Vec2 units = pair(json, what, where);
    const Vec2 metres{units.x / units_in_metre_, units.y / units_in_metre_};
    if (std::abs(metres.x) > longest || std::abs(metres.y) > longest) refuse(where, what + " is more than 100 m away");
    return metres;
  }

  ForeignPanel read_panel(const std::string& name, const Json& json) const {
    const std::string where = fmt::format("panel \"{}\"", name);
    if (!json.is_object()) refuse(where, "it is no object");
    ForeignPanel panel{name, member_text(json, "label"), {}, read_placement(json, where)};
    std::vector<Vec2> vertices;
    for (const Json& vertex : list(member(json, "vertices", where), most_edges, "vertices", where)) {
      vertices.push_back(point(vertex, fmt::format("vertex {}", vertices.size()), where));
    }
    for (const Json& edge : list(member(json, "edges", where), most_edges, "edges", where)) {
      panel.edges.push_back(read_edge(edge, vertices, fmt::format("{}, edge {}", where, panel.edges.size())));
    }
    check_closed(panel, where);
    return panel;
  }

  std::optional<ForeignPlacement> read_placement(const Json& panel, const std::string& where) const {
    if (!panel.contains("translation") && !panel.contains("rotation")) return std::nullopt;
    ForeignPlacement placement{triple(panel, "translation", where), triple(panel, "rotation", where)};
    for (double& length : placement.translation) length *= 100 / units_in_metre_;
    return placement;
  }

  static void check_closed(const ForeignPanel& panel, const std::string& where) {
    const std::size_t count = panel.edges.size();
    if (count < 2) refuse(where, "its outline has fewer than two edges");
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      if (distance(panel.edges[i].to, panel.edges[next].from) > shortest) {
        refuse(fmt::format("{}, edge {}", where, next), fmt::format("it does not begin where edge {} ends", i));
      }
    }
  }

  ForeignEdge read_edge(const Json& json, const std::vector<Vec2>& vertices, const std::string& where) const {
    if (!json.is_object()) refuse(where, "it is no object");
    const Json& ends = member(json, "endpoints", where);
    if (!ends.is_array() || ends.size() != 2) refuse(where, "\"endpoints\" are no pair of vertices");
    ForeignEdge edge;
    edge.label = member_text(json, "label");
    edge.from = vertices[index(ends[0], vertices.size(), "vertex", where)];
    edge.to = vertices[index(ends[1], vertices.size(), "vertex", where)];
    if (distance(edge.from, edge.to) < shortest) refuse(where, "it ends where it begins");
    const auto curvature = json.find("curvature");
    const bool is_straight = curvature == json.end() || curvature->is_null();
    edge.curve = is_straight ? line(edge.from, edge.to) : read_curve(*curvature, edge.from, edge.to, where);
    const double length = edge.curve.length();
    if (!(length >= shortest && length <= 10 * longest)) refuse(where, "its curve has no sensible length");
    return edge;
  }

  Curve read_curve(const Json& json, Vec2 from, Vec2 to, const std::string& where) const {
    // Older files write a quadratic curve's one control point alone.
    if (json.is_array()) return quadratic(pair(json, "\"curvature\"", where), from, to);
    if (!json.is_object()) refuse(where, "\"curvature\" is no object");
    const std::string type = member_text(json, "type");
    const Json& params = list(member(json, "params", where), 3, "\"params\"", where);
    const auto has = [&](std::size_t count) {
      if (params.size() != count) refuse(where, fmt::format(R"(a "{}" curve has {} "params")", type, count));
    };
    if (type == "quadratic") {
      has(1);
      return quadratic(pair(params[0], "a control point", where), from, to);
    }
    if (type == "cubic") {
      has(2);
      return bezier(from, control_point(pair(params[0], "a control point", where), from, to),
                    control_point(pair(params[1], "a control point", where), from, to), to);
    }
    if (type == "circle") {
      has(3);
      return arc(params, from, to, where);
    }
    refuse(where, fmt::format("the type of its curve, \"{}\", is not quadratic, cubic or circle", type));
  }

  /// As a cubic, which it is exactly.
  static Curve quadratic(Vec2 relative, Vec2 from, Vec2 to) {
    const Vec2 control = control_point(relative, from, to);
    return bezier(from, from + (2.0 / 3) * (control - from), to + (2.0 / 3) * (control - to), to);
  }

  /// [radius, whether the longer arc is meant, whether it bulges to the right], as an SVG path has them.
  Curve arc(const Json& params, Vec2 from, Vec2 to, const std::string& where) const {
    double radius = number(params[0], "its radius", where) / units_in_metre_;
    const bool large = flag(params[1], "its choice of the longer arc", where);
    const bool turns_left = flag(params[2], "its side", where);
    const double half = distance(from, to) / 2;
    if (!(radius >= half * (1 - radius_rounding))) {
      refuse(where, fmt::format("a circle of radius {:.4g} cm does not reach from end to end, {:.4g} cm", 100 * radius,
                                200 * half));
    }
    radius = std::max(radius, half);
    if (!large && half * half / (2 * radius) < least_sagitta) return line(from, to);
    return arc_of_radius(from, to, turns_left ? radius : -radius, large);
  }

  void read_stitches(const Json& json) {
    for (const Json& stitch : list(json, most_stitches, "stitches", "")) {
      const std::string where = fmt::format("stitch {}", pattern_.stitches.size());
      if (!stitch.is_array() || stitch.size() < 2 || stitch.size() > 3) refuse(where, "it does not join two edges");
      ForeignStitch read{end(stitch[0], where), end(stitch[1], where)};
      if (stitch.size() == 3) {
        if (stitch[2] != "right_wrong") refuse(where, "what stands behind its edges is not \"right_wrong\"");
        read.to_wrong_side = true;
      }
      pattern_.stitches.push_back(read);
    }
  }

  ForeignEnd end(const Json& json, const std::string& where) const {
    if (!json.is_object()) refuse(where, "one of its ends is no object");
    const std::string name = member_text(json, "panel");
    const auto panel = std::ranges::find(pattern_.panels, name, &ForeignPanel::name);
    if (panel == pattern_.panels.end()) refuse(where, fmt::format("there is no panel \"{}\"", name));
    const std::string at_panel = fmt::format("{}, panel \"{}\"", where, name);
    return {static_cast<std::size_t>(panel - pattern_.panels.begin()),
            index(member(json, "edge", at_panel), panel->edges.size(), "edge", at_panel)};
  }

  double units_in_metre_ = 100;
  ForeignPattern pattern_;
};

Json parse(std::string_view bytes) {
  if (bytes.size() > most_bytes) refuse("", fmt::format("{} bytes, more than {}", bytes.size(), most_bytes));
  bool is_too_deep = false;
  const auto keep = [&is_too_deep](int depth, Json::parse_event_t, Json&) {
    is_too_deep |= depth > most_nesting;
    return depth <= most_nesting;
  };
  Json json = Json::parse(bytes, keep);
  if (is_too_deep) refuse("", fmt::format("its brackets are nested deeper than {}", most_nesting));
  return json;
}

}  // namespace

std::optional<ForeignPattern> read_garmentcode(std::string_view json, std::string& error) {
  try {
    return Reader().read(parse(json));
  } catch (const Refused& refused) {
    error = refused.why;
  } catch (const Json::exception& exception) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: …": the library's own name is of no use.
    const std::string_view what = exception.what();
    error = what.substr(std::min(what.find("] ") + 2, what.size()));
  }
  return std::nullopt;
}

}  // namespace toile
