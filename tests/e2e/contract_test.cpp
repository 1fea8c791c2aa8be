// The contract of the command line: exit codes, streams, help, files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const char* const square = R"(
import fabrics
param size = 20cm in 10cm..60cm
body ball = sphere(radius: 15cm, height: 50cm)
garment cloth in fabrics.wool_serge {
  piece square {
    outline from (0cm, 0cm) {
      south = line to (size, 0cm)
      east  = line to (size, size)
      north = line to (0cm, size)
      west  = line to start
    }
  }
}
)";

class Contract : public testing::Test {
 protected:
  Contract() { call.scratch.write("cloth.toile", square); }
  CommandLine call;
};

TEST_F(Contract, HelpOfEveryCallHasAnExample) {
  const Called all = call.toile("--help");
  EXPECT_EQ(all.exit_code, 0);
  for (const char* name : {"run", "check", "compile", "draft", "drape", "render", "fmt", "explain", "test", "import"}) {
    EXPECT_THAT(all.out, HasSubstr(name));
    const Called one = call.toile(fmt::format("{} --help", name));
    EXPECT_EQ(one.exit_code, 0) << name;
    EXPECT_THAT(one.out, HasSubstr(fmt::format("Example:\n  toile {}", name)));
  }
  EXPECT_THAT(call.toile("--version").out, StartsWith("toile "));
}

TEST_F(Contract, WrongUsageIsTwoAndSaysWhatIsMeant) {
  EXPECT_EQ(call.toile("").exit_code, 2);
  const Called mistyped = call.toile("drap cloth.toile");
  EXPECT_EQ(mistyped.exit_code, 2);
  EXPECT_THAT(mistyped.err, HasSubstr("toile drape"));
  EXPECT_EQ(call.toile("run cloth.toile --no-such-flag").exit_code, 2);
  EXPECT_EQ(call.toile("run cloth.toile --set size").exit_code, 2);
  EXPECT_EQ(call.toile("compile cloth.toile --emit bytes").exit_code, 2);
  EXPECT_EQ(call.toile("drape cloth.toile --accuracy roughly").exit_code, 2);
  EXPECT_EQ(call.toile("render cloth.toile -o c.png --pixels 5").exit_code, 2);
  EXPECT_EQ(call.toile("render cloth.toile -o c.png --from behind").exit_code, 2);
  EXPECT_EQ(call.toile("draft cloth.toile -o cloth.doc").exit_code, 2);
  const Called no_garment = call.toile("draft cloth.toile -o c.svg --garment clot");
  EXPECT_EQ(no_garment.exit_code, 2);
  EXPECT_THAT(no_garment.err, HasSubstr("`cloth`"));
}

TEST_F(Contract, AScriptThatIsNotThereIsFour) {
  const Called missing = call.toile("check nothing.toile");
  EXPECT_EQ(missing.exit_code, 4);
  EXPECT_THAT(missing.err, HasSubstr("nothing.toile"));
}

TEST_F(Contract, AFileThatCannotBeWrittenIsFour) {
  call.scratch.write("taken", "");
  EXPECT_EQ(call.toile("draft cloth.toile -o taken/c.svg").exit_code, 4);
}

TEST_F(Contract, AnErrorInTheScriptIsOneAndHasItsPlace) {
  call.scratch.write("wrong.toile", "let a = 3cm\nlet b = a + 4deg\n");
  const Called checked = call.toile("check wrong.toile");
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_THAT(checked.err, StartsWith("wrong.toile:2:"));
  EXPECT_THAT(checked.err, HasSubstr("error[E0201]"));
  EXPECT_THAT(checked.out, IsEmpty());
  const Called as_json = call.toile("check wrong.toile --message-format json");
  EXPECT_THAT(as_json.err, StartsWith(R"({"type":"diagnostic","severity":"error","code":"E0201")"));
  EXPECT_THAT(as_json.err, HasSubstr(R"("line":2)"));
  EXPECT_THAT(call.toile("check wrong.toile --color always").err, HasSubstr("\x1b["));
}

TEST_F(Contract, AParameterOutOfItsRangeIsOne) {
  const Called checked = call.toile("check cloth.toile --set size=5cm");
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_THAT(checked.err, HasSubstr("10 cm .. 60 cm"));
}

TEST_F(Contract, AFileBeforeAnErrorInTheScript) {
  call.scratch.write("taken", "");
  call.scratch.write("both.toile", std::string(square) + "export cloth to \"taken/c.svg\"\nexpect 1 > 2\n");
  EXPECT_EQ(call.toile("run both.toile").exit_code, 4);
}

TEST_F(Contract, StagesGoToStandardOutputOrAFile) {
  for (const char* stage : {"ast", "pattern", "pmesh", "smesh"}) {
    const std::string arguments = fmt::format("compile cloth.toile --triangles 60 --emit {}", stage);
    const Called shown = call.toile(arguments);
    EXPECT_EQ(shown.exit_code, 0) << shown.err;
    EXPECT_EQ(call.toile(arguments + " -o stage.txt").exit_code, 0);
    EXPECT_THAT(shown.out, Not(IsEmpty()));
    EXPECT_EQ(call.scratch.read("stage.txt"), shown.out) << stage;
  }
}

TEST_F(Contract, TheTreeIsShownOfAFaultyTextToo) {
  call.scratch.write("faulty.toile", "let a = = 3cm\n");
  const Called shown = call.toile("compile faulty.toile --emit ast");
  EXPECT_EQ(shown.exit_code, 1);
  EXPECT_THAT(shown.out, Not(IsEmpty()));
}

TEST_F(Contract, DrapeWritesWhatIsAskedFor) {
  const Called draped = call.toile(
      "drape cloth.toile --triangles 200 --set size=30cm -o c.glb -o c.obj -o new/c.ply --report c.report.json "
      "--profile c.profile.json");
  EXPECT_EQ(draped.exit_code, 0) << draped.err;
  EXPECT_THAT(call.scratch.read("c.glb"), StartsWith("glTF"));
  EXPECT_THAT(call.scratch.read("c.obj"), HasSubstr("\nv "));
  EXPECT_THAT(call.scratch.read("new/c.ply"), StartsWith("ply\n"));
  EXPECT_THAT(call.scratch.read("c.report.json"), HasSubstr("\"weight_error\""));
  EXPECT_THAT(call.scratch.read("c.profile.json"), HasSubstr("\"peak_memory_bytes\""));
}

TEST_F(Contract, RenderDrapesFirstAndWritesAPicture) {
  const Called rendered =
      call.toile("render cloth.toile --triangles 200 -o c.png --from front --show strain.warp --pixels 64x48 --quiet");
  EXPECT_EQ(rendered.exit_code, 0);
  EXPECT_THAT(rendered.err, IsEmpty());
  EXPECT_THAT(call.scratch.read("c.png"), StartsWith("\x89PNG"));
}

TEST_F(Contract, ASolveThatDoesNotSettleIsThreeAndStillWrites) {
  call.scratch.write("slips.toile", R"(
import fabrics
body ball = sphere(radius: 5cm, height: 50cm, friction: 0)
garment strip in fabrics.silk {
  piece strip {
    outline from (0cm, 0cm) {
      south = line to (60cm, 0cm)
      east  = line to (60cm, 10cm)
      north = line to (0cm, 20cm)
      west  = line to start
    }
  }
}
)");
  const Called unsettled = call.toile("drape slips.toile --triangles 60 -o c.obj");
  EXPECT_EQ(unsettled.exit_code, 3) << "it slips off and falls for ever\n" << unsettled.err;
  EXPECT_THAT(unsettled.err, HasSubstr("did not come to rest"));
  EXPECT_THAT(call.scratch.read("c.obj"), HasSubstr("\nf "));
}

TEST_F(Contract, AnInterruptLeavesNoFiles) {
  const Called interrupted = call.toile("drape cloth.toile --triangles 20000 --accuracy 1e-9 -o c.obj",
                                        "timeout --preserve-status --signal INT 1.5");
  EXPECT_EQ(interrupted.exit_code, 130) << interrupted.err;
  EXPECT_EQ(call.scratch.files(), 1) << "only the script stays";
}

TEST_F(Contract, ProgressIsShownOnlyWhenAskedForOffATerminal) {
  const std::string drape = "drape cloth.toile --triangles 150";
  EXPECT_THAT(call.toile(drape).err, Not(HasSubstr("%\n")));
  EXPECT_THAT(call.toile(drape + " --progress").err, HasSubstr(" %\n"));
}

TEST_F(Contract, ThreadsDoNotChangeAByte) {
  for (const char* threads : {"1", "2"}) {
    const Called draped =
        call.toile(fmt::format("drape cloth.toile --triangles 600 --set size=50cm --threads {0} -o {0}.ply --report "
                               "{0}.json",
                               threads));
    ASSERT_EQ(draped.exit_code, 0) << draped.err;
  }
  EXPECT_EQ(call.scratch.read("1.ply"), call.scratch.read("2.ply"));
  EXPECT_EQ(call.scratch.read("1.json"), call.scratch.read("2.json"));
}

TEST_F(Contract, WarmGoesOnFromTheLastDrapeAndColdDoesNot) {
  const auto drape = [&](const std::string& more, const std::string& size = "50cm") {
    return call.toile("drape cloth.toile --triangles 600 -o c.ply --report r.json --set size=" + size + " " + more,
                      "env XDG_CACHE_HOME=cache");
  };
  const auto iterations = [&] {
    return nlohmann::json::parse(call.scratch.read("r.json"))["solve"]["iterations"].get<int>();
  };
  ASSERT_EQ(drape("").exit_code, 0);
  const int cold = iterations();
  const std::string bytes = call.scratch.read("c.ply");
  EXPECT_FALSE(std::filesystem::exists(call.scratch / "cache")) << "nothing is kept unasked";

  ASSERT_EQ(drape("--warm").exit_code, 0);
  EXPECT_EQ(call.scratch.read("c.ply"), bytes) << "the first one has nothing to start from";
  ASSERT_EQ(drape("--warm", "51cm").exit_code, 0);
  EXPECT_LT(iterations(), cold);
  ASSERT_EQ(drape("").exit_code, 0);
  EXPECT_EQ(call.scratch.read("c.ply"), bytes);

  for (const auto& kept : std::filesystem::recursive_directory_iterator(call.scratch / "cache")) {
    if (kept.is_regular_file()) std::filesystem::resize_file(kept.path(), 100);
  }
  ASSERT_EQ(drape("--warm").exit_code, 0);
  EXPECT_EQ(call.scratch.read("c.ply"), bytes) << "a damaged one is none";
}

TEST_F(Contract, GoldenTestsCloseWithACount) {
  EXPECT_EQ(call.toile("test").exit_code, 1);
  EXPECT_EQ(call.toile("test --update").exit_code, 0);
  const Called tested = call.toile("test");
  EXPECT_EQ(tested.exit_code, 0);
  EXPECT_EQ(tested.out, "1 passed, 0 failed\n");
}

}  // namespace
}  // namespace toile
