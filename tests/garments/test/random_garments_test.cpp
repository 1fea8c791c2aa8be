// A few dozen garments that nobody has thought of, at few triangles; `./dev validate RandomGarments` tries a thousand.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/garments/random_garment.hpp"
#include "tests/garments/trial.hpp"

namespace toile::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int most_seconds = 900;  // under a sanitizer all takes ten times as long
#else
constexpr int most_seconds = 60;
#endif

class RandomGarments : public testing::TestWithParam<unsigned> {};

TEST_P(RandomGarments, EndInRestOrAClearReport) {
  const RandomGarment garment = random_garment(GetParam());
  const Trial trial = try_script(garment.text, std::max(150, garment.least_triangles), most_seconds);
  EXPECT_TRUE(trial.end == End::Rest || trial.end == End::Reported) << garment.kind << ": " << name(trial.end) << "\n"
                                                                    << trial.said << "\n"
                                                                    << garment.text;
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomGarments, testing::Range(1U, 25U));

}  // namespace
}  // namespace toile::test
