// Every example in docs/language.md is a script that loads: without errors, or with the one that a comment before it
// names (`<!-- E0201 -->`).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

struct Example {
  std::string text;
  std::string expected;  // an error's code, or empty
  int line = 0;          // in the document
};

std::vector<Example> examples_in(std::istream& document) {
  std::vector<Example> examples;
  std::string line;
  std::string expected;
  bool inside = false;
  for (int number = 1; std::getline(document, line); ++number) {
    if (!inside && line.starts_with("<!-- E")) expected = line.substr(5, 5);
    if (!inside && line == "```toile") {
      inside = true;
      examples.push_back({"", expected, number});
      expected.clear();
    } else if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      examples.back().text += line + "\n";
    }
  }
  return examples;
}

TEST(LanguageReference, EveryExampleRuns) {
  std::ifstream document(TOILE_SOURCE_DIR "/docs/language.md");
  ASSERT_TRUE(document);
  const std::vector<Example> examples = examples_in(document);
  EXPECT_GT(examples.size(), 15u);
  for (const Example& example : examples) {
    Script script(example.text, {}, {{"cuffs.toile", "let width = 7cm\n"}});
    SCOPED_TRACE("docs/language.md:" + std::to_string(example.line) + "\n" + script.rendered());
    if (example.expected.empty()) {
      EXPECT_TRUE(script.program->diagnostics().empty());
      Result result;
      for (const auto& [name, unit] : form_drape_schema()) result[name] = 0.5;
      for (const auto& [name, unit] : development_schema()) result[name] = 0.5;
      while (const auto command = script.program->next()) {
        if (std::holds_alternative<DrapeCommand>(*command)) script.program->give(result);
        if (std::holds_alternative<DevelopCommand>(*command)) script.program->give(result);
      }
      EXPECT_TRUE(script.program->ok());
    } else {
      ASSERT_EQ(script.program->diagnostics().size(), 1u);
      EXPECT_EQ(script.program->diagnostics().front().code, example.expected);
    }
  }
}

}  // namespace
}  // namespace toile::test
