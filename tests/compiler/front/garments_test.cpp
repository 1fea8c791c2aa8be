// Pieces walked edge by edge, variations, seams and worn lines.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// A garment of one piece `p`, whose braces hold `lines`.
std::string with_piece(const std::string& lines, const std::string& rest = "") {
  return "garment g {\n  piece p {\n" + lines + "  }\n" + rest + "}\n";
}

const std::string square =
    "    outline from (0cm, 0cm) {\n      south = line to (10cm, 0cm)\n      east = line to (10cm, 10cm)\n"
    "      north = line to (0cm, 10cm)\n      west = line to start\n    }\n";

TEST(Walks, EveryKindOfEdge) {
  Script script("let hull = curve((20cm, 10cm), (10cm, 20cm), arriving: 180deg)\n" +
                with_piece("    outline from (0cm, 0cm) {\n"
                           "      a = curve to (10cm, 0cm) leaving 20deg\n"
                           "      b = arc to (20cm, 10cm) through (18cm, 2cm)\n"
                           "      c = along hull\n"
                           "      d = bezier to (0cm, 20cm) via (8cm, 21cm), (3cm, 21cm)\n"
                           "      e = arc to (0cm, 10cm) radius 30cm\n"
                           "      f = curve to start\n"
                           "    }\n"
                           "    hole eye from (12cm, 10cm) {\n      rim = circle about (10cm, 10cm)\n    }\n") +
                "print length(g.p.f), g.p.a.end, length(g.p.a)\n");
  ASSERT_THAT(script.told(), IsEmpty()) << script.rendered();
  // A single direction bends the edge like a circular arc: 10 cm * 20deg / sin(20deg) = 10.2060 cm.
  EXPECT_THAT(script.printed(), ElementsAre("10 cm (10 cm, 0 cm) 10.206 cm"));
  EXPECT_THAT(script.program->garments().at(0).pieces.at(0).holes, SizeIs(1));
}

TEST(Walks, EdgesAreCurvesForLaterLines) {
  Script script(with_piece("    let half = length(south) / 2\n" + square + "    notch at half of south\n") +
                "print g.p.half\n");
  EXPECT_THAT(script.told(), IsEmpty());
  EXPECT_THAT(script.printed(), ElementsAre("5 cm"));
  EXPECT_DOUBLE_EQ(script.program->garments().at(0).pieces.at(0).notches.at(0).at, 0.05);
}

TEST(Garments, APieceMayBeOfAnotherClothAndOfSeveralPlies) {
  const Script script("import fabrics\ngarment g in fabrics.denim {\n  piece p {\n" + square +
                      "    cut 2 in fabrics.silk plies 3\n  }\n  piece q {\n" + square +
                      "    cut 1\n  }\n  piece r {\n" + square +
                      "    cut 2 plies 2\n  }\n  sew p.south to q.south\n  sew q.east to r.east\n}\n");
  ASSERT_THAT(script.told(), IsEmpty()) << script.rendered();
  const Garment& garment = script.program->garments().at(0);
  EXPECT_THAT(garment.fabric_of_pieces(), ElementsAre(1, 0, 2));
  const std::vector<FabricSheet> fabrics = garment.fabrics();
  ASSERT_THAT(fabrics, SizeIs(3));
  EXPECT_EQ(fabrics[0].name, "denim");
  EXPECT_EQ(fabrics[1].name, "silk");
  EXPECT_EQ(fabrics[1].plies, 3);
  EXPECT_EQ(fabrics[2].name, "denim");
  EXPECT_EQ(fabrics[2].plies, 2);
  EXPECT_EQ(garment.pieces.at(0).own_cloth(), "silk, 3 plies");
  EXPECT_EQ(garment.pieces.at(1).own_cloth(), "");
}

TEST(Garments, WrongClothsOfPieces) {
  const auto told = [](const std::string& cut) { return Script(with_piece(square + "    cut " + cut + "\n")).told(); };
  EXPECT_THAT(told("2 in 5cm"), ElementsAre(AllOf(StartsWith("E0202 9:14"), HasSubstr("a fabric is wanted"))));
  EXPECT_THAT(told("2 plies 0"), ElementsAre(StartsWith("E0208 9:17")));
  EXPECT_THAT(told("2 plies 1.5"), ElementsAre(AllOf(StartsWith("E0209 9:17"), HasSubstr("number of plies"))));
  EXPECT_THAT(told("2 in silkk"), ElementsAre(StartsWith("E0101 9:14")));
}

TEST(Garments, ForMakesSeveralDetails) {
  const std::string repeated =
      "    for i in 1..4 if i != 3 {\n      notch at i * 2cm of south\n    }\n"
      "    for w in [1cm, 2cm] {\n      dart tuck at w * 3 of north { width w, depth 2cm }\n    }\n";
  const Script script(with_piece(square + repeated));
  ASSERT_THAT(script.told(), IsEmpty());
  const auto& piece = script.program->garments().at(0).pieces.at(0);
  ASSERT_EQ(piece.notches.size(), 3u);
  EXPECT_DOUBLE_EQ(piece.notches.at(2).at, 0.08);
  const std::string pattern = emit_pattern(*script.program);
  EXPECT_THAT(pattern, AllOf(HasSubstr("dart tuck1 "), HasSubstr("dart tuck2 ")));
}

TEST(Garments, ForTellsWhatIsWrong) {
  const auto told = [](const std::string& values) {
    return Script(with_piece(square + "    for i in " + values + " {\n      notch at i * 6cm of south\n    }\n"))
        .told();
  };
  EXPECT_THAT(told("1..0"), IsEmpty());
  EXPECT_THAT(told("1..2"), ElementsAre(StartsWith("E0209")));
  EXPECT_THAT(told("7"), ElementsAre(StartsWith("E0202")));
  EXPECT_THAT(told("1..1.5"), ElementsAre(StartsWith("E0202")));
}

TEST(Walks, AnEdgeYieldsToAMeasureOfItsName) {
  const Script script("let south = 10cm\n" +
                      with_piece("    let whole = length(south) + south\n    outline from (0cm, 0cm) {\n"
                                 "      south = line to (south, 0cm)\n      rest = line to (south, 10cm)\n"
                                 "      back = line to start\n    }\n"));
  EXPECT_THAT(script.told(), IsEmpty()) << script.rendered();
}

TEST(Walks, CurvesThatCannotBeDrawn) {
  const Script script(with_piece(
      "    outline from (0cm, 0cm) {\n      a = arc to (10cm, 0cm) through (5cm, 0cm)\n      b = line to start\n    "
      "}\n",
      "  piece q {\n    outline from (0cm, 0cm) {\n      a = arc to (10cm, 0cm) radius 3cm\n      b = line to start\n"
      "    }\n  }\n"
      "  piece r {\n    outline from (0cm, 0cm) {\n      a = along line((1cm, 0cm), (2cm, 0cm))\n      b = line to "
      "3cm\n"
      "    }\n  }\n"));
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0209 4:38"), HasSubstr("on a line")),
                                         AllOf(StartsWith("E0209 10:37"), HasSubstr("does not span")),
                                         AllOf(StartsWith("E0209 16:17"), HasSubstr("1 cm away from the pen"))));
}

TEST(Pieces, FoldGrainCutAndAllowance) {
  const Script script(
      with_piece(square + "    cut 2 mirrored\n    grain bias\n    allowance 1cm, north 4cm\n    label \"Pocket\"\n",
                 "  sew p.east to p.east\n"));
  ASSERT_THAT(script.told(), IsEmpty()) << script.rendered();
  const Garment& garment = script.program->garments().at(0);
  ASSERT_THAT(garment.pieces, SizeIs(2));
  EXPECT_NEAR(garment.pieces[0].warp.x, std::sqrt(0.5), 1e-12);
  double widest = 0;
  for (const PieceEdge& edge : garment.pieces[0].edges) widest = std::max(widest, edge.allowance);
  EXPECT_DOUBLE_EQ(widest, 0.04);
}

TEST(Pieces, WhatIsSaidOfThemIsChecked) {
  const Script script(with_piece(square + "    fold wets\n"
                                          "    notch at 12cm of south\n"
                                          "    notch at 120% of south\n"
                                          "    dart at 50% of north { width -1cm, deep 3cm }\n"
                                          "    cut 3 mirrored\n"
                                          "    grain 3cm\n"
                                          "    allowance -1cm, hem 2cm\n"));
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0308 9:10"), HasSubstr("no edge `wets`")),
                          AllOf(StartsWith("E0209 10:14"), HasSubstr("12 cm is beyond")), StartsWith("E0209 11:14"),
                          StartsWith("E0208 12:34"), StartsWith("E0103 12:40"), StartsWith("E0209 13:5"),
                          StartsWith("E0201 14:11"), StartsWith("E0208 15:15"), StartsWith("E0308 15:21")));
  EXPECT_THAT(script.rendered(), HasSubstr("did you mean `west`?"));
}

TEST(Pieces, VariationsReplaceByName) {
  Script script(
      "garment g {\n  piece front {\n    let w = 10cm\n    let h = 2 * w\n    outline from (0cm, 0cm) {\n"
      "      waist = line to (w, 0cm)\n      side = line to (w, -h)\n      hem = line to (0cm, -h)\n"
      "      centre = line to start\n    }\n    fold centre\n"
      "    dart at 50% of waist { width 1cm, depth 3cm }\n  }\n"
      "  piece back = front with {\n    let w = 12cm\n    let h = 20cm\n"
      "    outline {\n      waist = curve to (w, 1cm) leaving 0deg\n    }\n"
      "    dart at 40% of waist { width 2cm, depth 4cm }\n  }\n  sew front.side to back.side stretch\n}\n"
      "print length(g.back.hem), length(g.back.side), length(g.front.side)\n");
  ASSERT_THAT(script.told(), IsEmpty()) << script.rendered();
  EXPECT_THAT(script.printed(), ElementsAre("12 cm 21 cm 20 cm"));
  EXPECT_THAT(script.program->garments().at(0).pieces.at(1).darts, SizeIs(2));  // both halves
  EXPECT_NEAR(script.program->garments().at(0).pieces.at(1).darts.at(0).width, 0.02, 1e-5);
}

TEST(Pieces, VariationsOfNothingAndOfThemselves) {
  const Script script(
      "garment g {\n  piece a = b with {\n  }\n  piece b = a with {\n  }\n  piece c = d with {\n    fold x\n  }\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0106 4:13")), AllOf(StartsWith("E0101 6:13"))));
}

TEST(Sewing, UnknownPiecesEdgesAndSides) {
  const Script script(with_piece(square,
                                 "  sew p.esat to q.west\n"
                                 "  sew p.north.mirored to p.south\n"
                                 "  wear p.north at 3cm\n"));
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0308 10:9"), HasSubstr("no edge `esat`")),
                                         AllOf(StartsWith("E0309 10:17"), HasSubstr("no piece `q`")),
                                         StartsWith("E0103 11:15"), StartsWith("E0201 12:19")));
}

TEST(Sewing, LengthsThatDiffer) {
  const std::string pieces =
      "    outline from (0cm, 0cm) {\n      a = line to (10cm, 0cm)\n      b = line to (10cm, 10cm)\n"
      "      c = line to (2cm, 10cm)\n      d = line to start\n    }\n";
  EXPECT_THAT(Script(with_piece(pieces, "  sew p.a to p.c\n")).told(),
              ElementsAre(AllOf(StartsWith("E0316 10:7"), HasSubstr("2 cm"))));
  EXPECT_THAT(Script(with_piece(pieces, "  sew p.a to p.c ease 2cm\n")).told(), IsEmpty());
  EXPECT_THAT(Script(with_piece(pieces, "  sew p.a to p.c ease 1cm\n")).told(), ElementsAre(StartsWith("E0316 10:7")));
}

TEST(Sewing, GeometryIsCheckedOnSoundGarmentsOfTheSameScript) {
  const Script script(with_piece("    outline from (0cm, 0cm) {\n      a = line to (x, 0cm)\n    }\n") +
                      "garment h {\n  piece q {\n    outline from (0cm, 0cm) {\n      a = line to (10cm, 0cm)\n"
                      "      b = line to (10cm, 5cm)\n    }\n  }\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0101 4:20"), StartsWith("E0301 12:7")));
}

const std::string holed = square +
                          "    hole eye from (5cm, 3cm) {\n      right = arc to (5cm, 7cm) radius 2cm\n"
                          "      left = arc to start radius 2cm\n    }\n";

TEST(Holes, AreSewnAndWornByTheirNames) {
  const Script script("body ball = sphere(radius: 10cm)\n" +
                      with_piece(holed, "  sew p.eye.left to p.eye.right.drawn reversed\n  allow W0337\n"));
  EXPECT_THAT(script.told(), IsEmpty()) << script.rendered();
  const Garment& garment = script.program->garments().at(0);
  ASSERT_THAT(garment.seams, SizeIs(1));
  EXPECT_EQ(garment.seams[0].name, "p.eye.left to p.eye.right");
}

TEST(Holes, AreCurvesForLaterLines) {
  Script script(with_piece(holed + "    let rim = length(eye.left) + length(eye.right)\n") +
                "print g.p.rim, g.p.eye.left.start, g.p.eye\n");
  EXPECT_THAT(script.told(), IsEmpty()) << script.rendered();
  EXPECT_THAT(script.printed(), ElementsAre("12.5664 cm (5 cm, 7 cm) hole eye"));
}

TEST(Holes, OfAVariationReplaceThoseOfTheirName) {
  const Script script("garment g {\n  piece p {\n" + holed +
                      "  }\n  piece q = p with {\n    hole eye from (5cm, 4cm) {\n"
                      "      rim = circle about (5cm, 5cm)\n    }\n"
                      "    hole other from (1cm, 1cm) {\n      rim = circle about (1.5cm, 1cm)\n    }\n  }\n"
                      "  sew p.west to q.west\n}\n");
  EXPECT_THAT(script.told(), IsEmpty()) << script.rendered();
  EXPECT_THAT(script.program->garments().at(0).pieces.at(1).holes, SizeIs(2));
  EXPECT_THAT(script.program->garments().at(0).pieces.at(1).holes[0], SizeIs(1));
}

TEST(Holes, AreNamedAloneForAllTheirEdges) {
  const Script script(with_piece(holed, "  sew p.eye to p.east + p.north ease 20cm\n"));
  EXPECT_THAT(script.told(), IsEmpty()) << script.rendered();
  EXPECT_THAT(script.program->garments().at(0).seams.at(0).first, SizeIs(2));
}

TEST(Pieces, SayNothingTwice) {
  const Script script(with_piece(square + "    grain down\n    allowance 1cm, south 2cm, south 3cm\n    grain up\n"
                                          "    label \"a\"\n    label \"b\"\n    cut 2\n    cut 4\n"));
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0102 10:31"), StartsWith("E0102 11:5"), StartsWith("E0102 13:5"),
                                         StartsWith("E0102 15:5")));
}

TEST(Notches, WithANameArePlacesOfASeam) {
  const Script script(with_piece(square + "    notch low at 2cm of east\n    notch high at 80% of east\n",
                                 "  sew p.east to p.west in 0cm..9cm ease 1cm in p.low..p.high\n"));
  EXPECT_THAT(script.told(), IsEmpty()) << script.rendered();
  const Script off(
      with_piece(square + "    notch low at 2cm of north\n", "  sew p.east to p.west ease 1cm in p.low..9cm\n"));
  EXPECT_THAT(off.told(), ElementsAre(StartsWith("E0213")));
}

TEST(Holes, MistakesInTheirNames) {
  const Script script(
      with_piece(holed, "  sew p.eye to p.east\n  sew p.eye.lfet to p.east\n  sew p.eye.left.mirored to p.east\n"));
  EXPECT_THAT(script.told(),
              ElementsAre(AllOf(StartsWith("E0308 15:13"), HasSubstr("no edge `lfet`")), StartsWith("E0103 16:18")));
  EXPECT_THAT(Script(with_piece(holed, "  sew p.left to p.east\n")).told(), ElementsAre(StartsWith("E0308 14:7")));
  EXPECT_THAT(Script(with_piece(square + "    hole west from (5cm, 3cm) {\n      rim = circle about (5cm, 5cm)\n    }\n"
                                         "    hole eye from (1cm, 1cm) {\n      a = line to (2cm, 1cm)\n"
                                         "      a = line to (2cm, 2cm)\n      b = line to start\n    }\n"))
                  .told(),
              ElementsAre(StartsWith("E0102 9:10"), StartsWith("E0102 14:7")));
}

TEST(Garments, HaveParametersAndDefaults) {
  Script script(
      "garment strip(width = 10cm) {\n  let shown = 2 * width\n  piece p {\n    outline from (0cm, 0cm) {\n"
      "      a = line to (width, 0cm)\n      b = line to (width, 5cm)\n      c = line to start\n    }\n  }\n}\n"
      "let wide = strip(width: 20cm)\nprint wide.shown\nexport wide to \"wide.svg\"\nexport strip to \"strip.json\"\n");
  ASSERT_THAT(script.told(), IsEmpty()) << script.rendered();
  EXPECT_THAT(script.program->garments(), SizeIs(2));
  EXPECT_THAT(script.printed(), ElementsAre("40 cm"));
}

TEST(Garments, TheirOwnParamsAreSet) {
  Script script(
      "garment g {\n  param w = 10cm in 5cm..20cm\n  piece p {\n    outline from (0cm, 0cm) {\n"
      "      a = line to (w, 0cm)\n      b = line to (w, 5cm)\n      c = line to start\n    }\n  }\n}\n"
      "print g.w\n",
      {{"g.w", "12cm"}});
  EXPECT_THAT(script.printed(), ElementsAre("12 cm"));
}

}  // namespace
}  // namespace toile::test
