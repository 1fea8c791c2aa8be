#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/runtime/export/draped_tube.hpp"

namespace toile {
namespace {

nlohmann::json read(const DrapedTube& tube) {
  return nlohmann::json::parse(mesh_json(tube.garment, tube.mesh));
}

TEST(MeshJson, CarriesThePointsExactly) {
  const DrapedTube tube = draped_tube();
  const nlohmann::json points = read(tube)["p_mesh"]["points_m"];
  ASSERT_EQ(points.size(), tube.mesh.p.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i][0].get<double>(), tube.mesh.p.points[i].x);
    EXPECT_EQ(points[i][1].get<double>(), tube.mesh.p.points[i].y);
  }
}

TEST(MeshJson, PiecesAreRangesOfPointsAndTriangles) {
  const nlohmann::json back = read(draped_tube())["pieces"][1];
  EXPECT_EQ(back["name"].get<std::string>(), "back");
  EXPECT_EQ(back["first_point"].get<int>(), (kRows + 1) * (kColumns + 1));
  EXPECT_EQ(back["points"].get<int>(), (kRows + 1) * (kColumns + 1));
  EXPECT_EQ(back["first_triangle"].get<int>(), 2 * kRows * kColumns);
  EXPECT_EQ(back["triangles"].get<int>(), 2 * kRows * kColumns);
  EXPECT_EQ(back["warp"].get<std::vector<double>>(), (std::vector<double>{0.0, -1.0}));
}

TEST(MeshJson, SewnMeshCanBeRebuilt) {
  const DrapedTube tube = draped_tube();
  const nlohmann::json sewn = read(tube)["s_mesh"];
  EXPECT_EQ(sewn["vertices"].get<int>(), tube.mesh.s.vertex_count);
  EXPECT_EQ(sewn["vertex_of_point"].get<std::vector<int>>(), tube.mesh.s.s_of_p);
  EXPECT_EQ((sewn["triangles"].get<std::vector<std::array<int, 3>>>()), tube.mesh.s.triangles);
  ASSERT_EQ(sewn["edges"].size(), tube.mesh.s.edges.size());
  EXPECT_EQ(sewn["edges"][0]["vertices"][0].get<int>(), tube.mesh.s.edges[0].vertices[0]);
  EXPECT_EQ(sewn["edges"][0]["triangles"].size(), tube.mesh.s.edges[0].wings.size());
  EXPECT_EQ(sewn["topology"]["euler"].get<int>(), 0);
  EXPECT_EQ(sewn["worn"][0]["line"].get<std::string>(), "waist");
  EXPECT_EQ(sewn["worn"][0]["vertices"].size(), 2U * kColumns);
}

TEST(MeshJson, SameMeshSameBytes) {
  EXPECT_EQ(mesh_json(draped_tube().garment, draped_tube().mesh), mesh_json(draped_tube().garment, draped_tube().mesh));
}

}  // namespace
}  // namespace toile
