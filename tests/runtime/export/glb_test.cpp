#include <assimp/material.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runtime/export/draped_tube.hpp"
#include "tests/runtime/export/read_back.hpp"

namespace toile {
namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

nlohmann::json json_of(const std::string& bytes) {
  return nlohmann::json::parse(bytes.substr(20, word(bytes, 12)));
}

TEST(Glb, ContainerTellsItsOwnLengths) {
  const std::string bytes = glb(draped_tube().view());
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(bytes, 4), 2U);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::size_t json = word(bytes, 12);
  EXPECT_EQ(json % 4, 0U);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(word(bytes, 20 + json) + json + 28, bytes.size());
  EXPECT_EQ(bytes.substr(24 + json, 4), std::string("BIN\0", 4));
}

TEST(Glb, IsReadBackTriangleByTriangleWithYUp) {
  const DrapedTube tube = draped_tube(5, 0.2);
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, glb(tube.view()), "glb");
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  std::vector<Vec3> turned;
  for (const Vec3& p : tube.drape.positions) turned.push_back({p.x, p.z, -p.y});
  const auto expected = triangles_of(tube.mesh.s.triangles, turned);
  const auto found = triangles_of(*scene);
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LT(largest_difference(found, expected), 1e-6);
}

TEST(Glb, TextureCoordinatesCountRepeatsOfTheTextile) {
  const DrapedTube tube = draped_tube();
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, glb(tube.view()), "glb");
  ASSERT_NE(scene, nullptr);
  const aiMesh& mesh = *scene->mMeshes[0];
  // The front's last point: 20 cm down the warp and 60 cm across; the weft repeats after 2 cm, the warp after 4 cm.
  const aiVector3D uv = mesh.mTextureCoords[0][(kRows + 1) * (kColumns + 1) - 1];
  EXPECT_NEAR(uv.x, 0.20 / 0.02, 1e-4);
  EXPECT_NEAR(1 - uv.y, 0.60 / 0.04, 1e-4);  // the library counts v upwards
}

TEST(Glb, CarriesTheTextileAsAnEmbeddedPictureOnATwoSidedMaterial) {
  Assimp::Importer importer;
  const aiScene* scene = read_back(importer, glb(draped_tube().view()), "glb");
  ASSERT_NE(scene, nullptr);
  ASSERT_EQ(scene->mNumTextures, 1U);
  EXPECT_STREQ(scene->mTextures[0]->achFormatHint, "png");
  int two_sided = 0;
  EXPECT_EQ(scene->mMaterials[0]->Get(AI_MATKEY_TWOSIDED, two_sided), aiReturn_SUCCESS);
  EXPECT_TRUE(two_sided);
}

TEST(Glb, ExtrasNameThePiecesOfTheTriangles) {
  const DrapedTube tube = draped_tube();
  const nlohmann::json pieces = json_of(glb(tube.view()))["meshes"][0]["extras"]["pieces"];
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[1]["name"].get<std::string>(), "back");
  EXPECT_EQ(pieces[1]["first_triangle"].get<std::size_t>(), tube.mesh.p.triangles.size() / 2);
  EXPECT_EQ(pieces[1]["triangles"].get<std::size_t>(), tube.mesh.p.triangles.size() / 2);
}

// Needs node and the package gltf-validator, whose node_modules folder TOILE_GLTF_VALIDATOR names.
TEST(Glb, KhronosValidatorFindsNothing) {
  const auto path = std::filesystem::temp_directory_path() / ("toile_glb_test_" + std::to_string(getpid()) + ".glb");
  std::ofstream(path, std::ios::binary) << glb(draped_tube(5, 0.2).view());
  const std::string command =
      "node '" TOILE_SOURCE_DIR "/tests/runtime/export/validate_glb.mjs' '" + path.string() + "' 1>&2";
  const int status = std::system(command.c_str());
  std::filesystem::remove(path);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == 77 || code == 127) {
    GTEST_SKIP() << "no Khronos validator: npm install gltf-validator, then set TOILE_GLTF_VALIDATOR=.../node_modules";
  }
  EXPECT_EQ(code, 0);
}

}  // namespace
}  // namespace toile
