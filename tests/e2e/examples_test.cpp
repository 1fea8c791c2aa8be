// Every example, as its README has it run: it comes to rest, writes what it says and finds what it expects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

const std::map<std::string, std::vector<std::string>> examples{
    {"blouse", {"blouse.svg", "blouse.png", "blouse.report.json"}},
    {"apron", {"apron.svg", "apron.png", "apron.report.json"}},
    {"graded_skirt", {"skirt.svg", "skirt.png", "skirt.report.json"}},
    {"flared_skirt", {"skirt.svg", "skirt.png", "strain.png", "skirt.glb", "skirt.report.json"}},
    {"tight_skirt", {"skirt.svg", "skirt.png", "pressure.png", "skirt.report.json"}},
    {"cape", {"cape.svg", "cape.png", "cape.report.json"}},
    {"cloth_on_sphere", {"cloth.png", "cloth.report.json"}},
    {"drape_test", {"above.png", "drape_test.report.json"}},
    {"poncho", {"poncho.svg", "poncho.png", "poncho.report.json"}},
    {"trousers", {"trousers.svg", "trousers.png", "trousers.report.json"}},
    {"torus", {"torus.svg", "torus.png", "torus.report.json"}},
    {"developed_bodice",
     {"bodice.toile", "bodice.svg", "bodice.dxf", "bodice.report.json", "residual.png", "residual.vtu", "worn.png"}},
    {"developed_yoke", {"yoke.toile", "yoke.svg", "residual.png", "worn.png"}},
    {"hat", {"gore.toile", "gore.svg", "residual.png"}},
    {"bra_cup", {"cup.toile", "cup.svg", "cup.dxf", "residual.png"}},
    {"stool_cover", {"cover.toile", "cover.svg", "cover.report.json", "residual.png"}},
    {"paper_box", {"paper_box.svg"}},
    {"football", {"football.svg", "football.json"}},
    {"quilted_bag", {"quilted_bag.svg"}},
    {"hooded_cape", {"hooded_cape.svg"}},
    {"t_shirt", {"t_shirt.svg"}},
    {"gilet", {"gilet.png", "gilet.svg", "gilet.glb"}},
};
/// Those have no pattern to drape until they are developed, or are there for the pattern alone.
const std::set<std::string> not_draped{"bra_cup",  "developed_bodice", "developed_yoke", "hat",     "stool_cover",
                                       "football", "quilted_bag",      "hooded_cape",    "t_shirt", "paper_box"};

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, RunsAndExpectsRightly) {
  const CommandLine call;
  const std::string script = fmt::format("{0}/examples/{1}/{1}.toile", TOILE_SOURCE_DIR, GetParam());
  const Called ran = call.toile(fmt::format("run '{}' --out out", script));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  for (const std::string& file : examples.at(GetParam())) {
    EXPECT_TRUE(std::filesystem::is_regular_file(call.scratch / ("out/" + file))) << file;
  }
}

TEST(Examples, AreAllTested) {
  std::vector<std::string> found, tested;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(TOILE_SOURCE_DIR) + "/examples")) {
    if (entry.is_directory()) found.push_back(entry.path().filename().string());
  }
  for (const auto& [name, files] : examples) tested.push_back(name);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(tested));
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, files] : examples) all.push_back(name);
  return all;
}

class DrapedExample : public Example {};

TEST_P(DrapedExample, RestsToAMillionthWhenAsked) {
  const CommandLine call;
  const std::string script = fmt::format("{0}/examples/{1}/{1}.toile", TOILE_SOURCE_DIR, GetParam());
  const Called ran = call.toile(fmt::format("drape '{}' --accuracy 1e-6 --triangles 800 -o cloth.glb", script));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

std::vector<std::string> draped_names() {
  std::vector<std::string> all = names();
  std::erase_if(all, [](const std::string& name) { return not_draped.count(name) > 0; });
  return all;
}

INSTANTIATE_TEST_SUITE_P(Of, DrapedExample, testing::ValuesIn(draped_names()),
                         [](const testing::TestParamInfo<std::string>& one) { return one.param; });
INSTANTIATE_TEST_SUITE_P(Of, Example, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& one) { return one.param; });

}  // namespace
}  // namespace toile
