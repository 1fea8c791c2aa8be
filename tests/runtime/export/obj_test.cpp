#include <gtest/gtest.h>

#include <sstream>

#include "tests/runtime/export/draped_tube.hpp"
#include "tests/runtime/export/read_back.hpp"

namespace toile {
namespace {

int lines_starting(const std::string& text, const std::string& start) {
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with(start) ? 1 : 0;
  return count;
}

TEST(Obj, HasAVertexForEachSewnVertexAndTextureCoordinatesForEachPoint) {
  const DrapedTube tube = draped_tube();
  const std::string text = obj(tube.view());
  EXPECT_EQ(lines_starting(text, "v "), tube.mesh.s.vertex_count);
  EXPECT_EQ(lines_starting(text, "vt "), static_cast<int>(tube.mesh.p.points.size()));
  EXPECT_EQ(lines_starting(text, "f "), static_cast<int>(tube.mesh.p.triangles.size()));
}

TEST(Obj, IsReadBackTriangleByTriangle) {
  const DrapedTube tube = draped_tube(5, 0.2);
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, obj(tube.view()), "obj");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const auto expected = triangles_of(tube.mesh.s.triangles, tube.drape.positions);
  const auto found = triangles_of(*scene);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LT(largest_difference(found, expected), 1e-6);
}

TEST(Obj, GroupsAreThePieces) {
  const DrapedTube tube = draped_tube();
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, obj(tube.view()), "obj");
  ASSERT_NE(scene, nullptr);
  ASSERT_EQ(scene->mNumMeshes, 2U);
  EXPECT_STREQ(scene->mMeshes[0]->mName.C_Str(), "front");
  EXPECT_STREQ(scene->mMeshes[1]->mName.C_Str(), "back");
  EXPECT_EQ(scene->mMeshes[0]->mNumFaces, tube.mesh.p.triangles.size() / 2);
}

TEST(Obj, TextureCoordinatesAreWarpAndWeftInMetres) {
  const DrapedTube tube = draped_tube();
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, obj(tube.view()), "obj");
  ASSERT_NE(scene, nullptr);
  const aiMesh& front = *scene->mMeshes[0];
  ASSERT_TRUE(front.HasTextureCoords(0));
  // The first triangle's first corner is the left end of the second row: 5 cm down the warp.
  const aiVector3D uv = front.mTextureCoords[0][front.mFaces[0].mIndices[0]];
  EXPECT_NEAR(uv.x, 0.05, 1e-6);
  EXPECT_NEAR(uv.y, 0.0, 1e-6);
}

TEST(Obj, NormalsPointOutOfTheTube) {
  const DrapedTube tube = draped_tube();
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, obj(tube.view()), "obj");
  ASSERT_NE(scene, nullptr);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    ASSERT_TRUE(mesh.HasNormals());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = mesh.mVertices[i];
      const aiVector3D outward = aiVector3D(p.x, p.y, 0).Normalize();
      EXPECT_GT(outward * mesh.mNormals[i], 0.99F);
    }
  }
}

TEST(Obj, NamesAreKeptToOneWord) {
  DrapedTube tube = draped_tube();
  tube.garment.pieces[0].name = "left front";
  EXPECT_NE(obj(tube.view()).find("\ng left_front\n"), std::string::npos);
}

}  // namespace
}  // namespace toile
