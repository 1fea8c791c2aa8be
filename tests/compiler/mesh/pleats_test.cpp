// Pleats in the meshes: three layers in the seam, edges along the creases, ties kept.
#include <algorithm>
#include <cmath>

#include "compiler/pattern/draft.hpp"
#include "tests/compiler/mesh/checks.hpp"

namespace toile {
namespace {

DraftPiece drafted_rectangle(const std::string& name, double width, double height) {
  const std::vector<Vec2> corners{{0, 0}, {width, 0}, {width, height}, {0, height}};
  const std::vector<std::string> names{"bottom", "right", "top", "left"};
  DraftPiece piece;
  piece.name = name;
  for (std::size_t i = 0; i < 4; ++i) piece.outline.push_back({names[i], line(corners[i], corners[(i + 1) % 4]), {}});
  return piece;
}

Garment drafted(std::vector<DraftPiece> pieces, const DraftSeam& seam) {
  DraftGarment draft;
  draft.pieces = std::move(pieces);
  draft.seams = {seam};
  std::vector<Diagnostic> diagnostics;
  Garment made = make_garment(draft, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics) ADD_FAILURE() << diagnostic.message;
  return made;
}

DraftSeam drafted_seam(const std::string& a, const std::string& first, const std::string& b,
                       const std::string& second) {
  DraftSeam seam;
  seam.first = {{a, first, {}, {}}};
  seam.second = {{b, second, {}, {}}};
  return seam;
}

Garment pleated_skirt() {
  DraftPiece skirt = drafted_rectangle("skirt", 0.4, 0.3);
  DraftPleat pleat;
  pleat.name = "pleat";
  pleat.place = {"top", 0.15};
  pleat.depth = 0.03;
  skirt.pleats = {pleat};
  return drafted({skirt, drafted_rectangle("band", 0.34, 0.04)}, drafted_seam("skirt", "top", "band", "bottom"));
}

TEST(PleatedMesh, CarriesThreeLayersAndTheBandInTheSeam) {
  const Garment skirt = pleated_skirt();
  const SewnMesh mesh = sew(skirt, {});
  test::expect_cells_agree(skirt, mesh);
  int layered = 0;
  for (const SMesh::Edge& edge : mesh.s.edges) {
    if (edge.wings.size() <= 2) continue;
    ++layered;
    EXPECT_EQ(edge.wings.size(), 4u);
    // Bending acts between the uppermost layer and the band.
    ASSERT_GE(edge.seam, 0);
    EXPECT_FALSE(skirt.seams[edge.seam].is_pleat);
    EXPECT_NE(mesh.p.piece_of_triangle[edge.wings[0].triangle], mesh.p.piece_of_triangle[edge.wings[1].triangle]);
  }
  EXPECT_GE(layered, 2);
  EXPECT_FALSE(mesh.s.topology.manifold);
  EXPECT_EQ(mesh.s.topology.components, 1);
}

TEST(PleatedMesh, HasEdgesAlongItsCreases) {
  const SewnMesh mesh = sew(pleated_skirt(), {});
  test::expect_cells_agree(pleated_skirt(), mesh);
  double ridges = 0, valleys = 0;
  for (const SMesh::Edge& edge : mesh.s.edges) {
    const int a = mesh.s.p_of_s[edge.vertices[0]].front(), b = mesh.s.p_of_s[edge.vertices[1]].front();
    if (edge.crease != 0) (edge.crease > 0 ? ridges : valleys) += distance(mesh.p.points[a], mesh.p.points[b]);
  }
  EXPECT_GT(ridges, 0.25);
  EXPECT_GT(valleys, 0.25);
}

TEST(TiedMesh, HasItsNodesWhereTheTiesAre) {
  DraftSeam seam = drafted_seam("a", "top", "b", "bottom");
  seam.fullness = Seam::Fullness::Gather;
  seam.taken = {{0.1, false}, {0.3, false}};
  const PMesh mesh =
      make_pmesh(drafted({drafted_rectangle("a", 0.6, 0.4), drafted_rectangle("b", 0.5, 0.4)}, seam), {});
  // Along the seam both sides advance alike but for the stretch between 10 and 30 cm.
  double reached = 0, other = 0;
  for (const PMesh::SewnRun& run : mesh.sewn[0]) {
    for (std::size_t i = 0; i + 1 < run.first.size(); ++i) {
      const double a = distance(mesh.points[run.first[i]], mesh.points[run.first[i + 1]]);
      const double b = distance(mesh.points[run.second[i]], mesh.points[run.second[i + 1]]);
      const bool gathered = reached > 0.1 - 1e-9 && reached < 0.3 - 1e-9;
      EXPECT_NEAR(b, gathered ? 0.5 * a : a, 1e-9) << reached;
      reached += a;
      other += b;
    }
  }
  EXPECT_NEAR(reached, 0.6, 1e-9);
  EXPECT_NEAR(other, 0.5, 1e-9);
}

}  // namespace
}  // namespace toile
