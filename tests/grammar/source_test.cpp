#include "grammar/source.hpp"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Source, CountsLinesAndCodePointsFromOne) {
  const Source source("t", "ab\nçé=x\r\n\nlast");
  EXPECT_EQ(source.line_count(), 4);
  const auto at = [&](std::uint32_t offset) {
    return std::pair(source.position(offset).line, source.position(offset).column);
  };
  EXPECT_EQ(at(0), std::pair(1, 1));
  EXPECT_EQ(at(2), std::pair(1, 3));
  EXPECT_EQ(at(3), std::pair(2, 1));
  EXPECT_EQ(at(7), std::pair(2, 3));
  EXPECT_EQ(at(16), std::pair(4, 5));
  EXPECT_EQ(at(1000), std::pair(4, 5));
}

TEST(Source, GivesLinesWithoutTheirEnds) {
  const Source source("t", "ab\ncd\r\n");
  EXPECT_EQ(source.line(1), "ab");
  EXPECT_EQ(source.line(2), "cd");
  EXPECT_EQ(source.line(3), "");
  EXPECT_EQ(source.line(0), "");
  EXPECT_EQ(source.line(9), "");
}

TEST(Source, EmptyTextHasOneLine) {
  const Source source("t", "");
  EXPECT_EQ(source.line_count(), 1);
  EXPECT_EQ(source.position(0).line, 1);
  EXPECT_EQ(source.line(1), "");
}

}  // namespace
}  // namespace toile
