#include "runtime/driver/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

using testing::Eq;
using testing::HasSubstr;
using testing::Optional;

TEST(Files, AreWrittenWithTheirFoldersAndReadBack) {
  const Scratch scratch("files");
  const std::string bytes("a\0b\r\n\xff", 6);
  std::string error;
  ASSERT_TRUE(write_file(scratch / "some/where/f.bin", bytes, error)) << error;
  EXPECT_THAT(read_file(scratch / "some/where/f.bin", error), Optional(Eq(bytes)));
}

TEST(Files, LeaveNoTemporaryNamesBehind) {
  const Scratch scratch("files");
  std::string error;
  ASSERT_TRUE(write_file(scratch / "f", "one", error));
  ASSERT_TRUE(write_file(scratch / "f", "two", error));
  EXPECT_EQ(scratch.read("f"), "two");
  EXPECT_EQ(scratch.files(), 1);
}

TEST(Files, ThatCannotBeWrittenSayWhyAndLeaveNothing) {
  const Scratch scratch("files");
  scratch.write("folder/inside", "kept");
  std::string error;
  EXPECT_FALSE(write_file(scratch / "folder", "bytes", error)) << "a folder of that name stands there";
  EXPECT_THAT(error, HasSubstr("cannot write"));
  EXPECT_FALSE(write_file(scratch / "folder/inside/below", "bytes", error)) << "a file stands where a folder is needed";
  EXPECT_THAT(error, HasSubstr("folder"));
  EXPECT_EQ(scratch.read("folder/inside"), "kept");
  EXPECT_EQ(scratch.files(), 1);
}

TEST(Files, ThatAreMissingOrFoldersSaySo) {
  const Scratch scratch("files");
  std::string error;
  EXPECT_EQ(read_file(scratch / "nothing", error), std::nullopt);
  EXPECT_THAT(error, HasSubstr("No such file"));
  EXPECT_EQ(read_file(scratch.path(), error), std::nullopt);
  EXPECT_THAT(error, HasSubstr("is a folder"));
}

TEST(PathsBelow, StayInTheirFolder) {
  EXPECT_THAT(below("out", "skirt.png"), Optional(Eq("out/skirt.png")));
  EXPECT_THAT(below("out", "a/../b/skirt.png"), Optional(Eq("out/b/skirt.png")));
  for (const char* path : {"", ".", "..", "../skirt.png", "a/../../skirt.png", "/tmp/skirt.png", "a/"}) {
    EXPECT_EQ(below("out", path), std::nullopt) << path;
  }
}

}  // namespace
}  // namespace toile
