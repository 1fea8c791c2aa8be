// What is sewn upon a piece starts on its right side, clear of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "compiler/pattern/draft.hpp"
#include "runtime/contact/self_intersections.hpp"
#include "runtime/place/place.hpp"
#include "tests/runtime/body/sample_form.hpp"

namespace toile {
namespace {

DraftPiece polygon(const char* name, const std::vector<Vec2>& corners, const std::vector<const char*>& edges) {
  DraftPiece piece;
  piece.name = name;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    piece.outline.push_back({edges[i], line(corners[i], corners[(i + 1) % corners.size()]), {}});
  }
  return piece;
}

DraftSeam seam(std::vector<DraftEdgeRef> first, std::vector<DraftEdgeRef> second) {
  DraftSeam made;
  made.first = std::move(first);
  made.second = std::move(second);
  return made;
}

/// A tube round the waist, its seam behind.
DraftGarment tube(double width) {
  DraftGarment draft;
  draft.pieces.push_back(
      polygon("skirt", {{0, 0}, {0, -0.45}, {width, -0.45}, {width, 0}}, {"left", "hem", "right", "waist"}));
  draft.seams.push_back(seam({{"skirt", "left", {}, {}}}, {{"skirt", "right", {}, {}}}));
  draft.wears = {{{{"skirt", "waist", {}, {}}}, "waist", true, 0, {}}};
  return draft;
}

DraftGarment with_pocket() {
  DraftGarment draft = tube(1.0);
  const std::vector<Vec2> corners{{0.45, -0.1}, {0.45, -0.25}, {0.52, -0.28}, {0.6, -0.25}, {0.6, -0.1}};
  DraftInner place{"place", {}, {}};
  const std::vector<const char*> names{"left", "low", "foot", "right", "mouth"};
  for (std::size_t i = 0; i < 4; ++i) place.edges.push_back({names[i], line(corners[i], corners[i + 1]), {}});
  draft.pieces[0].lines.push_back(place);
  draft.pieces.push_back(polygon("pocket", corners, names));
  DraftSeam& upon = draft.seams.emplace_back();
  for (std::size_t i = 0; i < 4; ++i) {
    upon.first.push_back({"pocket", names[i], {}, {}});
    upon.second.push_back({"skirt", std::string("place.") + names[i], {}, {}});
  }
  return draft;
}

DraftGarment with_tuck() {
  DraftGarment draft = tube(1.0);
  draft.pieces[0].lines.push_back({"first", {{"a", line({0.48, -0.1}, {0.48, -0.35}), {}}}, {}});
  draft.pieces[0].lines.push_back({"second", {{"a", line({0.52, -0.1}, {0.52, -0.35}), {}}}, {}});
  draft.seams.push_back(seam({{"skirt", "first.a", {}, {}}}, {{"skirt", "second.a", {}, {}}}));
  return draft;
}

struct Put {
  Garment garment;
  SewnMesh mesh;
  Cloth cloth;
  std::vector<Vec3> positions;
};

Put put_on(const DraftGarment& draft, double edge) {
  std::vector<Diagnostic> diagnostics;
  Put put;
  put.garment = make_garment(draft, diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << diagnostics.front().message;
  put.mesh = sew(put.garment, {.target_edge = edge});
  put.cloth = make_cloth(put.mesh);
  const std::shared_ptr<const Body> body = Body::make(body_of(sample_form()), nullptr);
  const std::vector<Worn> worn{{&put.mesh.s.worn[0], "waist", true, 0}};
  put.positions = place(put.mesh, put.cloth, worn, {}, body.get()).positions;
  return put;
}

TEST(SewnUpon, APocketStartsOnTheRightSideClearOfTheCloth) {
  for (const double edge : {0.04, 0.02, 0.01}) {
    const Put put = put_on(with_pocket(), edge);
    EXPECT_EQ(intersecting_triangle_pairs(put.cloth, put.positions), 0) << edge;
    // About the middle the cloth lies nearer to the axis of the form than the pocket does.
    double skirt = 0, pocket = 0;
    for (std::size_t p = 0; p < put.mesh.p.points.size(); ++p) {
      if (distance(put.mesh.p.points[p], {0.525, -0.18}) > 0.04) continue;
      const Vec3 at = put.positions[static_cast<std::size_t>(put.mesh.s.s_of_p[p])];
      double& farthest = put.mesh.p.piece_of_point[p] == 0 ? skirt : pocket;
      farthest = std::max(farthest, norm(Vec3{at.x, at.y, 0}));
    }
    EXPECT_GT(pocket, skirt) << edge;
  }
}

TEST(SewnUpon, ATuckStartsFoldedDoubleOffTheCloth) {
  for (const double edge : {0.04, 0.02, 0.01}) {
    const Put put = put_on(with_tuck(), edge);
    const auto from_axis = [&](std::size_t p) {
      const Vec3 at = put.positions[static_cast<std::size_t>(put.mesh.s.s_of_p[p])];
      return norm(Vec3{at.x, at.y, 0});
    };
    double fold = 0, seam = 0;
    for (std::size_t p = 0; p < put.mesh.p.points.size(); ++p) {
      const Vec2 at = put.mesh.p.points[p];
      if (std::abs(at.y + 0.22) > 0.05) continue;
      if (std::abs(at.x - 0.5) < 1e-6) fold = std::max(fold, from_axis(p));
      if (std::abs(at.x - 0.48) < 1e-6) seam = std::max(seam, from_axis(p));
    }
    EXPECT_NEAR(fold - seam, 0.02, 0.005) << edge;
    // Where it runs out it may start crossed: that comes apart by itself.
    for (const auto& pair : intersecting_triangles(put.cloth, put.positions)) {
      for (const int t : pair) {
        const double y =
            put.mesh.p.points[static_cast<std::size_t>(put.mesh.p.triangles[static_cast<std::size_t>(t)][0])].y;
        EXPECT_TRUE(y > -0.13 || y < -0.32) << edge;
      }
    }
  }
}

}  // namespace
}  // namespace toile
