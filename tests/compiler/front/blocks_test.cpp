// The blocks of the standard library close as stated in every size of its tables.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::IsEmpty;

const std::string all_blocks = R"(import bodies
import blocks
import fabrics
import sizing
body form = bodies.dress_form(sizing.women...)
let straight    = blocks.straight_skirt(form)
let circle      = blocks.circle_skirt(form)
let half_circle = blocks.half_circle_skirt(form)
let bodice      = blocks.bodice(form)
garment blouse in fabrics.cotton_shirting {
  piece front  = bodice.front
  piece back   = bodice.back
  piece sleeve = blocks.set_in_sleeve(bodice.front_scye, bodice.back_scye, bodice.cap_height)
  piece cuff   = blocks.cuff(length(sleeve.hem))
  piece collar = blocks.stand_collar(2 * length(front.neck) + 2 * length(back.neck))
  sew front.side to back.side
  sew front.shoulder to back.shoulder
  sew back.centre to back.centre
  sew sleeve.front_cap to front.armhole ease 1cm
  sew sleeve.back_cap to back.armhole ease 1cm
  sew sleeve.front_seam to sleeve.back_seam
  sew cuff.head to sleeve.hem
  sew cuff.left to cuff.right
  sew collar.foot to front.neck + back.neck
}
garment skirt in fabrics.denim {
  piece skirt = half_circle.skirt
  piece band  = blocks.waistband(2 * length(half_circle.skirt.waist))
  sew skirt.back to skirt.back
  sew band.left to band.right
  sew band.foot to skirt.waist
}
garment pocket in fabrics.denim {
  piece patch = blocks.patch_pocket(width: 12cm)
}
)";

class Blocks : public testing::TestWithParam<std::string> {};

TEST_P(Blocks, EverySeamClosesAsStated) {
  FakeWorld world;
  const auto program = load("test.toile", all_blocks, {}, world, GetParam());
  std::string told;
  for (const Diagnostic& diagnostic : program->diagnostics()) told += render(diagnostic, program->sources(), false);
  EXPECT_THAT(told, IsEmpty());
  EXPECT_EQ(program->garments().size(), 7u);
}

INSTANTIATE_TEST_SUITE_P(InSize, Blocks, testing::Values("6", "8", "10", "12", "14", "16", "18", "20", "22", "24"),
                         [](const testing::TestParamInfo<std::string>& one) { return "Of" + one.param; });

TEST(SetInSleeve, ACapIsAsLongAsItsArmholeAndTheEase) {
  const std::string sleeve =
      "import blocks\ngarment g {\n  piece s = blocks.set_in_sleeve(21cm, 22cm, 14cm, ease: 3cm)\n"
      "  sew s.front_seam.drawn to s.front_seam.mirrored\n}\n";
  EXPECT_EQ(value_of("round(length(g.s.front_cap), to: 1um), round(length(g.s.back_cap), to: 1um)", sleeve),
            "22.5 cm 23.5 cm");
}

}  // namespace
}  // namespace toile::test
