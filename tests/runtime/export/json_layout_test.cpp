#include "runtime/export/json_layout.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace toile {
namespace {

std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

TEST(JsonLayout, ShortContentStaysOnOneLine) {
  EXPECT_EQ(laid_out(R"({"a":1,"b":[1,2]})"), "{\"a\": 1, \"b\": [1, 2]}\n");
  EXPECT_EQ(laid_out("[]"), "[]\n");
  EXPECT_EQ(laid_out("3"), "3\n");
}

TEST(JsonLayout, LongObjectsTakeALineAMember) {
  const std::string row = R"({"name":"a rather long name to fill the line","values":[1,2,3]})";
  EXPECT_EQ(laid_out("[" + row + "," + row + "]"),
            "[\n"
            "  {\"name\": \"a rather long name to fill the line\", \"values\": [1, 2, 3]},\n"
            "  {\"name\": \"a rather long name to fill the line\", \"values\": [1, 2, 3]}\n"
            "]\n");
}

TEST(JsonLayout, LongArraysOfNumbersAreFilled) {
  nlohmann::json numbers;
  for (int i = 0; i < 500; ++i) numbers.push_back(i * i);
  const std::string text = laid_out(numbers.dump());
  EXPECT_EQ(nlohmann::json::parse(text), numbers);
  EXPECT_LE(longest_line(text), 102U);
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 50);
}

TEST(JsonLayout, ContentIsUntouchedWhateverStringsHold) {
  nlohmann::json tricky;
  tricky["brackets, [{ and \"quotes\\"] = {"a,b:c]", "\\", "\\\"", ""};
  tricky["nested"] = {{{"x", {1.5e-300, -2, nullptr, true}}}, nlohmann::json::object(), nlohmann::json::array()};
  tricky["long"] = std::string(300, ',');
  EXPECT_EQ(nlohmann::json::parse(laid_out(tricky.dump())), tricky);
}

}  // namespace
}  // namespace toile
