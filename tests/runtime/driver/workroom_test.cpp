// The whole chain below the command line, on small scripts.
#include "runtime/driver/workroom.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/driver/result.hpp"
#include "runtime/driver/run.hpp"
#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Keeps what was said, each in its own list.
struct Heard final : Listener {
  std::vector<std::string> codes, lines, notes, files, failures;
  void diagnosed(const Diagnostic& diagnostic, const Sources& sources) override {
    codes.push_back(diagnostic.code);
    rendered += render(diagnostic, sources, false);
  }
  void printed(const std::string& line) override { lines.push_back(line); }
  void noted(const std::string& line) override { notes.push_back(line); }
  void wrote(const std::string& path) override { files.push_back(std::filesystem::path(path).filename().string()); }
  void failed(const std::string& message, const std::string& help) override { failures.push_back(message + help); }
  std::string rendered;
};

const char* const tube = R"(
import fabrics
param height = 12cm in 5cm..20cm
garment tube in fabrics.wool_serge {
  piece sheet {
    outline from (0cm, 0cm) {
      lower = line to (30cm, 0cm)
      right = line to (30cm, height)
      upper = line to (0cm, height)
      left  = line to start
    }
  }
  sew sheet.left to sheet.right
}
)";

class WorkroomTest : public testing::Test {
 protected:
  WorkroomOptions options() const {
    WorkroomOptions chosen;
    chosen.out = scratch.path();
    chosen.triangles = 150;
    return chosen;
  }

  Scratch scratch{"workroom"};
  Heard heard;
};

TEST_F(WorkroomTest, CarriesOutCommandsWithEachOthersResults) {
  Workroom workroom(options(), heard, {});
  ASSERT_TRUE(workroom.load("tube.toile", std::string(tube) + R"(
drape tube as floating
print floating.mesh.euler
export tube to "tube.svg"
export floating to "tube.obj"
export floating to "below/tube.report.json"
expect floating.mesh.triangles > 10
)")) << heard.rendered;
  run_commands(workroom);
  EXPECT_THAT(heard.lines, ElementsAre("0"));
  EXPECT_THAT(heard.files, ElementsAre("tube.svg", "tube.obj", "tube.report.json"));
  EXPECT_THAT(scratch.read("tube.obj"), HasSubstr("\nf "));
  EXPECT_EQ(workroom.outcome().exit_code(), 0) << heard.rendered;
}

TEST_F(WorkroomTest, AnExpectationThatDoesNotHoldIsShownWithWhatWasFound) {
  Workroom workroom(options(), heard, {});
  ASSERT_TRUE(workroom.load("tube.toile", std::string(tube) + "drape tube as floating\n"
                                                              "expect floating.mesh.euler == 2\n"
                                                              "print \"after\"\n"));
  run_commands(workroom);
  EXPECT_EQ(workroom.outcome().exit_code(), 1);
  EXPECT_THAT(heard.rendered, StartsWith("tube.toile:16:"));
  EXPECT_THAT(heard.rendered, HasSubstr("floating.mesh.euler == 2"));
  EXPECT_THAT(heard.lines, ElementsAre("after")) << "later commands are still carried out";
}

TEST_F(WorkroomTest, ResultsHaveExactlyTheDocumentedFields) {
  Workroom workroom(options(), heard, {});
  ASSERT_TRUE(workroom.load("tube.toile", tube));
  DrapeCommand command;
  const std::optional<Draped> draped = workroom.drape(command);
  ASSERT_TRUE(draped);
  std::vector<std::string> found, documented;
  for (const auto& [name, value] : result_of(*draped)) found.push_back(name);
  for (const auto& [name, unit] : result_schema()) documented.push_back(name);
  EXPECT_THAT(found, testing::UnorderedElementsAreArray(documented));
}

TEST_F(WorkroomTest, SetsParametersAndReplacesTheCloth) {
  WorkroomOptions chosen = options();
  chosen.settings = {{"height", "18cm"}};
  chosen.fabric = "fabrics.wool_serge";
  Workroom workroom(chosen, heard, {});
  ASSERT_TRUE(workroom.load("tube.toile", tube)) << heard.rendered;
  const std::shared_ptr<const MadeGarment> made = workroom.make(0);
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->cloth.area, 0.30 * 0.18, 1e-9);
  EXPECT_THAT(made->garment.fabric.name, HasSubstr("wool_serge"));
}

TEST_F(WorkroomTest, AClothThatDoesNotExistIsAWrongUsage) {
  WorkroomOptions chosen = options();
  chosen.fabric = "fabrics.wool_sarge";
  Workroom workroom(chosen, heard, {});
  ASSERT_TRUE(workroom.load("tube.toile", tube));
  EXPECT_EQ(workroom.make(0), nullptr);
  EXPECT_EQ(workroom.outcome().exit_code(), 2);
  EXPECT_THAT(heard.failures, Contains(HasSubstr("wool_serge")));
}

TEST_F(WorkroomTest, NamesThatAreNotThereAreWrongUsages) {
  Workroom workroom(options(), heard, {});
  ASSERT_TRUE(workroom.load("tube.toile", tube));
  draft(workroom, "tub", scratch / "t.svg");
  EXPECT_THAT(heard.failures, ElementsAre(HasSubstr("tube")));
  EXPECT_EQ(workroom.outcome().exit_code(), 2);
  EXPECT_EQ(scratch.files(), 0);
}

TEST_F(WorkroomTest, AFileThatCannotBeWrittenDoesNotStopTheOthers) {
  scratch.write("taken/here", "");
  Workroom workroom(options(), heard, {});
  ASSERT_TRUE(workroom.load("tube.toile",
                            std::string(tube) + "export tube to \"taken/here/t.svg\"\nexport tube to \"t.json\"\n"));
  run_commands(workroom);
  EXPECT_EQ(workroom.outcome().exit_code(), 4);
  EXPECT_THAT(heard.files, ElementsAre("t.json"));
}

TEST_F(WorkroomTest, AnInterruptedDrapeWritesNothing) {
  std::atomic<bool> cancelled{false};
  Job job;
  job.cancelled = &cancelled;
  job.report = [&cancelled](const Progress&) { cancelled = true; };
  Workroom workroom(options(), heard, job);
  ASSERT_TRUE(
      workroom.load("tube.toile", std::string(tube) + "drape tube as floating\nexport floating to \"t.obj\"\n"));
  run_commands(workroom);
  EXPECT_EQ(workroom.outcome().exit_code(), 130);
  EXPECT_EQ(scratch.files(), 0);
  EXPECT_THAT(heard.codes, IsEmpty());
}

TEST_F(WorkroomTest, TheSameScriptGivesTheSameBytes) {
  std::vector<std::string> bytes;
  for (const char* name : {"a.glb", "b.glb"}) {
    Workroom workroom(options(), heard, {});
    ASSERT_TRUE(workroom.load("tube.toile", tube));
    drape_once(workroom, {"", "", {scratch / name}, ""});
    bytes.push_back(scratch.read(name));
  }
  EXPECT_FALSE(bytes[0].empty());
  EXPECT_EQ(bytes[0], bytes[1]);
}

TEST(FileWorld, TellsBodiesApartByWhatTheyAre) {
  BodySpec ball;
  ball.shape = SphereSpec{0.15, 0.5};
  BodySpec renamed = ball;
  renamed.name = "other";
  renamed.written.span = {3, 9};
  EXPECT_EQ(identity(ball), identity(renamed));
  BodySpec larger = ball;
  larger.shape = SphereSpec{0.16, 0.5};
  EXPECT_NE(identity(ball), identity(larger));
  BodySpec softer = ball;
  softer.softness = 1e5;
  EXPECT_NE(identity(ball), identity(softer));
  FormSpec one, two;
  one.sections = {{"waist", 1, 0.7}};
  two.sections = {{"waist", 1, 0.7}, {"hip", 0.8, 0.9}};
  BodySpec first = ball, second = ball;
  first.shape = one;
  second.shape = two;
  EXPECT_NE(identity(first), identity(second));
}

}  // namespace
}  // namespace toile
