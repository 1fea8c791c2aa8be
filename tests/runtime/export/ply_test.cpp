#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "tests/runtime/export/draped_tube.hpp"
#include "tests/runtime/export/read_back.hpp"

namespace toile {
namespace {

/// The vertex records of a PLY file as it is documented: twelve floats and an integer.
struct Record {
  float x, y, z, nx, ny, nz, u, v, strain_warp, strain_weft, strain_shear, pressure;
  std::int32_t sewn_vertex;
};

std::vector<Record> records(const std::string& bytes, std::size_t count) {
  const std::string end = "end_header\n";
  std::vector<Record> all(count);
  std::memcpy(all.data(), bytes.data() + bytes.find(end) + end.size(), count * sizeof(Record));
  return all;
}

TEST(Ply, IsReadBackTriangleByTriangle) {
  const DrapedTube tube = draped_tube(5, 0.2);
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, ply(tube.view()), "ply");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const auto expected = triangles_of(tube.mesh.s.triangles, tube.drape.positions);
  const auto found = triangles_of(*scene);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LT(largest_difference(found, expected), 1e-6);
  EXPECT_TRUE(scene->mMeshes[0]->HasNormals());
  EXPECT_TRUE(scene->mMeshes[0]->HasTextureCoords(0));
}

TEST(Ply, StrainsStayOnTheirSideOfASeam) {
  const DrapedTube tube = draped_tube();
  const auto vertices = records(ply(tube.view()), tube.mesh.p.points.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_FLOAT_EQ(vertices[i].strain_warp, tube.mesh.p.piece_of_point[i] == 0 ? 0.01F : 0.02F);
    EXPECT_FLOAT_EQ(vertices[i].strain_weft, -0.002F);
  }
}

TEST(Ply, PressureIsThatOfTheSewnVertex) {
  const DrapedTube tube = draped_tube();
  for (const Record& vertex : records(ply(tube.view()), tube.mesh.p.points.size())) {
    EXPECT_EQ(vertex.pressure, vertex.sewn_vertex == 0 ? 30.0F : 0.0F);
  }
}

TEST(Ply, CopiesAlongASeamShareTheirSewnVertexPlaceAndNormal) {
  const DrapedTube tube = draped_tube(3, 0.1);
  const auto vertices = records(ply(tube.view()), tube.mesh.p.points.size());
  for (const std::vector<int>& copies : tube.mesh.s.p_of_s) {
    const Record& first = vertices[static_cast<std::size_t>(copies.front())];
    const Record& last = vertices[static_cast<std::size_t>(copies.back())];
    EXPECT_EQ(first.sewn_vertex, last.sewn_vertex);
    EXPECT_EQ(first.x, last.x);
    EXPECT_NEAR(first.nx, last.nx, 1e-6);
  }
}

TEST(Ply, ADrapeThatMeasuredNothingIsWrittenWithZeros) {
  DrapedTube tube = draped_tube();
  tube.drape.strain_warp.clear();
  tube.drape.pressure.clear();
  for (const Record& vertex : records(ply(tube.view()), tube.mesh.p.points.size())) {
    EXPECT_EQ(vertex.strain_warp, 0.0F);
    EXPECT_EQ(vertex.pressure, 0.0F);
  }
}

}  // namespace
}  // namespace toile
