// One script in all its sizes.
#include "runtime/driver/sizes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/driver/run.hpp"
#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

using testing::ElementsAre;

class Files final : public Listener {
 public:
  void diagnosed(const Diagnostic& diagnostic, const Sources&) override { codes.push_back(diagnostic.code); }
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string& path) override { names.push_back(std::filesystem::path(path).filename().string()); }
  void failed(const std::string&, const std::string&) override {}

  std::vector<std::string> codes, names;
};

Files made_in_sizes(const std::string& script, const std::string& size) {
  const Scratch scratch("sizes");
  scratch.write("g.toile", script);
  WorkroomOptions options;
  options.size = size;
  Files files;
  for (const WorkroomOptions& each : one_by_size(scratch / "g.toile", options)) {
    Workroom workroom(each, files, {});
    if (workroom.load(scratch / "g.toile")) run_commands(workroom);
  }
  return files;
}

const char* const flag = R"(
sizes flags(width) {
  S  20cm
  XL 80cm
}
garment flag {
  piece cloth {
    outline from (0cm, 0cm) {
      foot = line to (flags.width, 0cm)
      fly  = line to (0cm, 10cm)
      head = line to start
    }
  }
}
export flag to "flat/flag.svg"
)";

TEST(Sizes, AllOfThemAreMadeWithTheSizeInTheNamesOfFiles) {
  EXPECT_THAT(made_in_sizes(flag, "all").names, ElementsAre("flag-S.svg", "flag-XL.svg"));
  EXPECT_THAT(made_in_sizes(flag, "XL").names, ElementsAre("flag.svg"));
  EXPECT_THAT(made_in_sizes(flag, "").names, ElementsAre("flag.svg"));
}

TEST(Sizes, WithoutATableThereIsNoSizeAtAll) {
  EXPECT_THAT(made_in_sizes("let a = 1\n", "all").codes, ElementsAre("E0118"));
}

TEST(Sizes, AFaultyScriptIsToldOnce) {
  EXPECT_THAT(made_in_sizes(std::string(flag) + "let a = b\n", "all").codes, ElementsAre("E0101"));
}

TEST(Sizes, NamesForASize) {
  EXPECT_EQ(name_for_size("out/skirt.svg", "M"), "out/skirt-M.svg");
  EXPECT_EQ(name_for_size("skirt.report.json", "M"), "skirt-M.report.json");
  EXPECT_EQ(name_for_size("v1.2/skirt", "38"), "v1.2/skirt-38");
}

}  // namespace
}  // namespace toile
