// `toile fmt`, `toile explain` and SARIF, called as a person would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/e2e/call.hpp"

namespace toile {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Tooling : public testing::Test {
 protected:
  CommandLine call;
};

TEST_F(Tooling, FmtRewritesWhatIsNotInTheLayout) {
  call.scratch.write("a.toile", "let a=3 cm // why\n");
  call.scratch.write("b.toile", "let b = 4cm\n");
  const Called checked = call.toile("fmt --check a.toile b.toile");
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_THAT(checked.err, HasSubstr("a.toile is not in the layout"));
  EXPECT_THAT(checked.err, testing::Not(HasSubstr("b.toile")));
  EXPECT_EQ(call.scratch.read("a.toile"), "let a=3 cm // why\n");
  const Called laid_out = call.toile("fmt a.toile b.toile");
  EXPECT_EQ(laid_out.exit_code, 0);
  EXPECT_EQ(laid_out.err, "wrote a.toile\n");
  EXPECT_EQ(call.scratch.read("a.toile"), "let a = 3cm    // why\n");
  EXPECT_EQ(call.toile("fmt --check a.toile b.toile").exit_code, 0);
  EXPECT_EQ(call.scratch.files(), 2) << "no temporary file stays";
}

TEST_F(Tooling, FmtLeavesAFaultyTextAsItIs) {
  call.scratch.write("faulty.toile", "let a=3cm\nlet b = = 4cm\n");
  const Called called = call.toile("fmt faulty.toile");
  EXPECT_EQ(called.exit_code, 1);
  EXPECT_THAT(called.err, StartsWith("faulty.toile:2:9: error[E0001]"));
  EXPECT_EQ(call.scratch.read("faulty.toile"), "let a=3cm\nlet b = = 4cm\n");
  EXPECT_EQ(call.toile("fmt missing.toile").exit_code, 4);
}

TEST_F(Tooling, FmtKeepsLinksAndPermissions) {
  namespace fs = std::filesystem;
  call.scratch.write("real.toile", "let a=3cm\n");
  fs::permissions(call.scratch / "real.toile", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.toile", call.scratch / "link.toile");
  EXPECT_EQ(call.toile("fmt link.toile").exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(call.scratch / "link.toile"));
  EXPECT_EQ(call.scratch.read("real.toile"), "let a = 3cm\n");
  EXPECT_EQ(fs::status(call.scratch / "real.toile").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Tooling, FmtOfStandardInputGoesToStandardOutput) {
  call.scratch.write("a.toile", "let a=3cm\nlet b=1");
  const Called called = call.toile("fmt -", "", "a.toile");
  EXPECT_EQ(called.exit_code, 0);
  EXPECT_EQ(called.out, "let a = 3cm\nlet b = 1\n");
  EXPECT_THAT(called.err, IsEmpty());
}

TEST_F(Tooling, ExplainSaysWhatACodeMeans) {
  const Called page = call.toile("explain E0201");
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out, StartsWith("# E0201: dimensions that do not agree\n"));
  EXPECT_THAT(page.out, HasSubstr("## Mended"));
  EXPECT_THAT(call.toile("explain").out, HasSubstr("E0201  dimensions that do not agree\n"));
  const Called unknown = call.toile("explain E02O1");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("`E0201`"));
}

TEST_F(Tooling, DocWritesAModulesReference) {
  const Called page = call.toile("doc blocks");
  EXPECT_EQ(page.exit_code, 0) << page.err;
  EXPECT_THAT(page.out, StartsWith("# blocks\n\nBasic blocks:"));
  EXPECT_THAT(page.out, HasSubstr("### `set_in_sleeve(front_scye, back_scye, cap_height, length = 52cm,"));
  EXPECT_THAT(call.toile("doc").out, HasSubstr("blocks\nbodies\nfabrics\n"));
  const Called unknown = call.toile("doc block");
  EXPECT_EQ(unknown.exit_code, 4);
  EXPECT_THAT(unknown.err, HasSubstr("`blocks`"));
}

TEST_F(Tooling, SarifIsOneLogOfAllFindings) {
  call.scratch.write("a b.toile", "let hem = 3cm\nlet hem = 4cm\n");
  call.scratch.write("c.toile", "let girth = 68cm + 3deg\n");
  const Called called = call.toile("check 'a b.toile' c.toile missing.toile --message-format sarif");
  EXPECT_EQ(called.exit_code, 4);
  EXPECT_THAT(called.err, StartsWith("{\n  \"$schema\""));
  for (const char* part : {R"("version": "2.1.0")", R"("ruleId": "E0102")", R"("ruleId": "E0201")",
                           R"("level": "error")", R"("uri": "a%20b.toile")", R"("startLine": 2)",
                           R"("relatedLocations")", R"("executionSuccessful": false)", "cannot read missing.toile"}) {
    EXPECT_THAT(called.err, HasSubstr(part));
  }
  EXPECT_THAT(call.toile("check 'a b.toile' --message-format sarif").err, HasSubstr(R"("executionSuccessful": true)"));
}

TEST_F(Tooling, ImportWritesAScriptThatPassesTheCheck) {
  namespace fs = std::filesystem;
  fs::copy_file(fs::path(TOILE_SOURCE_DIR) / "tests" / "runtime" / "import" / "curves.json",
                call.scratch / "curves.json");
  const Called called = call.toile("import curves.json -o new/curves.toile");
  EXPECT_EQ(called.exit_code, 0);
  EXPECT_EQ(called.err, "2 pieces, 2 seams\nwrote new/curves.toile\n");
  EXPECT_EQ(call.toile("check new/curves.toile").exit_code, 0);
  EXPECT_EQ(call.toile("fmt --check new/curves.toile").exit_code, 0);
}

TEST_F(Tooling, ImportOfWhatIsNoPatternIsAFailureOfTheFile) {
  call.scratch.write("a.json", "{\"pattern\": NaN}");
  const Called called = call.toile("import a.json -o a.toile");
  EXPECT_EQ(called.exit_code, 4);
  EXPECT_THAT(called.err, StartsWith("error: a.json: parse error at line 1, column 13"));
  EXPECT_EQ(call.scratch.files(), 1);
  EXPECT_EQ(call.toile("import a.json").exit_code, 2);
}

TEST_F(Tooling, KesPrintsTheSheetReadBackAndDrawsTheCurves) {
  const Called read = call.toile("kes silk -o silk.svg");
  EXPECT_EQ(read.exit_code, 0) << read.err;
  EXPECT_THAT(read.out, HasSubstr("silk crepe de chine"));
  EXPECT_THAT(read.out, HasSubstr("2HG5  gf/cm"));
  EXPECT_THAT(call.scratch.read("silk.svg"), StartsWith("<svg"));
  const Called misspelt = call.toile("kes slik");
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_THAT(misspelt.err, HasSubstr("did you mean `silk`"));
  call.scratch.write("own.toile", "fabric sack {\n  B 1 gf*cm^2/cm\n  W 30 mg/cm^2\n}\n");
  const Called own = call.toile("kes sack --in own.toile");
  EXPECT_EQ(own.exit_code, 0) << own.err;
  EXPECT_THAT(own.out, HasSubstr("class value"));
  EXPECT_THAT(own.err, HasSubstr("wrote sack.kes.svg"));
  EXPECT_EQ(call.toile("kes sack --in missing.toile").exit_code, 4);
}

}  // namespace
}  // namespace toile
