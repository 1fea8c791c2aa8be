// Diagnostics as people read them: golden renderings.
#include <gtest/gtest.h>

#include "compiler/diag/codes.hpp"
#include "tests/compiler/front/front.hpp"

namespace toile {
namespace {

Location find(const Sources& sources, FileId file, const std::string& text) {
  const auto begin = static_cast<std::uint32_t>(sources[file].text().find(text));
  return {file, {begin, begin + static_cast<std::uint32_t>(text.size())}};
}

TEST(Rendering, ManyLabelsOverLinesAndFiles) {
  Sources sources;
  const FileId skirt = sources.add(
      Source("skirt.toile", "let \u00e4rmel = 3cm\n\nsew front.side to back.left\n\n\n\n\n\n\tlet x = 1\n"));
  const FileId parts = sources.add(Source("parts.toile", "edge = line\n"));
  const Diagnostic diagnostic{Severity::Error,
                              "E0316",
                              "seam lengths differ by 2 cm",
                              {{find(sources, skirt, "front.side"), "60 cm long", true},
                               {find(sources, skirt, "back.left"), "58 cm long", true},
                               {find(sources, skirt, "3cm"), "", false},
                               {find(sources, skirt, "x"), "behind a tab", false},
                               {find(sources, parts, "line"), "drawn here", false}},
                              "write `ease 2cm`"};
  EXPECT_EQ(render(diagnostic, sources, false),
            "skirt.toile:3:5: error[E0316]: seam lengths differ by 2 cm\n"
            "  |\n"
            "1 | let \u00e4rmel = 3cm\n"
            "  |             ---\n"
            "...\n"
            "3 | sew front.side to back.left\n"
            "  |     ^^^^^^^^^^    ^^^^^^^^^ 58 cm long\n"
            "  |     |\n"
            "  |     60 cm long\n"
            "...\n"
            "9 |     let x = 1\n"
            "  |         - behind a tab\n"
            " --> parts.toile:1\n"
            "1 | edge = line\n"
            "  |        ---- drawn here\n"
            "help: write `ease 2cm`\n");
}

TEST(Rendering, SpansAtTheEndAndOverSeveralLines) {
  Sources sources;
  const FileId file = sources.add(Source("a.toile", "let a = {\n  b\n}"));
  const Diagnostic diagnostic{
      Severity::Warning, "W0405", "odd", {{{file, {8, 15}}, "all this", true}, {{file, {15, 15}}, "end", false}}, ""};
  EXPECT_EQ(render(diagnostic, sources, false),
            "a.toile:1:9: warning[W0405]: odd\n"
            "  |\n"
            "1 | let a = {\n"
            "  |         ^ all this\n"
            "...\n"
            "3 | }\n"
            "  |  - end\n");
}

TEST(Rendering, ColourOnlyAddsEscapes) {
  Sources sources;
  const FileId file = sources.add(Source("a.toile", "let a = b\n"));
  const Diagnostic diagnostic{Severity::Error, "E0101", "unknown", {{{file, {8, 9}}, "here", true}}, "help"};
  std::string coloured = render(diagnostic, sources, true);
  EXPECT_NE(coloured.find("\x1b[1;31m"), std::string::npos);
  for (std::size_t at; (at = coloured.find('\x1b')) != std::string::npos;) {
    coloured.erase(at, coloured.find('m', at) - at + 1);
  }
  EXPECT_EQ(coloured, render(diagnostic, sources, false));
}

TEST(Codes, AreSortedUniqueAndExplained) {
  std::string before;
  for (const CodeEntry& entry : code_registry()) {
    EXPECT_LT(before, std::string(entry.code.substr(1)));
    EXPECT_FALSE(entry.title.empty());
    EXPECT_GT(entry.explanation.size(), 20u) << entry.code;
    before = entry.code.substr(1);
  }
  EXPECT_NE(find_code("E0201"), nullptr);
  EXPECT_EQ(find_code("E9999"), nullptr);
}

}  // namespace
}  // namespace toile
