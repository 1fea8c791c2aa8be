// `--size`, called as a person would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

using testing::HasSubstr;

const char* const flag = R"(sizes flags(width) {
  S 20cm
  L 80cm
}
param width = flags.width
garment flag {
  piece cloth {
    outline from (0cm, 0cm) {
      foot = line to (width, 0cm)
      fly  = line to (0cm, 10cm)
      head = line to start
    }
  }
}
print flags.size, width
)";

TEST(SizesOnTheCommandLine, OneOrAllOfThem) {
  const CommandLine call;
  call.scratch.write("flag.toile", flag);
  EXPECT_EQ(call.toile("run flag.toile --size L").out, "L 80 cm\n");
  EXPECT_EQ(call.toile("run flag.toile --size L --set width=75cm").out, "L 75 cm\n");
  EXPECT_EQ(call.toile("run flag.toile --size all").out, "S 20 cm\nL 80 cm\n");
  EXPECT_EQ(call.toile("draft flag.toile -o flag.svg --size all").exit_code, 0);
  EXPECT_FALSE(call.scratch.read("flag-S.svg").empty());
  EXPECT_FALSE(call.scratch.read("flag-L.svg").empty());
}

TEST(SizesOnTheCommandLine, AllOfThemNestedInOneDrawing) {
  const CommandLine call;
  call.scratch.write("flag.toile", flag);
  const Called drafted = call.toile("draft flag.toile --nested -o nest.svg");
  EXPECT_EQ(drafted.exit_code, 0) << drafted.err;
  const std::string drawing = call.scratch.read("nest.svg");
  EXPECT_THAT(drawing, HasSubstr(">S</text>"));
  EXPECT_THAT(drawing, HasSubstr(">L</text>"));
  EXPECT_THAT(drawing, HasSubstr("L200,0"));  // the foot of the small one
  EXPECT_THAT(drawing, HasSubstr("L800,0"));  // and of the large one, from the same origin
  EXPECT_EQ(call.toile("draft flag.toile --nested -o nest.dxf").exit_code, 2);
}

TEST(SizesOnTheCommandLine, EverySizeOfAStandardTableInOneRun) {
  const CommandLine call;
  const Called drafted = call.toile(
      fmt::format("draft '{}/examples/graded_skirt/graded_skirt.toile' -o skirt.svg --size all", TOILE_SOURCE_DIR));
  EXPECT_EQ(drafted.exit_code, 0) << drafted.err;
  for (const char* size : {"6", "8", "10", "12", "14", "16", "18", "20", "22", "24"}) {
    EXPECT_FALSE(call.scratch.read(fmt::format("skirt-{}.svg", size)).empty()) << size;
  }
}

TEST(SizesOnTheCommandLine, EveryFigureOfTheStandardTablesHasItsForm) {
  const CommandLine call;
  for (const char* table : {"women", "men", "children"}) {
    call.scratch.write("form.toile",
                       fmt::format("import bodies\nimport sizing\nbody form = bodies.dress_form(sizing.{0}...)\n"
                                   "expect abs(form.waist.girth - sizing.{0}.waist) < 1um\n"
                                   "expect abs(form.bust.girth - sizing.{0}.bust) < 1um\n",
                                   table));
    const Called ran = call.toile("run form.toile --size all --quiet");
    EXPECT_EQ(ran.exit_code, 0) << table << ran.err;
    EXPECT_EQ(ran.err, "") << table;
  }
}

TEST(SizesOnTheCommandLine, AnUnknownOneIsAnErrorOfTheScript) {
  const CommandLine call;
  call.scratch.write("flag.toile", flag);
  const Called called = call.toile("check flag.toile --size XL");
  EXPECT_EQ(called.exit_code, 1);
  EXPECT_THAT(called.err, HasSubstr("error[E0118]: `flags` has no size `XL`"));
  EXPECT_THAT(called.err, HasSubstr("did you mean `L`?"));
}

}  // namespace
}  // namespace toile
