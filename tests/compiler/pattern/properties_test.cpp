// Whatever is drafted, there is an answer: errors, or a garment that keeps its promises.
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "compiler/pattern/region.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::testing;

// One of 0 … count - 1, whatever size the run has come to.
int pick(int count) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, count));
}

double anywhere(double from, double to) {
  return from + (to - from) * pick(1001) / 1000.0;
}

// Mostly sound: corners of a polygon around a centre, edges that bulge a little, marks about where they fit.
DraftPiece any_piece(const std::string& name) {
  const int corners = 3 + pick(4);
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.2831853 * (i + anywhere(-0.45, 0.45)) / corners;
    points.push_back(anywhere(0.1, 0.5) * direction(angle));
  }
  DraftPiece piece;
  piece.name = name;
  for (int i = 0; i < corners; ++i) {
    const Vec2 from = points[i], to = points[(i + 1) % corners];
    const double bulge = anywhere(-1, 1);
    const Curve curve = std::abs(bulge) < 0.5 ? line(from, to) : arc_of_radius(from, to, distance(from, to) / bulge);
    piece.outline.push_back(edge("e" + std::to_string(i), curve));
  }
  if (pick(2) == 0) {
    std::reverse(piece.outline.begin(), piece.outline.end());
    for (DraftEdge& e : piece.outline) e.curve = e.curve.reversed();
  }
  const int marks = pick(4);
  for (int i = 0; i < marks; ++i) {
    const DraftEdge& host = piece.outline[pick(corners)];
    const double length = host.curve.length();
    piece.darts.push_back(dart("d" + std::to_string(i), host.name, anywhere(-0.1, 1.1) * length,
                               anywhere(0, 0.4) * length, anywhere(0, 0.4)));
    piece.notches.push_back({host.name, anywhere(-0.1, 1.1) * length, next_place()});
  }
  const int kind = pick(4);
  if (kind == 0) return paired(piece);
  if (kind == 1) return folded(piece, "e" + std::to_string(pick(corners)));
  return piece;
}

DraftEdgeRef any_ref() {
  DraftEdgeRef reference{pick(2) == 0 ? "a" : "b", "e" + std::to_string(pick(5)), {}, {}};
  if (pick(5) == 0) reference.side = pick(2) == 0 ? Side::Drawn : Side::Mirrored;
  return reference;
}

std::vector<DraftEdgeRef> any_chain() {
  std::vector<DraftEdgeRef> chain{any_ref()};
  for (int more = pick(3); more > 0; --more) chain.push_back(any_ref());
  return chain;
}

DraftGarment any_garment() {
  DraftGarment draft = garment({any_piece("a"), any_piece("b")});
  for (int i = pick(4); i > 0; --i) {
    DraftSeam seam;
    seam.first = any_chain();
    seam.second = any_chain();
    seam.reversed = pick(4) == 0;
    seam.fullness = Seam::Fullness::Gather;
    draft.seams.push_back(seam);
  }
  if (pick(2) == 0) draft.wears.push_back({any_chain(), "waist", true, 0, {}});
  return draft;
}

TEST(PatternProperties, CutPiecesAreSimpleAndTheirDartsClose) {
  int cut = 0;
  EXPECT_TRUE(rc::check([&] {
    const Made made = make(garment({any_piece("a")}));
    for (const Diagnostic& diagnostic : made.diagnostics) RC_ASSERT(!diagnostic.labels.empty());
    for (const Piece& piece : made.garment.pieces) {
      const Curve outline = whole_outline(piece.edges);
      RC_ASSERT(signed_area(outline) > 0);
      RC_ASSERT(self_crossings(outline).empty());
      for (std::size_t i = 0; i < piece.edges.size(); ++i) {
        const Vec2 next = piece.edges[(i + 1) % piece.edges.size()].curve.start();
        RC_ASSERT(distance(piece.edges[i].curve.end(), next) < 1e-6);
      }
      for (const Dart& d : piece.darts) {
        const Curve &left = piece.edges[d.left_leg].curve, &right = piece.edges[d.right_leg].curve;
        RC_ASSERT(std::abs(left.length() - right.length()) < 1e-9);
        RC_ASSERT(distance(left.end(), d.tip) < 1e-9 && distance(right.start(), d.tip) < 1e-9);
        RC_ASSERT(piece.edges[d.left_leg].name == d.name + ".left");
      }
      for (const Notch& n : piece.notches) {
        RC_ASSERT(n.at >= -1e-9 && n.at <= piece.edges[n.edge].curve.length() + 1e-9);
      }
      ++cut;
    }
  }));
  EXPECT_GT(cut, 20);  // the generator must not only make mistakes
}

TEST(PatternProperties, SoundGarmentsUseEachEdgeInOneSeam) {
  int sound = 0;
  EXPECT_TRUE(rc::check([&] {
    const Made made = make(any_garment());
    if (!made.diagnostics.empty()) return;
    ++sound;
    std::vector<std::vector<int>> uses;
    for (const Piece& piece : made.garment.pieces) uses.emplace_back(piece.edges.size(), 0);
    for (const Seam& seam : made.garment.seams) {
      RC_ASSERT(!seam.first.empty() && !seam.second.empty());
      for (const ChainLink& link : seam.first) ++uses[link.edge.piece][link.edge.edge];
      if (seam.first.front().edge == seam.second.back().edge) continue;  // closed like a purse
      for (const ChainLink& link : seam.second) ++uses[link.edge.piece][link.edge.edge];
    }
    for (const auto& piece : uses) {
      for (const int count : piece) RC_ASSERT(count <= 1);
    }
  }));
  EXPECT_GT(sound, 1);
}

}  // namespace
}  // namespace toile
