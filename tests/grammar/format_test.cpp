// The formatter: what it makes of a text, that it says the same, and that once is enough.
#include "grammar/format/format.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "grammar/emit.hpp"
#include "tests/grammar/random_script.hpp"

namespace toile::syntax {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string formatted(const std::string& text) {
  const Source source("t.toile", text);
  return format(parse(source), source);
}

std::size_t longest_line(const std::string& text) {
  const Source source("t.toile", text);
  std::size_t longest = 0;
  for (int i = 1; i <= source.line_count(); ++i) longest = std::max(longest, source.line(i).size());
  return longest;
}

/// What must hold of every text without errors.
void expect_same_script(const std::string& text) {
  const Source before("t.toile", text);
  const Parsed parsed = parse(before);
  ASSERT_TRUE(parsed.errors.empty()) << text;
  const Source after("t.toile", format(parsed, before));
  const Parsed reparsed = parse(after);
  EXPECT_TRUE(reparsed.errors.empty()) << after.text();
  EXPECT_TRUE(same_script(parsed, before, reparsed, after)) << after.text();
  EXPECT_EQ(emit(parsed.tree, before), emit(reparsed.tree, after));
  EXPECT_EQ(format(reparsed, after), after.text()) << "not idempotent";
}

TEST(Format, EveryScriptOfTheTreeStaysTheSameScript) {
  int scripts = 0;
  for (const char* folder : {"stdlib", "examples", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(TOILE_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".toile") continue;
      const Source source(entry.path().string(), contents(entry.path()));
      if (!parse(source).errors.empty()) continue;
      SCOPED_TRACE(entry.path());
      expect_same_script(std::string(source.text()));
      ++scripts;
    }
  }
  EXPECT_GT(scripts, 30);
}

TEST(Format, EveryExampleAndModuleIsInTheLayout) {
  for (const char* folder : {"stdlib", "examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(TOILE_SOURCE_DIR) / folder)) {
      // The sections of the dress form read better as a table that is wider than the page.
      if (entry.path().extension() != ".toile" || entry.path().filename() == "bodies.toile") continue;
      const std::string text = contents(entry.path());
      EXPECT_EQ(formatted(text), text) << entry.path() << ": run toile fmt";
    }
  }
}

TEST(Format, BeforeAndAfter) {
  int pairs = 0;
  for (const auto& entry : fs::directory_iterator(TOILE_SOURCE_DIR "/tests/grammar/format")) {
    const std::string path = entry.path().string();
    const std::size_t ending = path.rfind(".before.toile");
    if (ending == std::string::npos) continue;
    const std::string after = contents(path.substr(0, ending) + ".after.toile");
    EXPECT_EQ(formatted(contents(path)), after) << path;
    EXPECT_EQ(formatted(after), after) << path;
    ++pairs;
  }
  EXPECT_GE(pairs, 4);
}

TEST(Format, EmptyTexts) {
  EXPECT_EQ(formatted(""), "");
  EXPECT_EQ(formatted(" \n\n\t\n"), "");
  EXPECT_EQ(formatted("\n\n// only a remark  "), "// only a remark\n");
  EXPECT_EQ(formatted("\xEF\xBB\xBFlet a=1\r\n"), "let a = 1\n");
}

TEST(Format, BlanksThatMeanSomething) {
  EXPECT_EQ(formatted("let a = 3cm ^ 2\nlet b = 3cm^2\n"), "let a = 3cm ^ 2\nlet b = 3 cm^2\n");
  EXPECT_EQ(formatted("let a = b^2 + c ^ 2 ^ d\n"), "let a = b^2 + c ^ 2^d\n");
  EXPECT_EQ(formatted("let v = 60cm / s\n"), "let v = 60cm / s\n");
  EXPECT_EQ(formatted("let v = 60cm/w\n"), "let v = 60cm / w\n");
  EXPECT_EQ(formatted("let v = - a - - b\n"), "let v = -a - -b\n");
  EXPECT_EQ(formatted("fabric f {\n  render\"x\"\n}\n"), "fabric f {\n  render\"x\"\n}\n") << "left as it is";
}

TEST(Format, NoLineIsTooLongThatCanBeBroken) {
  std::string text = "let sum = first_name_of_many + ";
  for (int i = 0; i < 40; ++i) text += "f(a: 12.5cm, b: [1, 2, 3]) * " + std::to_string(i) + "cm + ";
  const std::string broken = formatted(text + "last\n");
  EXPECT_LE(longest_line(broken), 100u) << broken;
}

TEST(Format, ALineThatLooksLikeAStatementIsNotBegun) {
  // At the beginning of a line `label held` would be taken for a statement of its own.
  const std::string line =
      "  wear front.waist at if a_long_name_of_a_condition_to_fill_the_line then another_name_of_a_value else label "
      "held\n";
  const std::string text = "garment g {\n" + line + "}\n";
  expect_same_script(text);
  EXPECT_NE(formatted(text), "");
}

RC_GTEST_PROP(Format, RandomScriptsStayTheSameScript, (unsigned words, unsigned layout)) {
  const std::string text = RandomScript(words, layout, true).make();
  const Source before("t.toile", text);
  const Parsed parsed = parse(before);
  if (!parsed.errors.empty()) RC_DISCARD("no script");
  const Source after("t.toile", format(parsed, before));
  const Parsed reparsed = parse(after);
  RC_ASSERT(reparsed.errors.empty());
  RC_ASSERT(same_script(parsed, before, reparsed, after));
  RC_ASSERT(format(reparsed, after) == after.text());
}

RC_GTEST_PROP(Format, LayoutDependsOnTheWordsAlone, (unsigned words, unsigned layout, unsigned other)) {
  const std::string one = RandomScript(words, layout, false).make();
  const std::string two = RandomScript(words, other, false).make();
  const Source first("t.toile", one), second("t.toile", two);
  const Parsed first_parsed = parse(first), second_parsed = parse(second);
  if (!first_parsed.errors.empty() || !second_parsed.errors.empty()) RC_DISCARD("no script");
  RC_ASSERT(format(first_parsed, first) == format(second_parsed, second));
}

TEST(Format, RandomScriptsAreMostlyScripts) {
  int good = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Source source("t.toile", RandomScript(seed, seed, true).make());
    good += parse(source).errors.empty();
  }
  EXPECT_GT(good, 150);
}

}  // namespace
}  // namespace toile::syntax
