#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "grammar/emit.hpp"
#include "tests/grammar/invariants.hpp"

namespace toile::syntax {
namespace {

std::string first_script() {
  std::ifstream file(TOILE_SOURCE_DIR "/tests/grammar/first_script.toile", std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void expect_sound(const std::string& text) {
  const Source source("t.toile", text);
  for (const auto& parsed : {parse(source), parse_expression(source)}) {
    ASSERT_EQ(broken_invariant(parsed, source), "") << text;
    EXPECT_NO_FATAL_FAILURE(emit(parsed.tree, source));
  }
}

TEST(Lossless, OddTexts) {
  using namespace std::string_literals;
  for (const std::string& text : {""s,
                                  "\n"s,
                                  "\r\n"s,
                                  "\r"s,
                                  " "s,
                                  "// a comment"s,
                                  "/// doc"s,
                                  "let x = 1"s,
                                  "let x = 1\r\nlet y = 2\r\n"s,
                                  "\xEF\xBB\xBFlet x = 1"s,
                                  "\xEF\xBB\xBF"s,
                                  "\0"s,
                                  "let \0 = \0\n\0"s,
                                  "\xff\xfe"s,
                                  "// \x80\nlet \xC3\xA9 = 1"s,
                                  "\""s,
                                  R"("\)"s,
                                  "#"s,
                                  "}"s,
                                  "}}}{{{"s,
                                  "(]"s,
                                  "let"s,
                                  "let x"s,
                                  "let x ="s,
                                  "1 +"s,
                                  "a.b.c[1](2)"s,
                                  "(1, 2"s,
                                  "garment g {"s,
                                  "garment g { piece p { outline {"s,
                                  "/"s,
                                  "//"s,
                                  "..."s,
                                  "let x = 1 // é\n"s,
                                  "\t\t\n\t"s}) {
    expect_sound(text);
  }
}

TEST(Lossless, EveryBeginningOfTheFirstScript) {
  const std::string script = first_script();
  ASSERT_GT(script.size(), 1000u);
  for (std::size_t length = 0; length <= script.size(); ++length) expect_sound(script.substr(0, length));
}

TEST(Lossless, MutatedScripts) {
  const std::string script = first_script();
  const std::string bytes = "(){}[],.:=+-*/^<>\"\\#%0a \n\r\t\x01\x80\xff";
  std::mt19937 random(1992);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int round = 0; round < 3000; ++round) {
    std::string text = script;
    for (std::size_t edits = 1 + below(6); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text.erase(at, 1 + below(40));
          break;
        case 1:
          text.insert(at, 1, bytes[below(bytes.size())]);
          break;
        case 2:
          text[at] = bytes[below(bytes.size())];
          break;
        default:
          text.insert(at, script.substr(below(script.size()), below(60)));
          break;
      }
    }
    expect_sound(text);
  }
}

TEST(Lossless, TokensSpellTheText) {
  const std::string script = first_script();
  const Source source("t.toile", script);
  const Parsed parsed = parse(source);
  std::string spelt;
  for (NodeId id = 0; id < parsed.tree.size(); ++id) {
    if (is_token(parsed.tree[id].kind)) spelt += source.slice(parsed.tree[id].span);
  }
  EXPECT_EQ(spelt, script);
}

TEST(Emit, ShowsKindsAndTextsWithoutTrivia) {
  const Source source("t.toile", "/// doc\nlet w = 2 cm * a // why\nlet \x01\n");
  EXPECT_EQ(emit(parse(source).tree, source),
            "File\n"
            "  Let\n"
            "    'let'\n"
            "    Name w\n"
            "    '='\n"
            "    Binary\n"
            "      Number\n"
            "        Digits 2\n"
            "        Unit cm\n"
            "      '*'\n"
            "      NameRef\n"
            "        Name a\n"
            "  Let\n"
            "    'let'\n"
            "    Error \\x01\n");
}

}  // namespace
}  // namespace toile::syntax
