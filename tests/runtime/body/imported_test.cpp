// Bodies from OBJ files and the lines that planes cut out of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "runtime/body/body.hpp"
#include "runtime/body/manifold.hpp"
#include "runtime/body/wavefront.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

// A block of 0.2 x 0.4 x 1 m standing on the floor, its faces quadrilaterals in all the ways OBJ writes them.
constexpr const char* block =
    "# a block\r\n"
    "o block\n"
    "v -0.1 -0.2 0\nv 0.1 -0.2 0\nv 0.1 0.2 0\nv -0.1 0.2 0\n"
    "v -0.1 -0.2 1\nv 0.1 -0.2 1\nv 0.1 0.2 1\nv -0.1 0.2 1\n"
    "vt 0 0\nvn 0 0 1\n"
    "f 4 3 2 1\nf 5//1 6//1 7//1 8//1\nf 1/1 2/1 6/1 5/1\nf 2/1/1 3/1/1 7/1/1 6/1/1\nf -6 -5 -1 -2\nf 4 1 5 8\n";

std::string fault_of(const std::string& text) {
  Body::Surface surface;
  std::string error;
  if (!read_obj(text, &surface, &error)) return error;
  return manifold_fault(surface);
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("toile_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".obj")) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST(Imported, ReadsFacesOfAllForms) {
  Body::Surface surface;
  std::string error;
  ASSERT_TRUE(read_obj(block, &surface, &error)) << error;
  EXPECT_EQ(surface.points.size(), 8u);
  EXPECT_EQ(surface.triangles.size(), 12u);
  EXPECT_EQ(manifold_fault(surface), "");
  EXPECT_NEAR(signed_volume(surface), 0.08, 1e-12);
}

TEST(Imported, SaysWhereATextIsWrong) {
  EXPECT_EQ(fault_of("v 0 0 0\nv 1 zero 0\n"), "line 2: a vertex needs three coordinates, found 'zero'");
  EXPECT_EQ(fault_of("v 0 0 0\nv 1 0 0\nf 1 2 3\n"), "line 3: there is no vertex 3 yet");
  EXPECT_EQ(fault_of("v 0 0 0\nv 1 0 0\nf 1 2\n"), "line 3: a face needs three different vertices");
  EXPECT_EQ(fault_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n"), "line 4: 'x' is no vertex of a face");
  EXPECT_EQ(fault_of("v 0 0 inf\n"), "line 1: a vertex needs three coordinates, found 'inf'");
  EXPECT_EQ(fault_of(""), "there are no faces");
}

TEST(Imported, OpenOrTwistedSurfacesAreRefused) {
  const std::string text = block;
  const std::string open = text.substr(0, text.rfind("f 4 1 5 8"));
  EXPECT_NE(fault_of(open).find("not closed"), std::string::npos);
  EXPECT_NE(fault_of(open + "f 8 5 1 4\n").find("turn opposite ways"), std::string::npos);
  EXPECT_NE(fault_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").find("no area"), std::string::npos);
}

TEST(Imported, CutsLinesByPlanes) {
  const TemporaryFile file(block);
  MeshSpec mesh{file.path(), {{"middle", 0, 0, 0.5, 0, 0, 1}, {"side", 0.05, 0, 0.5, 1, 0, 0}}};
  std::string error;
  const auto body = Body::make(body_of(mesh), &error);
  ASSERT_TRUE(body) << error;
  const BodyLine* middle = body->line("middle");
  ASSERT_NE(middle, nullptr);
  EXPECT_NEAR(middle->girth, 1.2, 1e-12);
  EXPECT_EQ(middle->axis, (Vec3{0, 0, -1}));
  EXPECT_NEAR(distance(middle->points.front(), {0, -0.2, 0.5}), 0, 1e-12);
  EXPECT_GT(middle->points[1].x, 0.01);
  const BodyLine* side = body->line("side");
  ASSERT_NE(side, nullptr);
  EXPECT_EQ(side->axis, (Vec3{1, 0, 0}));
  EXPECT_NEAR(distance(side->points.front(), {0.05, -0.2, 0.5}), 0, 1e-12);
  EXPECT_GT(side->points[1].z, 0.51);  // an arm's line goes from the front over the top

  mesh.lines.push_back({"above", 0, 0, 1.5, 0, 0, 1});
  EXPECT_FALSE(Body::make(body_of(mesh), &error));
  EXPECT_NE(error.find("line above: its plane misses"), std::string::npos) << error;
  EXPECT_FALSE(Body::make(body_of(MeshSpec{"/nowhere.obj", {}}), &error));
  EXPECT_EQ(error, "/nowhere.obj: cannot be read");
}

TEST(Imported, InsideOutSurfacesAreTurned) {
  std::string text = block, turned;
  Body::Surface surface;
  std::string error;
  ASSERT_TRUE(read_obj(text, &surface, &error));
  for (const Vec3& p : surface.points) {
    turned += "v " + std::to_string(-p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  }
  for (const auto& [a, b, c] : surface.triangles) {
    turned += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  }
  const TemporaryFile file(turned);
  const auto body = Body::make(body_of(MeshSpec{file.path(), {}}), &error);
  ASSERT_TRUE(body) << error;
  EXPECT_NEAR(signed_volume(body->surface()), 0.08, 1e-6);
  EXPECT_LT(body->nearest({0, 0, 0.5}, 0)->distance, -0.09);
}

std::filesystem::path data_directory() {
  const char* given = std::getenv("TOILE_DATA_DIR");
  return given != nullptr ? std::filesystem::path(given)
                          : std::filesystem::path(TOILE_SOURCE_DIR) / ".." / "shared" / "data";
}

// Planes and girths as published beside the mesh (female.landmarks.json).
TEST(Imported, GirthsOfAScannedShape) {
  const std::filesystem::path path = data_directory() / "bodies" / "female.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no data: " << path;
  const MeshSpec mesh{path.string(),
                      {{"neck", 0, -0.01794, 1.33983, 0, -0.178639, 0.983915},
                       {"bust", 0, -0.03955, 1.15974, 0, 0, 1},
                       {"waist", 0, -0.03955, 1.02666, 0, 0, 1},
                       {"hip", 0, -0.03955, 0.8264, 0, 0, 1},
                       {"left_armhole", 0.154, -0.02207, 1.19791, 0.997564, 0, 0.069756},
                       {"left_bicep", 0.2242, -0.02251, 1.1847, 0.675255, -0.01644, -0.737401},
                       {"left_wrist", 0.44985, -0.028, 0.93828, 0.67526, -0.01644, -0.7374},
                       {"right_thigh", -0.11396, -0.01749, 0.72666, 0, 0, 1}}};
  const std::vector<double> girths{0.3653, 0.8591, 0.6531, 0.9316, 0.3863, 0.252, 0.1212, 0.556};
  std::string error;
  const auto body = Body::make(body_of(mesh), &error);
  ASSERT_TRUE(body) << error;
  ASSERT_EQ(body->lines().size(), girths.size());
  for (std::size_t i = 0; i < girths.size(); ++i) {
    EXPECT_NEAR(body->lines()[i].girth, girths[i], 2e-4) << body->lines()[i].name;
  }
  EXPECT_LT(body->line("waist")->axis.z, -0.99);
  EXPECT_GT(body->line("left_armhole")->axis.x, 0.99);
  EXPECT_NEAR(body->line("waist")->points[0].x, 0, 1e-3);
  EXPECT_LT(body->nearest({0, -0.04, 1.1}, 0)->distance, -0.05);
}

}  // namespace
}  // namespace toile
