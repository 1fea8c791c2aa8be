// Patterns of another program: imported, checked, and draped from where it put their panels.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

class Imported : public testing::TestWithParam<const char*> {
 protected:
  CommandLine call;
};

TEST_P(Imported, ComesToRestOnTheFormWithoutACrossing) {
  const char* data = std::getenv("TOILE_DATA_DIR");
  const std::filesystem::path pattern = std::filesystem::path(data != nullptr ? data : "../shared/data") /
                                        "garmentcode" / (GetParam() + std::string(".json"));
  if (!std::filesystem::exists(pattern)) GTEST_SKIP() << "needs " << pattern;
  const Called imported = call.toile("import '" + pattern.string() + "' -o made.toile");
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  const Called draped = call.toile("drape made.toile --triangles 700 -o worn.glb --report worn.json");
  EXPECT_EQ(draped.exit_code, 0) << draped.err;
  EXPECT_NE(call.scratch.read("worn.json").find("\"intersecting_triangle_pairs\": 0"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Of, Imported, testing::Values("circle_skirt", "pants_long", "dress_pencil", "many_panels_8"),
                         [](const auto& garment) { return std::string(garment.param); });

}  // namespace
}  // namespace toile
