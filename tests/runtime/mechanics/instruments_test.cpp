// A cloth measured on FAST and the cantilever is the cloth that the KES measures.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "runtime/fabric/law.hpp"

namespace toile {
namespace {

RC_GTEST_PROP(Instruments, TwoElongationsOfFastSayTheCurveOfTheKes, ()) {
  // F = Fm (exp(z e/em) - 1)/(exp(z) - 1), read at 20 and at 100 of its 500 gf/cm.
  const double emt = *rc::gen::inRange(10, 600) / 1000.0;
  const double z = *rc::gen::inRange(1, 100) / 10.0;
  const auto read = [&](double share) {
    const double e = emt / z * std::log1p(share * std::expm1(z));
    return WarpWeft{e, e};
  };
  FabricSheet chart;
  chart.e20 = read(20 / 500.0);
  chart.e100 = read(100 / 500.0);
  const FabricSheet kes = in_kes_rows(chart);
  RC_ASSERT(std::abs(kes.emt->warp / emt - 1) < 1e-9);
  RC_ASSERT(std::abs(kes.lt->weft - (2 / z - 2 / std::expm1(z))) < 1e-9);
}

TEST(Instruments, FiveTimesTheElongationAtFiveTimesTheForceIsAStraightLine) {
  FabricSheet chart;
  chart.e20 = WarpWeft{0.01, 0.002};
  chart.e100 = WarpWeft{0.05, 0.01};
  const FabricSheet kes = in_kes_rows(chart);
  EXPECT_NEAR(kes.lt->warp, 1, 1e-5);
  EXPECT_NEAR(kes.emt->warp, 0.25, 1e-5);
  EXPECT_NEAR(kes.emt->weft, 0.05, 1e-6);
}

TEST(Instruments, ACantileversLengthIsARigidityWithoutFriction) {
  FabricSheet chart;
  chart.weight = 0.2;
  chart.c = WarpWeft{0.02, 0.015};
  const FabricLaw law = make_law(chart);
  // De Boos and Tester: B [uN m] = W [g/m2] C^3 [mm] 9.81e-6.
  EXPECT_NEAR(law.bend_warp.rigidity, 200 * 8000 * 9.80665e-6 * 1e-6, 1e-12);
  EXPECT_NEAR(law.bend_weft.rigidity, 200 * 3375 * 9.80665e-6 * 1e-6, 1e-12);
  EXPECT_EQ(law.bend_warp.friction, 0);
  EXPECT_DOUBLE_EQ(law.twist, 0.5 * std::sqrt(law.bend_warp.rigidity * law.bend_weft.rigidity));
}

TEST(Instruments, AStripOnTheBiasSaysTheTwist) {
  FabricSheet sheet;
  sheet.weight = 0.2;
  sheet.b = WarpWeft{8e-6, 8e-6};
  sheet.b45 = 8e-6;  // alike in all directions, and free to curve across: the twist is half of B
  EXPECT_NEAR(make_law(sheet).twist, 4e-6, 1e-15);
  sheet.b = WarpWeft{9e-6, 4e-6};
  sheet.b45 = 4e-6;
  EXPECT_NEAR(1 / make_law(sheet).twist, 4 / 4e-6 - 1 / 9e-6 - 1 / 4e-6, 1);
  sheet.twist = 1e-6;
  EXPECT_EQ(make_law(sheet).twist, 1e-6);
}

TEST(Instruments, WhatPliesResistAddsUp) {
  FabricSheet sheet;
  sheet.weight = 0.2;
  sheet.t0 = 0.001;
  sheet.b = WarpWeft{9e-6, 4e-6};
  sheet.hb = WarpWeft{2e-4, 1e-4};
  sheet.hg = WarpWeft{1, 1};
  const FabricLaw one = make_law(sheet);
  sheet.plies = 3;
  const FabricLaw three = make_law(sheet);
  EXPECT_DOUBLE_EQ(three.weight, 0.6);
  EXPECT_DOUBLE_EQ(three.thickness, 0.003);
  EXPECT_DOUBLE_EQ(three.twist, 3 * one.twist);
  for (const double x : {-0.02, 0.003, 0.04, 0.2}) {
    EXPECT_NEAR(three.warp(x).force, 3 * one.warp(x).force, 1e-9 * std::abs(one.warp(x).force));
    EXPECT_NEAR(three.shear(x).energy, 3 * one.shear(x).energy, 1e-9 * one.shear(x).energy);
    EXPECT_NEAR(three.bend_weft(100 * x).force, 3 * one.bend_weft(100 * x).force, 1e-12);
  }
}

TEST(Instruments, ElongationOnTheBiasIsShear) {
  FabricSheet chart;
  chart.weight = 0.2;
  chart.b = WarpWeft{8e-6, 8e-6};
  chart.eb5 = 0.03;
  EXPECT_NEAR(in_kes_rows(chart).g->warp, 122.6 / 3, 0.01);  // 123 / EB5 in De Boos and Tester
}

}  // namespace
}  // namespace toile
