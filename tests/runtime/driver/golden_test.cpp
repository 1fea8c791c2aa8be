#include "runtime/driver/golden.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Printed final : Listener {
  std::vector<std::string> lines;
  void diagnosed(const Diagnostic&, const Sources&) override {}
  void printed(const std::string& line) override { lines.push_back(line); }
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string& message, const std::string&) override { lines.push_back(message); }
};

const char* const printing = "//! run\n//! set n=3\nparam n = 1\nprint n\n";

class GoldenTest : public testing::Test {
 protected:
  int test(bool update) {
    heard.lines.clear();
    return test_scripts(scratch.path(), update, heard, {}).exit_code();
  }
  Scratch scratch{"golden"};
  Printed heard;
};

TEST_F(GoldenTest, AcceptsWithUpdateAndHoldsToItFromThenOn) {
  scratch.write("a.toile", printing);
  EXPECT_EQ(test(false), 1) << "a script without golden files is no passed test";
  EXPECT_EQ(test(true), 0);
  EXPECT_EQ(scratch.read("a.out"), "3\n");
  EXPECT_EQ(test(false), 0);
  EXPECT_THAT(heard.lines, ElementsAre("1 passed, 0 failed"));
}

TEST_F(GoldenTest, ShowsWhatDiffers) {
  scratch.write("b/a.toile", printing);
  scratch.write("b/a.out", "2\n");
  EXPECT_EQ(test(false), 1);
  EXPECT_THAT(heard.lines, ElementsAre(HasSubstr("-2\n+3\n"), "0 passed, 1 failed"));
}

TEST_F(GoldenTest, KnowsItsDirectives) {
  scratch.write("a.toile", "//! emit everything\n");
  EXPECT_EQ(test(true), 1);
  EXPECT_THAT(heard.lines, ElementsAre(HasSubstr("not understood"), "0 passed, 1 failed"));
}

TEST_F(GoldenTest, SaysWhenThereIsNoSuchFolder) {
  EXPECT_EQ(test_scripts(scratch / "nowhere", false, heard, {}).exit_code(), 4);
}

}  // namespace
}  // namespace toile
