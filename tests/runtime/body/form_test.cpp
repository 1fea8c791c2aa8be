// Dress forms: closed surfaces whose lines have the girths asked for.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/body/body.hpp"
#include "runtime/body/manifold.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

FormSpec form_of(double waist, double hip, double bust, double neck) {
  FormSpec form = sample_form();
  for (BodySection& s : form.sections) {
    const double asked = s.name == "waist" ? waist : s.name == "hip" ? hip : s.name == "bust" ? bust : neck;
    if (!s.name.empty()) s.girth = asked;
  }
  return form;
}

// Twice the area that a line encloses, seen against its axis; positive when it runs counter-clockwise.
double circulation(const BodyLine& line) {
  Vec3 sum;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    sum += cross(line.points[i] - line.points[0], line.points[(i + 1) % line.points.size()] - line.points[0]);
  }
  return dot(sum, -line.axis);
}

TEST(DressForm, IsAClosedManifoldFacingOutwards) {
  std::string error;
  const auto body = Body::make(body_of(sample_form()), &error);
  ASSERT_TRUE(body) << error;
  EXPECT_EQ(manifold_fault(body->surface()), "");
  EXPECT_GT(signed_volume(body->surface()), 0.03);
  EXPECT_LT(signed_volume(body->surface()), 0.08);
  const auto triangles = body->surface().triangles.size();
  EXPECT_GE(triangles, 6000u);
  EXPECT_LE(triangles, 14000u);
  // Euler characteristic of a ball's surface: no handle, no hole.
  EXPECT_EQ(static_cast<int>(body->surface().points.size()) - static_cast<int>(triangles) / 2, 2);
}

TEST(DressForm, GirthsAreThoseAskedFor) {
  std::string error;
  const auto body = Body::make(body_of(sample_form()), &error);
  ASSERT_TRUE(body) << error;
  const std::vector<std::pair<const char*, double>> asked{
      {"waist", 0.68},        {"hip", 0.94},           {"bust", 0.88},     {"neck", 0.36},
      {"left_armhole", 0.40}, {"right_armhole", 0.40}, {"left_leg", 0.54}, {"right_leg", 0.54}};
  for (const auto& [name, girth] : asked) {
    const BodyLine* line = body->line(name);
    ASSERT_NE(line, nullptr) << name;
    EXPECT_NEAR(line->girth, girth, 1e-9) << name;
  }
  EXPECT_NE(body->line("left_crotch"), nullptr);
  EXPECT_NE(body->line("right_crotch"), nullptr);
  EXPECT_EQ(body->line("elbow"), nullptr);
}

TEST(DressForm, LinesLieOnTheSurfaceStartAtTheFrontAndRunCounterClockwise) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  for (const BodyLine& line : body->lines()) {
    EXPECT_NEAR(norm(line.axis), 1, 1e-12);
    EXPECT_GT(circulation(line), 0) << line.name;
    for (const Vec3& p : line.points) {
      const auto surface = body->nearest(p, 1e-3);
      ASSERT_TRUE(surface) << line.name;
      EXPECT_NEAR(surface->distance, 0, 1e-9) << line.name;
    }
    if (line.name.find("crotch") != std::string::npos) continue;
    for (const Vec3& p : line.points) EXPECT_GE(p.y, line.points[0].y - 1e-9) << line.name;
  }
}

TEST(DressForm, IsItsOwnMirrorImage) {
  const auto body = Body::make(body_of(sample_form()), nullptr);
  ASSERT_TRUE(body);
  for (const Vec3& p : body->surface().points) {
    const auto mirrored = body->nearest({-p.x, p.y, p.z}, 1e-3);
    ASSERT_TRUE(mirrored);
    EXPECT_NEAR(mirrored->distance, 0, 1e-9);
  }
}

// A point a hair off the middle of a triangle is that far from the surface: no other part of it passes by.
TEST(DressForm, DoesNotCrossItself) {
  for (const FormSpec& form : {form_of(0.68, 0.94, 0.88, 0.36), form_of(0.60, 0.86, 0.80, 0.33),
                               form_of(0.95, 1.15, 1.10, 0.42), form_of(0.56, 1.05, 0.84, 0.34)}) {
    std::string error;
    const auto body = Body::make(body_of(form), &error);
    ASSERT_TRUE(body) << error;
    EXPECT_EQ(manifold_fault(body->surface()), "");
    const Body::Surface& s = body->surface();
    for (const auto& [a, b, c] : s.triangles) {
      const Vec3 middle = (s.points[a] + s.points[b] + s.points[c]) / 3;
      const Vec3 normal = normalized(cross(s.points[b] - s.points[a], s.points[c] - s.points[a]));
      for (const double off : {2e-4, -2e-4}) {
        const auto found = body->nearest(middle + off * normal, 1e-3);
        ASSERT_TRUE(found);
        ASSERT_NEAR(found->distance, off, 1e-5) << middle.x << " " << middle.y << " " << middle.z;
      }
    }
  }
}

TEST(DressForm, StandsWithoutLimbs) {
  FormSpec form = sample_form();
  form.limbs.clear();
  const auto body = Body::make(body_of(form), nullptr);
  ASSERT_TRUE(body);
  EXPECT_EQ(manifold_fault(body->surface()), "");
  EXPECT_EQ(body->lines().size(), 4u);
  EXPECT_NEAR(body->top().x, 0, 1e-12);
  EXPECT_GT(body->top().z, 1.45);
}

TEST(DressForm, SaysWhatIsWrong) {
  std::string error;
  FormSpec form = sample_form();
  form.sections[3].girth = -1;
  EXPECT_FALSE(Body::make(body_of(form), &error));
  EXPECT_EQ(error, "section waist must have a girth from 5 cm to 5 m");

  form = sample_form();
  form.sections[3].level = form.sections[1].level - 0.01;
  EXPECT_FALSE(Body::make(body_of(form), &error));
  EXPECT_NE(error.find("sections are listed upwards"), std::string::npos) << error;

  form = sample_form();
  form.sections[5].forward = std::nan("");
  EXPECT_FALSE(Body::make(body_of(form), &error));
  EXPECT_NE(error.find("section bust"), std::string::npos) << error;

  form = sample_form();
  form.sections.resize(4);  // no shoulders
  EXPECT_FALSE(Body::make(body_of(form), &error));
  EXPECT_NE(error.find("no room for the arms"), std::string::npos) << error;

  form.sections.resize(1);
  EXPECT_FALSE(Body::make(body_of(form), &error));
  EXPECT_EQ(error, "a form needs two sections at least");
}

}  // namespace
}  // namespace toile
