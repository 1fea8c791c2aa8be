// Every diagnostic has a page; the wrong script on it has that mistake and no other, the mended one has none.
#include "runtime/driver/explain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "compiler/diag/codes.hpp"
#include "compiler/diag/pages.hpp"
#include "grammar/format/format.hpp"
#include "runtime/driver/run.hpp"
#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Codes final : public Listener {
 public:
  void diagnosed(const Diagnostic& diagnostic, const Sources& sources) override {
    codes.push_back(diagnostic.code);
    text += render(diagnostic, sources, false);
  }
  void printed(const std::string& line) override { text += line + "\n"; }
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string& message, const std::string& help) override { text += message + "\n" + help + "\n"; }

  std::vector<std::string> codes;
  std::string text;
};

/// The scripts of a page, in their order.
std::vector<std::string> examples_of(std::string_view page) {
  std::vector<std::string> scripts;
  constexpr std::string_view opening = "```toile\n";
  for (std::size_t at = page.find(opening); at != std::string_view::npos; at = page.find(opening, at)) {
    at += opening.size();
    const std::size_t end = page.find("```", at);
    scripts.emplace_back(page.substr(at, end - at));
    at = end;
  }
  return scripts;
}

/// The codes that a script comes to, called as its `//!` lines say.
Codes codes_of(const std::string& script) {
  const Scratch scratch("explain");
  WorkroomOptions options;
  options.triangles = 60;
  options.out = scratch.path();
  bool run = false;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line) && line.starts_with("//! ");) {
    std::istringstream words(line.substr(4));
    std::string word, name, rest;
    words >> word;
    run |= word == "run";
    std::getline(words >> std::ws, name, word == "file" ? ':' : '=');
    std::getline(words >> std::ws, rest);
    if (word == "size") options.size = name;
    if (word == "set") options.settings.push_back({name, rest});
    if (word == "file") scratch.write(name, rest + "\n");
  }
  Codes codes;
  Workroom workroom(options, codes, {});
  if (!workroom.load("example.toile", script, scratch.path())) return codes;
  if (run) {
    run_commands(workroom);
  } else {
    check_meshes(workroom);
  }
  return codes;
}

/// The words of a page's first paragraph and title, one blank between them.
std::string beginning_of(std::string_view page) {
  std::istringstream words{std::string(page.substr(0, page.find("\n## ")))};
  std::string joined;
  for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

TEST(Pages, ThereIsOneForEachCode) {
  std::map<std::string_view, std::string_view> pages;
  for (const ErrorPage& page : error_pages()) {
    EXPECT_NE(find_code(page.code), nullptr) << page.code;
    pages[page.code] = page.text;
  }
  for (const CodeEntry& entry : code_registry()) {
    ASSERT_TRUE(pages.count(entry.code)) << "docs/errors/" << entry.code << ".md is missing";
    EXPECT_EQ(beginning_of(pages[entry.code]),
              "# " + std::string(entry.code) + ": " + std::string(entry.title) + " " + std::string(entry.explanation))
        << "not what compiler/diag/codes.def says";
  }
}

TEST(Pages, AreAllInTheIndex) {
  std::ifstream file(TOILE_SOURCE_DIR "/docs/errors/README.md");
  std::ostringstream index;
  index << file.rdbuf();
  for (const CodeEntry& entry : code_registry()) {
    EXPECT_THAT(index.str(), HasSubstr("| [" + std::string(entry.code) + "](" + std::string(entry.code) + ".md) | " +
                                       std::string(entry.title) + " |\n"));
  }
}

TEST(Pages, TheWrongScriptHasThatMistakeAndTheMendedOneNone) {
  for (const ErrorPage& page : error_pages()) {
    SCOPED_TRACE(page.code);
    const std::vector<std::string> scripts = examples_of(page.text);
    ASSERT_EQ(scripts.size(), 2u);
    const Codes wrong = codes_of(scripts[0]), mended = codes_of(scripts[1]);
    EXPECT_THAT(wrong.codes, ElementsAre(page.code)) << wrong.text;
    EXPECT_THAT(mended.codes, IsEmpty()) << mended.text;
  }
}

TEST(Pages, ScriptsAreInTheLayout) {
  for (const ErrorPage& page : error_pages()) {
    for (const std::string& script : examples_of(page.text)) {
      const Source source("example.toile", script);
      const syntax::Parsed parsed = syntax::parse(source);
      if (!parsed.errors.empty()) continue;
      EXPECT_EQ(syntax::format(parsed, source), script) << page.code;
    }
  }
}

TEST(Explain, TellsThePageInAnyCase) {
  for (const char* code : {"E0316", "e0316"}) {
    Codes told;
    EXPECT_EQ(explain(code, told).exit_code(), 0);
    EXPECT_THAT(told.text, StartsWith("# E0316: seam lengths that differ\n"));
  }
}

TEST(Explain, SuggestsTheNearestCode) {
  Codes told;
  EXPECT_EQ(explain("E3016", told).exit_code(), 2);
  EXPECT_THAT(told.text, HasSubstr("did you mean `E0316`?"));
}

TEST(Explain, AloneListsAllCodes) {
  Codes told;
  EXPECT_EQ(explain("", told).exit_code(), 0);
  EXPECT_THAT(told.text, StartsWith("E0001  text that was not understood\n"));
  EXPECT_EQ(std::count(told.text.begin(), told.text.end(), '\n'), static_cast<long>(code_registry().size()));
}

}  // namespace
}  // namespace toile
