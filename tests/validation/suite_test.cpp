// The validation suite at sizes for every day; `./dev validate` runs all of it and writes docs/validation.md.
#include <gtest/gtest.h>

#include "tests/validation/suite/figures.hpp"

namespace toile::validation {
namespace {

class Suite : public testing::TestWithParam<Case> {};

TEST_P(Suite, Holds) {
  for (const Figure& figure : GetParam().run(Effort::Quick).figures) {
    EXPECT_TRUE(figure.holds()) << figure.subject << ", " << figure.quantity << ": " << figure.found << " instead of "
                                << figure.reference << ", held to " << figure.held_to;
  }
}

INSTANTIATE_TEST_SUITE_P(Validation, Suite, testing::ValuesIn(cases()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace toile::validation
