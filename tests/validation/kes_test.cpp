// The virtual KES laboratory reads back the sheet that went in, on meshed specimens.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/laboratory/kes.hpp"

namespace toile {
namespace {

/// The class values of a worsted serge.
FabricSheet serge() {
  FabricSheet sheet;
  sheet.lt = WarpWeft{0.60, 0.60};
  sheet.emt = WarpWeft{0.04, 0.06};
  sheet.g = WarpWeft{0.6 * 56.188, 0.6 * 56.188};
  sheet.hg = WarpWeft{0.7 * 0.980665, 0.7 * 0.980665};
  sheet.hg5 = WarpWeft{1.5 * 0.980665, 1.5 * 0.980665};
  sheet.b = WarpWeft{0.070 * 9.80665e-5, 0.060 * 9.80665e-5};
  sheet.hb = WarpWeft{0.025 * 9.80665e-3, 0.022 * 9.80665e-3};
  sheet.weight = 0.192;
  return sheet;
}

TEST(KesLaboratory, ReadsBackTheSheetThatWentIn) {
  const FabricSheet in = serge();
  const KesReading reading = kes_reading(in, {});
  ASSERT_EQ(reading.trouble, "");
  const auto expect_row = [](const char* row, const std::optional<WarpWeft>& found,
                             const std::optional<WarpWeft>& was) {
    EXPECT_NEAR(found->warp, was->warp, 0.005 * was->warp) << row << " of the warp";
    EXPECT_NEAR(found->weft, was->weft, 0.005 * was->weft) << row << " of the weft";
  };
  expect_row("EMT", reading.sheet.emt, in.emt);
  expect_row("LT", reading.sheet.lt, in.lt);
  expect_row("G", reading.sheet.g, in.g);
  expect_row("2HG", reading.sheet.hg, in.hg);
  expect_row("2HG5", reading.sheet.hg5, in.hg5);
  expect_row("B", reading.sheet.b, in.b);
  expect_row("2HB", reading.sheet.hb, in.hb);
}

}  // namespace
}  // namespace toile
