// Patterns of GarmentCode as scripts: small ones beside this file with what shall come of them, and the samples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "runtime/driver/importing.hpp"
#include "runtime/driver/run.hpp"
#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

const fs::path beside = fs::path(TOILE_SOURCE_DIR) / "tests" / "runtime" / "import";

struct HeardImport final : Listener {
  std::vector<std::string> codes, notes, failures;
  void diagnosed(const Diagnostic& diagnostic, const Sources&) override { codes.push_back(diagnostic.code); }
  void printed(const std::string&) override {}
  void noted(const std::string& line) override { notes.push_back(line); }
  void wrote(const std::string&) override {}
  void failed(const std::string& message, const std::string&) override { failures.push_back(message); }
};

class Import : public testing::Test {
 protected:
  std::string imported(const fs::path& json) {
    const Outcome outcome = import_pattern(json.string(), script().string(), heard);
    EXPECT_EQ(outcome.exit_code(), 0) << json << ": " << testing::PrintToString(heard.failures);
    return scratch.read("out.toile");
  }

  /// As `toile check` does.
  int check() {
    Workroom workroom({}, heard, {});
    if (workroom.load(script())) check_meshes(workroom);
    return workroom.outcome().exit_code();
  }

  fs::path script() const { return scratch / "out.toile"; }

  static std::string golden(const std::string& name) {
    std::ifstream in(beside / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  Scratch scratch{"import"};
  HeardImport heard;
};

TEST_F(Import, KeepsCurvesAndShowsRightSides) {
  EXPECT_EQ(imported(beside / "curves.json"), golden("curves.toile"));
  EXPECT_THAT(heard.notes, ElementsAre("2 pieces, 2 seams"));
  EXPECT_EQ(check(), 0);
  EXPECT_THAT(heard.codes, IsEmpty());
  EXPECT_THAT(heard.notes.back(), HasSubstr("boundary loops 2, Euler characteristic 0, orientable"));
}

TEST_F(Import, TellsFullnessFromMistakes) {
  EXPECT_EQ(imported(beside / "lengths.json"), golden("lengths.toile"));
  EXPECT_THAT(heard.notes,
              ElementsAre("4 pieces, 6 seams", HasSubstr("ruffle.e0 is 70cm long and cuff.e0, sewn to it, 10cm")));
  EXPECT_EQ(check(), 1);
  EXPECT_THAT(heard.codes, ElementsAre("E0316"));
}

TEST_F(Import, MakesNamesOfWhatIsNone) {
  EXPECT_EQ(imported(beside / "odd_names.json"), golden("odd_names.toile"));
  EXPECT_EQ(check(), 0);
  EXPECT_THAT(heard.codes, IsEmpty());
}

TEST_F(Import, OfAFileWithAnUnreadableNameCanBeRead) {
  const fs::path odd = scratch / "a\xff{}\n.json";
  fs::copy_file(beside / "curves.json", odd);
  imported(odd);
  EXPECT_EQ(check(), 0);
  EXPECT_THAT(heard.codes, IsEmpty());
}

TEST_F(Import, LeavesNothingBehindOfWhatIsNoPattern) {
  scratch.write("a.json", R"({"pattern": {"panels": {"p": {"vertices": [], "edges": [{"endpoints": [0, 1]}]}}}})");
  EXPECT_EQ(import_pattern((scratch / "a.json").string(), script().string(), heard).exit_code(), 4);
  EXPECT_THAT(heard.failures, ElementsAre(HasSubstr("a.json: panel \"p\", edge 0: there is no vertex 0")));
  EXPECT_EQ(scratch.files(), 1);
  EXPECT_EQ(import_pattern((scratch / "b.json").string(), script().string(), heard).exit_code(), 4);
}

TEST_F(Import, OfEverySamplePassesTheCheck) {
  const char* given = std::getenv("TOILE_DATA_DIR");
  const fs::path folder =
      (given != nullptr ? fs::path(given) : fs::path(TOILE_SOURCE_DIR) / ".." / "shared" / "data") / "garmentcode";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "no data: " << folder;
  int samples = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++samples;
    imported(entry.path());
    EXPECT_EQ(check(), 0) << entry.path();
    EXPECT_THAT(heard.notes.back(), HasSubstr("components 1,")) << entry.path();
    EXPECT_THAT(heard.notes.back(), HasSubstr(", orientable")) << entry.path();
  }
  EXPECT_THAT(heard.codes, IsEmpty());
  RecordProperty("samples", samples);
}

}  // namespace
}  // namespace toile
