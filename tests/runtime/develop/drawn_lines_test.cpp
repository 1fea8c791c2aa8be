// Maps of patches of a body, and the lines on it that maps show.
#include "runtime/develop/drawn_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace {

using std::numbers::pi;

std::shared_ptr<const Body> made_of(const BodySpec& spec) {
  std::string error;
  auto body = Body::make(spec, &error);
  EXPECT_TRUE(body) << error;
  return body;
}
constexpr double ball_radius = 0.15, ball_height = 0.5;
std::shared_ptr<const Body> round_ball() {
  BodySpec spec;
  spec.shape = SphereSpec{ball_radius, ball_height};
  return made_of(spec);
}
std::shared_ptr<const Body> round_tube() {
  BodySpec spec;
  spec.shape = CylinderSpec{ball_radius, 0.8, 0.4, true};
  return made_of(spec);
}
/// A trunk with arms.
std::shared_ptr<const Body> trunk_with_arms() {
  BodySpec spec;
  FormSpec shape;
  const auto section = [&](const char* name, double level, double girth, double ratio, double forward) {
    BodySection s;
    s.name = name;
    s.level = level;
    s.girth = girth;
    s.width_to_depth = ratio;
    s.forward = forward;
    shape.sections.push_back(s);
  };
  section("hip", 0.80, 0.94, 1.43, -0.015);
  section("waist", 1.015, 0.68, 1.31, 0);
  section("bust", 1.20, 0.88, 1.20, 0.02);
  section("", 1.32, 0.80, 1.75, -0.01);
  section("neck", 1.40, 0.36, 1.10, -0.01);
  BodyLimb arm;
  arm.girth_root = 0.40;
  arm.girth_tip = 0.30;
  arm.length = 0.15;
  arm.angle = 50 * pi / 180;
  shape.limbs.push_back(arm);
  spec.shape = shape;
  return made_of(spec);
}

ChartSpec conformal_about(Vec3 centre, double reach) {
  ChartSpec spec;
  spec.map = ChartSpec::Map::Conformal;
  spec.centre = {centre.x, centre.y, centre.z};
  spec.reach = reach;
  return spec;
}
BodyChart sound_chart(const Body& body, const ChartSpec& spec) {
  std::string error;
  BodyChart chart(body, spec, error);
  EXPECT_EQ(error, "");
  return chart;
}
double length_in_space(const BodyChart& chart, const Curve& curve) {
  double sum = 0;
  Vec3 before = chart.at(curve.start()).point;
  for (int i = 1; i <= 400; ++i) {
    const Vec3 here = chart.at(curve.at(curve.length() * i / 400)).point;
    sum += distance(before, here);
    before = here;
  }
  return sum;
}

TEST(ConeChart, IsTheConeUnrolled) {
  const auto body = round_tube();
  ChartSpec spec;
  spec.map = ChartSpec::Map::Cone;
  spec.line = "middle";
  spec.radius = 0.12;
  for (const double angle : {0.2, -0.3}) {
    spec.angle = angle;
    const BodyChart chart = sound_chart(*body, spec);
    EXPECT_NEAR(chart.at({0, -0.1}).point.z, 0.4 - 0.1 * std::cos(angle), 1e-9);
    // Once round, at the line, along a circle about the tip.
    const double side = 0.12 / std::sin(angle);
    const Vec2 there =
        Vec2{0, side} - std::abs(side) * Vec2{-std::sin(pi / 2 * std::sin(std::abs(angle))),
                                              (side > 0 ? 1 : -1) * std::cos(pi / 2 * std::sin(std::abs(angle)))};
    const BodyChart::Meeting left = chart.at(there);
    ASSERT_EQ(left.times, 1);
    EXPECT_NEAR(left.point.x, ball_radius, 1e-3);
    EXPECT_NEAR(left.point.y, 0, 1e-9);
    EXPECT_NEAR(left.point.z, 0.4, 1e-9);
  }
}

TEST(Charts, FindAPlaceAgainFromItsPoint) {
  const auto body = round_ball();
  ChartSpec cylinder, cone, dome;
  cone.map = ChartSpec::Map::Cone;
  cone.line = "equator";
  if (body->line(cone.line) == nullptr && !body->lines().empty()) cone.line = body->lines().front().name;
  cone.angle = 0.3;
  dome.map = ChartSpec::Map::Dome;
  struct Case {
    ChartSpec spec;
    Vec2 place;
  };
  for (const Case& each :
       {Case{cylinder, {0.05, 0.52}}, Case{cylinder, {-0.4, 0.45}}, Case{cone, {0.03, -0.02}},
        Case{dome, {0.04, -0.03}}, Case{conformal_about({0, -ball_radius, ball_height}, 0.1), {0.02, 0.03}}}) {
    const BodyChart chart = sound_chart(*body, each.spec);
    const BodyChart::Meeting meeting = chart.at(each.place);
    ASSERT_EQ(meeting.times, 1);
    const auto again = chart.place_of(meeting.point, each.place);
    ASSERT_TRUE(again);
    EXPECT_LT(distance(*again, each.place), 1e-9);
  }
}

/// The conformal map of a round cap that leaves its middle as it is, is the stereographic one.
TEST(ConformalChart, OfACapIsStereographic) {
  const auto body = round_ball();
  const BodyChart chart = sound_chart(*body, conformal_about({0, -ball_radius, ball_height}, 0.14));
  for (const double off : {0.2, 0.5, 0.8}) {
    for (const double round : {0.0, 1.0, 2.5, 4.0}) {
      const Vec3 p{ball_radius * std::sin(off) * std::cos(round), -ball_radius * std::cos(off),
                   ball_height + ball_radius * std::sin(off) * std::sin(round)};
      const auto place = chart.place_of(p);
      ASSERT_TRUE(place);
      const Vec2 theory = 2 * ball_radius * std::tan(off / 2) * direction(round);
      EXPECT_LT(distance(*place, theory), 0.02 * norm(theory)) << off << " " << round;
      EXPECT_EQ(chart.at(*place).times, 1);
    }
  }
  EXPECT_EQ(chart.at({0.3, 0}).times, 0);
}

TEST(ConformalChart, ThatGoesAllTheWayRoundIsRefused) {
  const auto body = round_tube();
  std::string error;
  const BodyChart chart(*body, conformal_about({0, -ball_radius, 0.4}, 0.35), error);
  EXPECT_EQ(error, "the part of the body that it reaches is no disc: it goes all the way round");
  EXPECT_EQ(chart.at({0, 0}).times, 0);
}

TEST(ConformalChart, ShowsALimbCutOpen) {
  const auto body = trunk_with_arms();
  const BodyLine* armhole = body->line("left_armhole");
  ASSERT_NE(armhole, nullptr);
  ChartSpec spec;
  spec.map = ChartSpec::Map::Conformal;
  spec.line = "left_armhole";
  spec.reach = 0.07;
  const BodyChart chart = sound_chart(*body, spec);
  ChartQuestion question;
  question.kind = ChartQuestion::Kind::Line;
  question.line = "left_armhole";
  std::string error;
  const Curve line = answer(question, *body, chart, error).curve;
  ASSERT_EQ(error, "");
  EXPECT_NEAR(length_in_space(chart, line), armhole->girth, 0.03 * armhole->girth);
  // Down the limb is down in the map.
  const Vec2 below{0, -0.05};
  ASSERT_EQ(chart.at(below).times, 1);
  EXPECT_NEAR(dot(chart.at(below).point - chart.at({0, 0}).point, armhole->axis), 0.05, 0.015);
}

TEST(Geodesics, AreGreatCirclesOfABall) {
  const auto body = round_ball();
  for (const ChartSpec& spec : {ChartSpec{}, conformal_about({0, -ball_radius, ball_height}, 0.14)}) {
    const BodyChart chart = sound_chart(*body, spec);
    const double level = spec.map == ChartSpec::Map::Conformal ? 0.05 : ball_height + 0.05;
    ChartQuestion question;
    question.kind = ChartQuestion::Kind::Geodesic;
    question.from = {-0.06, level};
    question.to = {0.07, level};
    std::string error;
    const Curve way = answer(question, *body, chart, error).curve;
    ASSERT_EQ(error, "");
    EXPECT_EQ(way.start(), question.from);
    EXPECT_EQ(way.end(), question.to);
    const Vec3 middle{0, 0, ball_height}, a = chart.at(question.from).point, b = chart.at(question.to).point;
    const Vec3 across = normalized(cross(a - middle, b - middle));
    // On the facets of the mesh the shortest way strays a little from the great circle, and is no longer.
    for (int i = 0; i <= 20; ++i) {
      EXPECT_LT(std::abs(dot(chart.at(way.at(way.length() * i / 20)).point - middle, across)), 6e-4);
    }
    const double angle = std::acos(dot(normalized(a - middle), normalized(b - middle)));
    EXPECT_LT(length_in_space(chart, way), (1 + 1e-5) * ball_radius * angle);
    EXPECT_GT(length_in_space(chart, way), (1 - 1e-3) * ball_radius * angle);
  }
}

TEST(Geodesics, AreStraightOnAnUnrolledTube) {
  const auto body = round_tube();
  ChartSpec spec;
  spec.radius = ball_radius;
  const BodyChart chart = sound_chart(*body, spec);
  const Vec2 from{0.0, 0.2}, to{0.3, 0.55};
  for (const Vec3 p : shortest_way(*body, chart, from, to)) {
    const Vec2 place = *chart.place_of(p, {0.15, 0.4});
    EXPECT_LT(std::abs(cross(place - from, to - from)) / distance(from, to), 3e-4);
  }
}

TEST(DrawnLines, GoThroughTheirPointsOnTheBody) {
  const auto body = round_ball();
  const BodyChart chart = sound_chart(*body, {});
  ChartQuestion question;
  question.kind = ChartQuestion::Kind::Drawn;
  question.points = {{-0.08, -0.12, 0.48}, {0.0, -0.16, 0.55}, {0.09, -0.12, 0.49}};
  std::string error;
  const Curve line = answer(question, *body, chart, error).curve;
  ASSERT_EQ(error, "");
  const auto middle = chart.place_of(body->nearest({0.0, -0.16, 0.55}, 0.03)->point);
  double nearest = 1;
  for (int i = 0; i <= 1000; ++i) nearest = std::min(nearest, distance(line.at(line.length() * i / 1000), *middle));
  EXPECT_LT(nearest, 3e-4);
  question.points.front() = {-0.08, -0.4, 0.48};
  answer(question, *body, chart, error);
  EXPECT_EQ(error, "(-8.0 cm, -40.0 cm, 48.0 cm) lies more than 3 cm off the body");
}

TEST(BodyLines, GoRoundFromBehindToBehind) {
  const auto body = trunk_with_arms();
  const BodyChart chart = sound_chart(*body, {});
  ChartQuestion question;
  question.kind = ChartQuestion::Kind::Line;
  question.line = "waist";
  std::string error;
  const Curve line = answer(question, *body, chart, error).curve;
  ASSERT_EQ(error, "");
  EXPECT_NEAR(line.start().x, -0.1 * pi, 1e-9);
  EXPECT_NEAR(line.end().x, 0.1 * pi, 1e-9);
  EXPECT_NEAR(line.start().y, 1.015, 1e-3);
  EXPECT_NEAR(length_in_space(chart, line), body->line("waist")->girth, 0.002);
}

}  // namespace
}  // namespace toile
