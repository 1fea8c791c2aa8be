// The reader of GarmentCode's files: curves in their geometry, and every way in which a file may be wrong.
#include "runtime/import/garmentcode.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>

#include "compiler/curve/segment.hpp"

namespace toile {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A triangle of 4, 3 and 5 cm whose edge 0, (0, 0) to (4, 0), has more to it.
std::string triangle(const std::string& more, const std::string& stitches = "[]") {
  return fmt::format(
      R"({{"pattern": {{"panels": {{"p": {{"vertices": [[0, 0], [4, 0], [4, 3]], "edges": [{{"endpoints": [0, 1]{}}}, )"
      R"({{"endpoints": [1, 2]}}, {{"endpoints": [2, 0]}}]}}}}, "stitches": {}}}}})",
      more, stitches);
}

Curve curve_of(const std::string& curvature) {
  std::string error;
  const auto pattern = read_garmentcode(triangle(R"(, "curvature": )" + curvature), error);
  EXPECT_TRUE(pattern) << error;
  return pattern ? pattern->panels[0].edges[0].curve : Curve();
}

std::string error_of(const std::string& json) {
  std::string error;
  EXPECT_FALSE(read_garmentcode(json, error)) << json;
  return error;
}

TEST(GarmentCode, RaisesQuadraticsToTheSameCurve) {
  const Curve curve = curve_of(R"({"type": "quadratic", "params": [[0.25, 0.5]]})");
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const Vec2 control{0.01, 0.02};  // to the left of the edge
    const Vec2 expected = 2 * t * (1 - t) * control + t * t * Vec2{0.04, 0};
    EXPECT_NEAR(distance(point(curve.segments()[0], t), expected), 0, 1e-16);
  }
}

TEST(GarmentCode, PutsTheControlPointsOfCubicsInTheEdgesFrame) {
  const auto cubic =
      std::get<BezierSegment>(curve_of(R"({"type": "cubic", "params": [[0.25, -0.5], [1.5, 1]]})").segments().front());
  EXPECT_NEAR(distance(cubic.p1, {0.01, -0.02}), 0, 1e-16);
  EXPECT_NEAR(distance(cubic.p2, {0.06, 0.04}), 0, 1e-16);
}

TEST(GarmentCode, HasArcsOnTheRightSideAndOfTheRightLength) {
  constexpr double pi = std::numbers::pi;
  struct Case {
    const char* params;
    double length, bulge;  // [cm]; to the left
  };
  const double small = 2 * std::asin(0.8) * 2.5, rest = 2 * pi * 2.5 - small;
  const Case cases[] = {{"[2.5, 0, 1]", small, -1},
                        {"[2.5, 0, 0]", small, 1},
                        {"[2.5, 1, 1]", rest, -4},
                        {"[2.5, 1, 0]", rest, 4},
                        {"[2, false, true]", 2 * pi, -2}};
  for (const Case& each : cases) {
    const Curve arc = curve_of(fmt::format(R"({{"type": "circle", "params": {}}})", each.params));
    EXPECT_NEAR(arc.length(), each.length / 100, 1e-12) << each.params;
    EXPECT_NEAR(arc.at(arc.length() / 2).y, each.bulge / 100, 1e-12) << each.params;
  }
}

TEST(GarmentCode, NamesPanelAndEdgeOfAMistake) {
  const std::pair<std::string, std::string> cases[] = {
      {R"(, "curvature": {"type": "circle", "params": [1, 0, 0]})", "does not reach from end to end"},
      {R"(, "curvature": {"type": "circle", "params": [1e300, 1, 0]})", "no sensible length"},
      {R"(, "curvature": {"type": "circle", "params": [3, 0]})", "has 3 \"params\""},
      {R"(, "curvature": {"type": "quadratic", "params": [[1e200, 1]]})", "no sensible length"},
      {R"(, "curvature": {"type": "quadratic", "params": [[1, "a"]]})", "a control point is no number"},
      {R"(, "curvature": {"type": "quintic", "params": []})", "\"quintic\", is not quadratic, cubic or circle"},
      {R"(, "curvature": {"type": "cubic"})", "there is no \"params\""},
      {R"(, "curvature": 3)", "\"curvature\" is no object"},
      {R"(, "endpoints": [0, 0])", "it ends where it begins"},
      {R"(, "endpoints": [0, 3])", "there is no vertex 3"},
      {R"(, "endpoints": [0, -1])", "there is no vertex -1"},
      {R"(, "endpoints": [0, 1.5])", "no whole number"},
  };
  for (const auto& [more, why] : cases) {
    const std::string error = error_of(triangle(more));
    EXPECT_THAT(error, StartsWith("panel \"p\", edge 0: ")) << more;
    EXPECT_THAT(error, HasSubstr(why)) << more;
  }
}

TEST(GarmentCode, RefusesOpenOutlines) {
  EXPECT_EQ(error_of(triangle(R"(, "endpoints": [1, 0])")), "panel \"p\", edge 1: it does not begin where edge 0 ends");
  EXPECT_EQ(error_of(triangle(R"(, "endpoints": [2, 1])")), "panel \"p\", edge 0: it does not begin where edge 2 ends");
}

TEST(GarmentCode, NamesTheStitchOfAMistake) {
  const std::pair<std::string, std::string> cases[] = {
      {"[[]]", "stitch 0: it does not join two edges"},
      {"3", "stitches are no list"},
      {R"([[{"panel": "q", "edge": 0}, {}]])", "stitch 0: there is no panel \"q\""},
      {R"([[{"panel": "p", "edge": 3}, {}]])", "stitch 0, panel \"p\": there is no edge 3"},
      {R"([[{"panel": "p"}, {}]])", R"(stitch 0, panel "p": there is no "edge")"},
      {R"([[{"panel": "p", "edge": 0}, {"panel": "p", "edge": 1}, "glue"]])", "is not \"right_wrong\""},
  };
  for (const auto& [stitches, why] : cases) EXPECT_THAT(error_of(triangle("", stitches)), HasSubstr(why));
}

TEST(GarmentCode, RefusesWhatIsNoPattern) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "line 1"},
      {"[]", "holds no pattern"},
      {"{}", "there is no \"pattern\""},
      {R"({"pattern": {"panels": {}}})", "there are no panels"},
      {R"({"pattern": {"panels": {"p": {"vertices": [[0, NaN]]}}}})", "line 1"},
      {R"({"pattern": {"panels": {"p": {"vertices": [[0, 1e999]]}}}})", "1e999"},
      {R"({"pattern": {"panels": {"p": {"vertices": [[0, 10001]]}}}})",
       "panel \"p\": vertex 0 is more than 100 m away"},
      {R"({"pattern": {"panels": {"p": {"vertices": [[0]]}}}})", "panel \"p\": vertex 0 is no pair of numbers"},
      {R"({"pattern": {"panels": {"p": {"rotation": [1], "vertices": []}}}})", "\"rotation\" has not three numbers"},
      {R"({"properties": {"units_in_meter": 0}, "pattern": {}})", "no unit of length"},
      {R"({"properties": {"curvature_coords": "absolute"}, "pattern": {}})", "only \"relative\" ones are read"},
      {std::string(100000, '['), "line 1"},
      {std::string(100000, '[') + std::string(100000, ']'), "nested deeper than 64"},
      {std::string(std::size_t{17} << 20, ' '), "bytes, more than"},
  };
  for (const auto& [json, why] : cases) {
    std::string error;
    EXPECT_FALSE(read_garmentcode(json, error)) << why;
    EXPECT_THAT(error, HasSubstr(why));
  }
}

TEST(GarmentCode, OutlivesBrokenBytes) {
  std::ifstream in(TOILE_SOURCE_DIR "/tests/runtime/import/curves.json", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  ASSERT_FALSE(whole.empty());
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    std::string broken = whole;
    for (int i = 0; i < 3; ++i) broken[random() % broken.size()] = "0123456789-.e[]{},\":null\xff"[random() % 26];
    std::string error;
    const bool is_read = read_garmentcode(broken, error).has_value();
    EXPECT_EQ(is_read, error.empty());
  }
}

}  // namespace
}  // namespace toile
