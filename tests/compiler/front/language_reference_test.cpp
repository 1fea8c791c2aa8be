// Every example in the documents of reference is a script that loads: without errors, or with the one that a comment
// before it names (`<!-- E0201 -->`).
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

void expect_to_run(const std::string& document, std::size_t least) {
  std::ifstream text(TOILE_SOURCE_DIR "/docs/" + document);
  ASSERT_TRUE(text);
  const std::vector<Example> examples = examples_in(text);
  EXPECT_GE(examples.size(), least);
  for (const Example& example : examples) {
    Script script(example.text, {}, {{"cuffs.toile", "let width = 7cm\n"}});
    SCOPED_TRACE("docs/" + document + ":" + std::to_string(example.line) + "\n" + script.rendered());
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

TEST(LanguageReference, EveryExampleRuns) {
  expect_to_run("language.md", 60);
}

TEST(LanguageReference, EveryExampleOfTheTourRuns) {
  expect_to_run("tour.md", 15);
}

TEST(LanguageReference, EveryExampleOfABodyRuns) {
  expect_to_run("bodies.md", 3);
}

TEST(LanguageReference, EveryExampleOfTheComparisonRuns) {
  expect_to_run("comparison.md", 2);
}

}  // namespace
}  // namespace toile::test
