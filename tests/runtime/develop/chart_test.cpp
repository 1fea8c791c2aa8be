// Places of a chart on the body.
#include "runtime/develop/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace {

using std::numbers::pi;

std::shared_ptr<const Body> made(const BodySpec& spec) {
  std::string error;
  auto body = Body::make(spec, &error);
  EXPECT_TRUE(body) << error;
  return body;
}

std::shared_ptr<const Body> tube() {
  BodySpec spec;
  spec.shape = CylinderSpec{0.15, 0.8, 0.4, true};
  return made(spec);
}
std::shared_ptr<const Body> ball() {
  BodySpec spec;
  spec.shape = SphereSpec{0.15, 0.5};
  return made(spec);
}

BodyChart chart_of(const Body& body, const ChartSpec& spec = {}) {
  std::string error;
  BodyChart chart(body, spec, error);
  EXPECT_EQ(error, "");
  return chart;
}

TEST(CylinderChart, RunsFromTheFrontToTheWearersLeft) {
  const auto body = tube();
  const BodyChart chart = chart_of(*body);
  for (const double angle : {0.0, 0.4, pi / 2, -2.0, 3.1}) {
    const BodyChart::Meeting meeting = chart.at({0.1 * angle, 0.3});
    ASSERT_EQ(meeting.times, 1);
    EXPECT_NEAR(std::atan2(meeting.point.x, -meeting.point.y), angle, 1e-9);
    EXPECT_NEAR(std::hypot(meeting.point.x, meeting.point.y), 0.15, 5e-4);
    EXPECT_NEAR(meeting.point.z, 0.3, 1e-12);
  }
}

TEST(CylinderChart, MeetsNothingBeyondTheBody) {
  const auto body = tube();
  EXPECT_EQ(chart_of(*body).at({0, 0.81}).times, 0);
  EXPECT_EQ(chart_of(*body).at({0, -0.01}).times, 0);
  EXPECT_EQ(chart_of(*body).at({0, 0.79}).times, 1);
}

TEST(CylinderChart, MeetsEveryPlaceOnceAlsoOnEdgesOfTriangles) {
  const auto body = ball();
  const BodyChart chart = chart_of(*body);
  for (int i = 0; i < 400; ++i) {
    for (int j = 1; j < 40; ++j) EXPECT_EQ(chart.at({0.001 * i, 0.35 + 0.3 * j / 40}).times, 1) << i << " " << j;
  }
}

TEST(CylinderChart, AboutALineHasItsHeightThere) {
  const auto body = tube();
  ChartSpec spec;
  spec.line = "middle";
  EXPECT_NEAR(chart_of(*body, spec).at({0, 0.1}).point.z, 0.5, 1e-9);
  spec.line = "elbow";
  std::string error;
  const BodyChart none(*body, spec, error);
  EXPECT_EQ(error, "the body has no line `elbow`");
  EXPECT_EQ(none.at({0, 0.1}).times, 0);
}

TEST(CylinderChart, KeepsTheEaseFromTheBody) {
  const auto body = tube();
  ChartSpec spec;
  spec.ease = 0.02;
  const Vec3 p = chart_of(*body, spec).at({0.05, 0.3}).point;
  EXPECT_NEAR(std::hypot(p.x, p.y), 0.17, 5e-4);
}

TEST(DomeChart, MeasuresTheAngleOffItsPole) {
  const auto body = ball();
  ChartSpec spec;
  spec.map = ChartSpec::Map::Dome;
  spec.radius = 0.15;
  const BodyChart chart = chart_of(*body, spec);
  EXPECT_NEAR(chart.at({0, 0}).point.z, 0.65, 1e-4);
  const Vec3 left = chart.at({0.15 * pi / 3, 0}).point;
  EXPECT_NEAR(left.x, 0.15 * std::sin(pi / 3), 5e-4);
  EXPECT_NEAR(left.z - 0.5, 0.15 * std::cos(pi / 3), 5e-4);
  const Vec3 front = chart.at({0, -0.15 * pi / 2 * 0.999}).point;
  EXPECT_NEAR(front.y, -0.15, 5e-4);
  EXPECT_EQ(chart.at({0.15 * pi * 1.01, 0}).times, 0);
}

TEST(Chart, MeetsAnArmAndTheTrunkTwice) {
  BodySpec spec;
  FormSpec form;
  const auto section = [&](const char* name, double level, double girth) {
    BodySection s;
    s.name = name;
    s.level = level;
    s.girth = girth;
    form.sections.push_back(s);
  };
  section("hip", 0.8, 0.94);
  section("waist", 1.0, 0.68);
  section("bust", 1.2, 0.88);
  section("", 1.35, 0.7);
  section("neck", 1.4, 0.36);
  BodyLimb arm;
  arm.girth_root = 0.4;
  arm.girth_tip = 0.28;
  arm.length = 0.3;
  arm.angle = 0.15;
  form.limbs = {arm};
  spec.shape = form;
  const auto body = made(spec);
  const BodyChart chart = chart_of(*body);
  int most = 0;
  for (int i = 0; i < 60; ++i) most = std::max(most, chart.at({0.1 * pi / 2, 0.9 + 0.005 * i}).times);
  EXPECT_EQ(most, 2);
}

}  // namespace
}  // namespace toile
