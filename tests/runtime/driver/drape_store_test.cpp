// Drapes kept for `--warm`: what comes back, what is refused, what is thrown out.
#include "runtime/driver/drape_store.hpp"

#include <gtest/gtest.h>

#include "tests/runtime/driver/scratch.hpp"

namespace toile {
namespace {

KeptDrape two_triangles() {
  KeptDrape kept;
  kept.pieces = {"front", "back"};
  kept.points = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}};
  kept.triangles = {{0, 1, 2}, {3, 4, 5}};
  kept.piece_of_triangle = {0, 1};
  kept.s_vertices = {{0, 1, 2}, {0, 1, 3}};
  kept.positions = {{0, 0, 1}, {1, 0, 1.25}, {0, 1, 1}, {0, -1, 1}};
  return kept;
}

TEST(KeptDrape, ComesBackFromItsBytes) {
  const KeptDrape kept = two_triangles();
  const std::optional<KeptDrape> back = from_bytes(to_bytes(kept));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->pieces, kept.pieces);
  EXPECT_EQ(back->triangles, kept.triangles);
  EXPECT_EQ(back->s_vertices, kept.s_vertices);
  EXPECT_EQ(back->piece_of_triangle, kept.piece_of_triangle);
  EXPECT_EQ(back->points[1].x, 1);
  EXPECT_EQ(back->positions[1].z, 1.25);
}

TEST(KeptDrape, DamagedBytesAreRefused) {
  const std::string bytes = to_bytes(two_triangles());
  EXPECT_FALSE(from_bytes(""));
  for (std::size_t cut = 0; cut < bytes.size(); cut += 7) EXPECT_FALSE(from_bytes(bytes.substr(0, cut))) << cut;
  for (std::size_t at = 0; at < bytes.size(); at += 5) {
    std::string other = bytes;
    other[at] = static_cast<char>(other[at] ^ 0x10);
    EXPECT_FALSE(from_bytes(other)) << at;
  }
}

TEST(DrapeStore, FindsWhatWasKeptUnderTheKey) {
  const Scratch scratch{"store"};
  const DrapeStore store(scratch / "not" / "there");
  EXPECT_FALSE(store.find("skirt"));
  store.keep("skirt", two_triangles());
  EXPECT_TRUE(store.find("skirt"));
  EXPECT_FALSE(store.find("cape"));
}

TEST(DrapeStore, ForgetsWhatWasUsedLongestAgoWhenItIsFull) {
  const Scratch scratch{"full"};
  const std::uintmax_t one = to_bytes(two_triangles()).size();
  const DrapeStore store(scratch.path(), 2 * one + one / 2);
  store.keep("first", two_triangles());
  store.keep("second", two_triangles());
  const auto now = std::filesystem::file_time_type::clock::now();
  for (const auto& file : std::filesystem::directory_iterator(scratch.path())) {
    std::filesystem::last_write_time(file.path(), now - std::chrono::hours(1));
  }
  ASSERT_TRUE(store.find("first"));  // used just now
  store.keep("third", two_triangles());
  EXPECT_TRUE(store.find("first"));
  EXPECT_FALSE(store.find("second"));
  EXPECT_TRUE(store.find("third"));
}

}  // namespace
}  // namespace toile
