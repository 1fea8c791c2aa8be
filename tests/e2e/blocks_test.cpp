// The blocks of the standard library, drafted and draped on the form of their size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

const char* const draped_blocks = R"(import bodies
import blocks
import sizing
body form = bodies.dress_form(sizing.women...)
let straight_skirt    = blocks.straight_skirt(form)
let circle_skirt      = blocks.circle_skirt(form)
let half_circle_skirt = blocks.half_circle_skirt(form)
let bodice            = blocks.bodice(form)

drape straight_skirt on form as straight to 1e-2
expect straight.solve.converged == 1 and straight.contact.weight_error < 1%
expect straight.contact.max_penetration < 3mm

drape circle_skirt on form as circle to 1e-2
expect circle.solve.converged == 1 and circle.contact.weight_error < 1%
expect circle.contact.max_penetration < 3mm

drape half_circle_skirt on form as half_circle to 1e-2
expect half_circle.solve.converged == 1 and half_circle.contact.weight_error < 1%
expect half_circle.contact.max_penetration < 3mm

drape bodice on form as upper to 1e-2
expect upper.solve.converged == 1 and upper.contact.weight_error < 1%
expect upper.contact.max_penetration < 8mm    // close fitting, about arms that are held out
)";

const char* const draped_trousers = R"(import bodies
import blocks
import sizing
body form = bodies.dress_form(sizing.women...)
let trousers = blocks.trousers(form)
drape trousers on form as worn
expect worn.solve.converged == 1 and worn.contact.weight_error < 1%
expect worn.contact.max_penetration < 8mm    // the fork presses
)";

const char* const blouse = R"(import bodies
import blocks
import fabrics
import sizing
let over_6 = sizing.women.bust - 80cm
body form = bodies.dress_form(
  sizing.women...,
  armhole: 34cm + 0.42 * over_6, upper_arm: 26cm + 0.3 * over_6, arm_angle: 40deg
)
garment blouse in fabrics.cotton_shirting {
  let block = blocks.bodice(form)
  piece front  = block.front
  piece back   = block.back
  piece sleeve = blocks.set_in_sleeve(block.front_scye, block.back_scye, block.cap_height, length: 40cm)
  piece cuff   = blocks.cuff(length(sleeve.hem))
  sew  front.side to back.side
  sew  front.shoulder to back.shoulder
  sew  back.centre to back.centre
  sew  sleeve.front_cap to front.armhole ease 1cm
  sew  sleeve.back_cap to back.armhole ease 1cm
  sew  sleeve.front_seam to sleeve.back_seam
  sew  cuff.left to cuff.right
  sew  cuff.head to sleeve.hem
  wear front.neck + back.neck at form.neck placed
  wear sleeve.front_cap.mirrored + sleeve.back_cap.mirrored at form.left_armhole placed
  wear sleeve.front_cap.drawn + sleeve.back_cap.drawn at form.right_armhole placed
}
drape blouse on form as worn to 1e-2
expect worn.solve.converged == 1
expect worn.bounds.width > 70cm    // the sleeves lie along the arms
expect worn.contact.max_penetration < 14mm    // and press where these leave the trunk
)";

const char* const band_pocket_and_collar = R"(import bodies
import blocks
import fabrics
import sizing
body form = bodies.dress_form(sizing.women..., arm_angle: 40deg)
garment skirt in fabrics.wool_serge {
  let block = blocks.straight_skirt(form)
  piece front = block.front with {
    line place from (3cm, -16cm) {
      left  = line to (3cm, -26cm)
      toe   = line to (9cm, -28cm)
      foot  = line to (15cm, -26cm)
      right = line to (15cm, -16cm)
    }
  }
  piece back   = block.back
  piece pocket = blocks.patch_pocket(width: 12cm, height: 12cm) with {
    cut 2 mirrored
  }
  piece band = blocks.waistband(2 * (front.sewn.waist + back.sewn.waist), depth: 3cm)
  sew  front.hip to back.hip
  sew  front.side to back.side
  sew  pocket.left + pocket.toe + pocket.foot + pocket.right to front.place
  sew  band.left to band.right
  sew  band.foot to front.waist + back.waist
  wear band.head at form.waist from 25%
}
garment top in fabrics.cotton_shirting {
  let block = blocks.bodice(form)
  piece front  = block.front
  piece back   = block.back
  piece collar = blocks.stand_collar(2 * length(front.neck) + 2 * length(back.neck), depth: 3cm)
  sew  front.side to back.side
  sew  front.shoulder to back.shoulder
  sew  back.centre to back.centre
  sew  collar.foot to front.neck + back.neck
  wear collar.head at form.neck placed
}
drape skirt on form as low to 1e-2
expect low.solve.converged == 1 and low.contact.weight_error < 1%
expect low.contact.max_penetration < 4mm and low.self.intersecting_triangle_pairs == 0
drape top on form as high to 1e-2
expect high.solve.converged == 1 and high.contact.weight_error < 1%
expect high.bounds.high > form.neck.level + 2cm    // the collar stands
)";

class DrapedBlocks : public testing::TestWithParam<std::string> {};

TEST_P(DrapedBlocks, RestOnTheFormOfTheirSize) {
  const CommandLine call;
  call.scratch.write("blocks.toile", draped_blocks);
  const Called ran = call.toile(fmt::format("run blocks.toile --size {} --triangles 350", GetParam()));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

TEST_P(DrapedBlocks, TrousersAsWell) {
  const CommandLine call;
  call.scratch.write("trousers.toile", draped_trousers);
  const Called ran = call.toile(fmt::format("run trousers.toile --size {} --triangles 900", GetParam()));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

TEST_P(DrapedBlocks, AWaistbandHoldsASkirtAPocketLiesOnItAndACollarStands) {
  const CommandLine call;
  call.scratch.write("parts.toile", band_pocket_and_collar);
  const Called ran = call.toile(fmt::format("run parts.toile --size {} --triangles 700", GetParam()));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

TEST_P(DrapedBlocks, ABlouseHasItsArmsInItsSleevesAndTheirCuffs) {
  const CommandLine call;
  call.scratch.write("blouse.toile", blouse);
  const Called ran = call.toile(fmt::format("run blouse.toile --size {} --triangles 900", GetParam()));
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

INSTANTIATE_TEST_SUITE_P(InSize, DrapedBlocks, testing::Values("6", "8", "10", "14", "18"),
                         [](const testing::TestParamInfo<std::string>& one) { return "Of" + one.param; });

}  // namespace
}  // namespace toile
