// Patterns of another program: imported, checked, and draped from where it put their panels.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

std::filesystem::path data() {
  const char* place = std::getenv("TOILE_DATA_DIR");
  return place != nullptr ? place : "../shared/data";
}

class Imported : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::filesystem::path pattern = data() / "garmentcode" / (GetParam() + std::string(".json"));
    if (!std::filesystem::exists(pattern)) GTEST_SKIP() << "needs " << pattern;
    const Called imported = call.toile("import '" + pattern.string() + "' -o made.toile");
    ASSERT_EQ(imported.exit_code, 0) << imported.err;
  }
  void expect_rest() {
    const Called draped = call.toile("drape made.toile --triangles 700 -o worn.glb --report worn.json");
    EXPECT_EQ(draped.exit_code, 0) << draped.err;
    EXPECT_NE(call.scratch.read("worn.json").find("\"intersecting_triangle_pairs\": 0"), std::string::npos);
  }
  CommandLine call;
};

std::string name(const testing::TestParamInfo<const char*>& garment) {
  return garment.param;
}

/// The dress form that the import takes, where nobody says another.
class OnTheForm : public Imported {};

TEST_P(OnTheForm, ComesToRestWithoutACrossing) {
  expect_rest();
}

INSTANTIATE_TEST_SUITE_P(Imported, OnTheForm,
                         testing::Values("circle_skirt", "pants_long", "dress_pencil", "many_panels_8"), name);

/// The body that the patterns were drafted for.
class OnTheirBody : public Imported {};

TEST_P(OnTheirBody, ComesToRestWithoutACrossing) {
  const std::filesystem::path body = data() / "bodies" / "female.obj";
  if (!std::filesystem::exists(body)) GTEST_SKIP() << "needs " << body;
  const std::string script = call.scratch.read("made.toile");
  const std::string any_body = "body form = bodies.dress_form()";
  ASSERT_NE(script.find(any_body), std::string::npos);
  call.scratch.write("made.toile", std::string(script).replace(script.find(any_body), any_body.size(),
                                                               "body form = mesh(\"" + body.string() + R"(") with {
  line waist { through (0cm, -4cm, 102.666cm), normal (0, 0, 1) }
})"));
  expect_rest();
}

INSTANTIATE_TEST_SUITE_P(Imported, OnTheirBody,
                         testing::Values("circle_skirt", "dress_pencil", "fitted_sleeveless", "many_panels_8",
                                         "pants_long", "pencil_skirt", "skirt2_flared", "tank_sleeveless",
                                         "tshirt_short"),
                         name);

}  // namespace
}  // namespace toile
