// The validation suite at sizes for every day; `./dev validate` runs all of it and writes docs/validation.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/validation/suite/figures.hpp"

namespace toile::validation {
namespace {

/// docs/validation.md as it stands.
const std::string& page() {
  static const std::string text = [] {
    std::ifstream in(TOILE_SOURCE_DIR "/docs/validation.md");
    return std::string{std::istreambuf_iterator<char>(in), {}};
  }();
  return text;
}

class Suite : public testing::TestWithParam<Case> {};

TEST_P(Suite, Holds) {
  const Chapter chapter = GetParam().run(Effort::Quick);
  EXPECT_THAT(page(), testing::HasSubstr("\n## " + chapter.title + "\n")) << "./dev validate writes the page anew";
  for (const Figure& figure : chapter.figures) {
    EXPECT_TRUE(figure.holds()) << figure.subject << ", " << figure.quantity << ": " << figure.found << " instead of "
                                << figure.reference << ", held to " << figure.held_to;
  }
}

INSTANTIATE_TEST_SUITE_P(Validation, Suite, testing::ValuesIn(cases()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace toile::validation
