// One slip in a sound script is answered by one diagnostic, at its place: nothing that follows from it is said as well.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

const std::string sound_skirt = R"(param length = 60cm in 30cm..110cm
textile awning {
  warp 80, #1f3a5f, 80, #ffffff
}
body form {
  section hip   at 85cm  { girth 94cm }
  section waist at 105cm { girth 68cm }
}
fabric serge {
  B 0.06 gf*cm^2/cm
  W 19 mg/cm^2
}
// its shear and its extension are those of its class
garment skirt in serge printed awning {
  piece front {
    outline from (0cm, 0cm) {
      waist  = curve to (20cm, 1.2cm) leaving 0deg arriving 10deg
      side   = line to (34cm, -length)
      hem    = curve to (0cm, -length - 1cm) arriving 180deg
      centre = line to start
    }
    fold centre
    dart at 55% of waist { width 2.5cm, depth 9cm }
    notch at 18cm of side
    allowance 1cm, hem 4cm
  }
  piece back = front with {
    dart at 50% of waist { width 2.5cm, depth 11cm }
  }
  sew front.side to back.side
  wear front.waist + back.waist at form.waist
}
drape skirt on form as worn
allow W0410
)";

std::vector<std::string> told_with(const std::string& word, const std::string& slip) {
  std::string text = sound_skirt;
  text.replace(text.find(word), word.size(), slip);
  return Script(text).told();
}

struct Slip {
  const char* name;
  const char* word;
  const char* slip;
  const char* answer;
};

class Slips : public testing::TestWithParam<Slip> {};

TEST(SoundScript, HasNone) {
  EXPECT_THAT(Script(sound_skirt).told(), IsEmpty()) << Script(sound_skirt).rendered();
}

TEST_P(Slips, AreAnsweredOnce) {
  EXPECT_THAT(told_with(GetParam().word, GetParam().slip), ElementsAre(StartsWith(GetParam().answer)));
}

INSTANTIATE_TEST_SUITE_P(
    Script, Slips,
    testing::Values(Slip{"ColourOfFiveDigits", "#1f3a5f", "#1f3a5", "E0004 3:12"},
                    Slip{"RangeOfAnotherDimension", "60cm in 30cm", "60 in 30cm", "E0201 1:22"},
                    Slip{"SectionAtATakenLevel", "at 105cm", "at 85cm", "E0408 7:3"},
                    Slip{"EdgeDrawnTwice", "hem    = curve", "side   = curve", "E0102 19:7"},
                    Slip{"PieceDefinedTwice", "piece back =", "piece front =", "E0102 27:9"},
                    Slip{"EdgeThatCrossesOthers", "(34cm, -length)", "(-20cm, -length)", "E0302 20:7"},
                    Slip{"EdgeWithoutLength", "(34cm, -length)", "(20cm, 1.2cm)", "E0303 18:7"},
                    Slip{"FoldAtACurvedEdge", "fold centre", "fold waist", "E0306 22:5"},
                    Slip{"BraceClosedTooEarly", "    fold centre\n", "    fold centre }\n", "E0001 23:5"},
                    Slip{"EaseThatIsNotThere", "to back.side", "to back.side ease 2cm", "E0316 30:7"},
                    Slip{"WordWhereABodyIsWanted", "on form as", "on from as", "E0001 33:16"}),
    [](const testing::TestParamInfo<Slip>& slip) { return slip.param.name; });

TEST(Variations, OnTheFoldOrInPairsAsTheySayThemselves) {
  const auto varied = [](const std::string& own, const std::string& word) {
    return Script(
        "garment g {\n  piece front {\n    outline from (0cm, 0cm) {\n      hem = line to (30cm, 0cm)\n"
        "      side = line to (30cm, 40cm)\n      top = line to (0cm, 40cm)\n      centre = line to start\n"
        "    }\n    " +
        own + "\n  }\n  piece back = front with {\n    " + word + "\n  }\n  sew front.side to back.side\n}\n");
  };
  const Script pair = varied("fold centre", "cut 2 mirrored");
  ASSERT_THAT(pair.told(), IsEmpty()) << pair.rendered();
  EXPECT_THAT(pair.program->garments().at(0).pieces, testing::SizeIs(3));
  const Script folded = varied("cut 2 mirrored", "fold centre");
  ASSERT_THAT(folded.told(), IsEmpty()) << folded.rendered();
  EXPECT_THAT(folded.program->garments().at(0).pieces, testing::SizeIs(3));
}

}  // namespace
}  // namespace toile::test
