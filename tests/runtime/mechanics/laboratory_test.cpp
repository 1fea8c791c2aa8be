// Friction that remembers, and jaws: what the laboratory adds to the mechanics of a drape.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/laboratory/rig.hpp"

namespace toile {
namespace {

FabricSheet serge() {
  FabricSheet sheet;
  sheet.g = WarpWeft{33.7, 33.7};
  sheet.hg = WarpWeft{0.69, 0.69};
  sheet.hg5 = WarpWeft{1.47, 1.47};
  sheet.b = WarpWeft{6.9e-6, 5.9e-6};
  sheet.hb = WarpWeft{2.45e-4, 2.16e-4};
  sheet.weight = 0.192;
  return sheet;
}

TEST(Slip, ForceAndStiffnessAreDerivativesOfTheEnergy) {
  const ShearLaw law = make_law(serge()).shear;
  for (const double anchor : {-0.05, 0.0, 0.02}) {
    for (const double angle : {-0.2, -0.0525, -0.003, 0.001, 0.018, 0.03, 0.12, 0.145}) {
      const double h = 1e-6;
      const Density at = law(angle, anchor);
      const Density after = law(angle + h, anchor), before = law(angle - h, anchor);
      EXPECT_NEAR(at.force, (after.energy - before.energy) / (2 * h), 1e-6) << anchor << " " << angle;
      EXPECT_NEAR(at.stiffness, (after.force - before.force) / (2 * h), 1e-3) << anchor << " " << angle;
    }
  }
}

TEST(Slip, PullsTheOtherWayOnceItHasSlippedBack) {
  const Slip slip{1, 2, 0, 0};
  const double there = anchor_after(slip, 0, 5);
  EXPECT_DOUBLE_EQ(there, 4);
  EXPECT_DOUBLE_EQ(slip_density(slip, there, 5).force, 2);
  EXPECT_DOUBLE_EQ(slip_density(slip, there, 4).force, 0);
  EXPECT_DOUBLE_EQ(slip_density(slip, there, 2).force, -2);
  EXPECT_DOUBLE_EQ(anchor_after(slip, there, 4.5), 4) << "what has not slipped leaves no trace";
}

struct Bent {
  Specimen specimen = toile::rectangle(0.01, 0.01, {8, 8, 0.2});
  FabricLaw law = make_law(serge());
  Rig rig{specimen, law, [](Vec2 p) { return std::array<bool, 3>{p.x == 0, p.x == 0, p.x == 0}; }, Loops::Remembered};
  std::vector<int> near_jaw = rig.clamp([](Vec2 p) { return p.x == 0; }, {-1, 0, 0});
};

TEST(Jaws, GradientAndHessianAreDerivativesOfTheEnergy) {
  Bent bent;
  for (int v = 0; v < bent.specimen.cloth.vertex_count; ++v) {
    bent.rig.put(v, bent.rig.at(v) + 2e-4 * Vector3(std::sin(v), std::cos(3 * v), std::sin(7 * v)));
  }
  Vector& q = bent.rig.q;
  for (Eigen::Index i = 3 * bent.specimen.cloth.vertex_count; i < q.size(); ++i) q[i] = 0.05 * std::sin(double(i));
  Vector gradient = Vector::Zero(q.size());
  bent.rig.jaws.energy(q, &gradient);
  const double scale = gradient.lpNorm<Eigen::Infinity>();
  ASSERT_GT(scale, 0);
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const double h = 1e-8, was = q[i];
    q[i] = was + h;
    const double after = bent.rig.jaws.energy(q, nullptr);
    q[i] = was - h;
    const double before = bent.rig.jaws.energy(q, nullptr);
    q[i] = was;
    EXPECT_NEAR(gradient[i], (after - before) / (2 * h), 1e-5 * scale) << i;
  }
}

TEST(Jaws, AFoldThatIsLetGoStaysAsFarAsItsFrictionHoldsIt) {
  Bent bent;
  const std::vector<int> far = bent.rig.clamp([](Vec2 p) { return p.x == 0.01; }, {1, 0, 0});
  const auto moment = [&] {
    double sum = 0;
    for (const int hold : far) sum += bent.rig.jaws.moment(hold, bent.rig.q);
    return sum / 0.01;
  };
  const auto bend = [&](double curvature) {
    const double turn = curvature * 0.01;
    for (const int hold : far) bent.rig.jaws.turn(hold, {std::cos(turn), 0, -std::sin(turn)});
    for (std::size_t v = 0; v < bent.specimen.points.size(); ++v) {
      const Vec2 p = bent.specimen.points[v];
      bent.rig.put(static_cast<int>(v),
                   {std::sin(p.x * curvature) / curvature, p.y, (std::cos(p.x * curvature) - 1) / curvature});
    }
    ASSERT_TRUE(bent.rig.solve(1e-3, 1e-7));
  };
  for (const double curvature : {25.0, 50.0, 75.0, 100.0}) bend(curvature);
  EXPECT_NEAR(moment(), 6.9e-6 * 100 + 2.45e-4 / 2, 1e-6);
  for (const double curvature : {80.0, 60.0, 40.0}) bend(curvature);
  EXPECT_NEAR(moment(), 6.9e-6 * 40 - 2.45e-4 / 2, 1e-6);
  // Without a moment it rests at HB / B.
  bend(2.45e-4 / 2 / 6.9e-6);
  EXPECT_NEAR(moment(), 0, 1e-6);
}

}  // namespace
}  // namespace toile
