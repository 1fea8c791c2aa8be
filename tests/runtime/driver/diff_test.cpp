#include "runtime/driver/diff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace toile {
namespace {

using testing::HasSubstr;

TEST(LineDiff, IsEmptyForEqualTexts) {
  EXPECT_EQ(line_diff("", ""), "");
  EXPECT_EQ(line_diff("a\nb\n", "a\nb\n"), "");
}

TEST(LineDiff, ShowsAChangedLineWithItsNeighbours) {
  EXPECT_EQ(line_diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n"),
            "@@ 2 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST(LineDiff, ShowsWhatOneSideLacks) {
  EXPECT_EQ(line_diff("a\nb\nc\n", "a\nc\n"), "@@ 1 @@\n a\n-b\n c\n");
  EXPECT_EQ(line_diff("a\n", "a\nb\n"), "@@ 1 @@\n a\n+b\n");
  EXPECT_EQ(line_diff("", "a\n"), "@@ 1 @@\n+a\n");
}

TEST(LineDiff, KeepsDistantChangesApart) {
  std::string expected, found;
  for (int i = 1; i <= 30; ++i) {
    expected += std::to_string(i) + "\n";
    found += (i == 5 || i == 25 ? "x" : std::to_string(i)) + "\n";
  }
  EXPECT_EQ(line_diff(expected, found),
            "@@ 2 @@\n 2\n 3\n 4\n-5\n+x\n 6\n 7\n 8\n@@ 22 @@\n 22\n 23\n 24\n-25\n+x\n 26\n 27\n 28\n");
}

TEST(LineDiff, SaysWhenOnlyTheLastLineEndDiffers) {
  EXPECT_THAT(line_diff("a\n", "a"), HasSubstr("ends of the last lines"));
}

TEST(LineDiff, StaysShortForHugeDifferences) {
  std::string expected, found;
  for (int i = 0; i < 20000; ++i) {
    expected += "e" + std::to_string(i) + "\n";
    found += "f" + std::to_string(i) + "\n";
  }
  EXPECT_LT(line_diff(expected, found).size(), 2000u);
}

}  // namespace
}  // namespace toile
