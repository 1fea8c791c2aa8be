// Whatever is drafted, there is an answer: errors, or a garment that keeps its promises.
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "compiler/pattern/region.hpp"
#include "tests/compiler/pattern/any_piece.hpp"
#include "tests/compiler/pattern/drafting.hpp"

namespace toile {
namespace {

using namespace toile::test;

// A sound piece with the edges bottom, right, top and left, in one copy or two.
DraftPiece any_quadrilateral(const std::string& name) {
  DraftPiece piece =
      polygon(name, {{0, 0}, {anywhere(0.2, 0.5), 0}, {anywhere(0.2, 0.5), anywhere(0.2, 0.5)}, {0, 0.3}},
              {"bottom", "right", "top", "left"});
  if (pick(3) == 0) piece.darts = {dart("d", "top", 0.1, 0.02, 0.04)};
  const int kind = pick(3);
  return kind == 0 ? paired(piece) : kind == 1 ? folded(piece, "left") : piece;
}

std::vector<DraftEdgeRef> any_chain() {
  const auto any_ref = [] {
    return edge_ref((pick(2) == 0 ? "a." : "b.") + std::vector<std::string>{"bottom", "right", "top"}[pick(3)]);
  };
  std::vector<DraftEdgeRef> chain{any_ref()};
  if (pick(3) == 0) chain.push_back(any_ref());
  return chain;
}

DraftGarment any_garment() {
  DraftGarment draft = garment({any_quadrilateral("a"), any_quadrilateral("b")});
  for (int i = 1 + pick(2); i > 0; --i) {
    DraftSeam seam = sew({}, {}, pick(4) == 0);
    seam.first = any_chain();
    seam.second = any_chain();
    seam.fullness = Seam::Fullness::Gather;
    draft.seams.push_back(seam);
  }
  if (pick(2) == 0) draft.wears.push_back({any_chain(), "waist", true, 0, next_place()});
  return draft;
}

// How often the seam takes up each edge; a line sewn to itself like a purse takes its edges once.
void count_uses(const Seam& seam, std::map<std::pair<int, int>, int>& uses) {
  const auto edges = [](const Chain& chain) {
    std::set<std::pair<int, int>> found;
    for (const ChainLink& link : chain) found.insert({link.edge.piece, link.edge.edge});
    return found;
  };
  for (const ChainLink& link : seam.first) ++uses[{link.edge.piece, link.edge.edge}];
  if (edges(seam.first) == edges(seam.second)) return;
  for (const ChainLink& link : seam.second) ++uses[{link.edge.piece, link.edge.edge}];
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

TEST(PatternProperties, AreasAndLengthsAreThoseOfThePieceTurnedAndMoved) {
  int compared = 0;
  EXPECT_TRUE(rc::check([&] {
    const DraftPiece still = any_piece("a");
    const double angle = anywhere(-3, 3);
    const Vec2 shift{anywhere(-2, 2), anywhere(-2, 2)};
    DraftPiece turned = still;
    for (DraftEdge& each : turned.outline) each.curve = each.curve.rotated(angle, {0, 0}).moved(shift);
    const Made one = make(garment({still})), other = make(garment({turned}));
    RC_ASSERT(codes(one) == codes(other));
    for (std::size_t i = 0; i < one.garment.pieces.size(); ++i) {
      const Piece &a = one.garment.pieces[i], &b = other.garment.pieces[i];
      RC_ASSERT(std::abs(signed_area(whole_outline(a.edges)) - signed_area(whole_outline(b.edges))) < 1e-10);
      RC_ASSERT(a.edges.size() == b.edges.size());
      for (std::size_t k = 0; k < a.edges.size(); ++k) {
        RC_ASSERT(std::abs(a.edges[k].curve.length() - b.edges[k].curve.length()) < 1e-9);
      }
      ++compared;
    }
  }));
  EXPECT_GT(compared, 20);
}

TEST(PatternProperties, AnEdgeSewnTwiceIsAlwaysReportedAndNoOther) {
  int sound = 0, reported = 0;
  EXPECT_TRUE(rc::check([&] {
    const Made made = make(any_garment());
    const std::vector<std::string> found = codes(made);
    const auto has = [&](const char* code) { return std::find(found.begin(), found.end(), code) != found.end(); };
    if (has("E0321")) return;
    std::map<std::pair<int, int>, int> uses;
    for (const Seam& seam : made.garment.seams) count_uses(seam, uses);
    const bool twice = std::any_of(uses.begin(), uses.end(), [](const auto& use) { return use.second > 1; });
    RC_ASSERT(has("E0317") == twice);
    sound += found.empty();
    reported += twice;
  }));
  EXPECT_GT(sound, 5);
  EXPECT_GT(reported, 5);
}

TEST(PatternProperties, AWornLineTakesEveryPartOfItsEdgesOnce) {
  int lines = 0;
  EXPECT_TRUE(rc::check([&] {
    DraftGarment draft = any_garment();
    draft.seams = {sew({"a.right"}, {"b.right"})};
    draft.seams[0].fullness = Seam::Fullness::Gather;
    draft.wears = {wear({"a.top", "b.top"}, "waist")};
    const Made made = make(draft);
    if (!made.diagnostics.empty()) return;
    // Every copy and every part of the named edges is walked, and none twice.
    const auto& chain = made.garment.wears[0].chain;
    RC_ASSERT(chain.size() >= 2u);
    std::set<std::pair<int, int>> walked;
    for (const ChainLink& link : chain) {
      RC_ASSERT(walked.insert({link.edge.piece, link.edge.edge}).second);
      RC_ASSERT(made.garment.pieces[link.edge.piece].edges[link.edge.edge].name == "top");
    }
    std::size_t tops = 0;
    for (const Piece& piece : made.garment.pieces) {
      for (const PieceEdge& e : piece.edges) tops += e.name == "top";
    }
    RC_ASSERT(walked.size() == tops);
    ++lines;
  }));
  EXPECT_GT(lines, 5);
}

}  // namespace
}  // namespace toile
