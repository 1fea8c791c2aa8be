// `toile develop` and what a script does with a development.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

using testing::HasSubstr;

constexpr const char* bodice = R"(import fabrics

body torso {
  section       at 80cm  { girth 94cm }
  section waist at 100cm { girth 68cm }
  section       at 120cm { girth 90cm }
  section       at 140cm { girth 60cm }
}

garment bodice in fabrics.cotton_shirting {
  piece front on torso {
    outline from (0cm, 100cm) {
      waist  = line to (12cm, 100cm)
      side   = line to (12cm, 128cm)
      top    = line to (0cm, 128cm)
      centre = line to start
    }
    fold  centre
    grain down
    dart  at 50% of waist { depth 18cm }
    allowance 1cm
  }
  wear front.waist at torso
  wear front.top   at torso
}
)";

TEST(DevelopCommand, WritesAPatternThatIsAScript) {
  const CommandLine call;
  call.scratch.write("bodice.toile", bodice);
  const Called developed =
      call.toile("develop bodice.toile --triangles 600 -o flat.toile -o flat.svg -o flat.obj --report r.json");
  EXPECT_EQ(developed.exit_code, 0) << developed.err;
  const std::string report = call.scratch.read("r.json");
  EXPECT_THAT(report, HasSubstr("\"flipped_triangles\": 0"));
  EXPECT_THAT(report, HasSubstr("\"dart\": \"dart1\""));
  EXPECT_THAT(report, HasSubstr("\"without_each_dart\""));
  EXPECT_THAT(report, HasSubstr("\"developed_for_45\""));
  EXPECT_EQ(call.toile("check flat.toile").exit_code, 0);
  EXPECT_EQ(call.toile("fmt flat.toile").exit_code, 0);
  EXPECT_EQ(call.toile("check flat.toile").exit_code, 0);
  EXPECT_THAT(call.scratch.read("flat.toile"), HasSubstr("fold  on_the_fold"));
}

TEST(DevelopCommand, GivesTheSameBytesForAnyNumberOfThreads) {
  const CommandLine call;
  call.scratch.write("bodice.toile", bodice);
  call.toile("develop bodice.toile --triangles 600 --threads 1 -o one.toile --report one.json");
  call.toile("develop bodice.toile --triangles 600 --threads 2 -o two.toile --report two.json");
  EXPECT_EQ(call.scratch.read("one.toile"), call.scratch.read("two.toile"));
  EXPECT_EQ(call.scratch.read("one.json"), call.scratch.read("two.json"));
  EXPECT_THAT(call.scratch.read("one.json"), HasSubstr("area_2d_m2"));
}

TEST(DevelopCommand, IsFollowedByADrapeOnTheSameBody) {
  const CommandLine call;
  call.scratch.write("bodice.toile", std::string(bodice) +
                                         "develop bodice as flat\n"
                                         "drape flat on torso as worn\n"
                                         "print worn.form.distance.mean\n"
                                         "expect worn.form.distance.mean < 2mm\n"
                                         "expect flat.seams.mismatch < 0.1mm\n");
  const Called ran = call.toile("run bodice.toile --triangles 600");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out + ran.err, HasSubstr("from its form: mean"));
}

TEST(DevelopCommand, CorrectsThePatternUntilItIsNearTheForm) {
  const CommandLine call;
  call.scratch.write("bodice.toile", std::string(bodice) +
                                         "develop bodice as first\n"
                                         "drape first on torso as uncorrected\n"
                                         "develop bodice as flat until within 2mm\n"
                                         "drape flat on torso as worn\n"
                                         "print flat.solve.drapes, uncorrected.form.distance.p95\n"
                                         "expect uncorrected.form.distance.p95 > 4mm\n"
                                         "expect worn.form.distance.p95 < 2mm\n"
                                         "expect flat.solve.drapes <= 8\n"
                                         "expect flat.seams.mismatch < 0.1mm\n"
                                         "expect flat.solve.flipped == 0\n");
  const Called ran = call.toile("run bodice.toile --triangles 500");
  EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.out;
}

TEST(DevelopCommand, SaysWhenNoPatternReachesTheForm) {
  const CommandLine call;
  call.scratch.write("bodice.toile", std::string(bodice) + "develop bodice as flat until within 0.01mm\n");
  const Called ran = call.toile("run bodice.toile --triangles 200");
  EXPECT_EQ(ran.exit_code, 3) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("W0514"));
}

TEST(DevelopCommand, ShowsThePieceThatLeavesTheBody) {
  const CommandLine call;
  std::string high = bodice;
  for (std::size_t at = high.find("128cm"); at != std::string::npos; at = high.find("128cm"))
    high.replace(at, 5, "160cm");
  call.scratch.write("bodice.toile", high);
  const Called developed = call.toile("develop bodice.toile -o flat.toile");
  EXPECT_EQ(developed.exit_code, 1);
  EXPECT_THAT(developed.err, HasSubstr("E0512"));
  EXPECT_THAT(developed.err, HasSubstr("bodice.toile:11:"));
}

}  // namespace
}  // namespace toile
