// Drafting in scripts: places and curves by functions, clauses of edges, and what is said where there is no such place.
#include <gmock/gmock.h>

#include "tests/compiler/front/front.hpp"

namespace toile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string side = "let side = line((0cm, 0cm), (10cm, 0cm))\nlet across = line((7cm, -1cm), (7cm, 3cm))\n";

TEST(Drafting, IntersectionsAreOrderedAlongTheFirst) {
  EXPECT_EQ(value_of("intersections(line((6cm, 3cm), (-6cm, 3cm)), circle((0cm, 0cm), 5cm))"),
            "[(4 cm, 3 cm), (-4 cm, 3 cm)]");
  EXPECT_EQ(value_of("intersection(side, across)", side), "(7 cm, 0 cm)");
  EXPECT_EQ(value_of("intersections(side, line((0cm, 1cm), (9cm, 1cm)))", side), "[]");
}

TEST(Drafting, ATriangleByItsThreeSides) {
  EXPECT_EQ(value_of("intersections(circle((0cm, 0cm), 3cm), circle((5cm, 0cm), 4cm))[1]"), "(1.8 cm, 2.4 cm)");
}

TEST(Drafting, PlacesAlongAndAcross) {
  EXPECT_EQ(value_of("point_on(side, at: 5cm, across: 2cm), point_on(side, at: across, across: -1cm)", side),
            "(5 cm, 2 cm) (7 cm, -1 cm)");
  EXPECT_EQ(value_of("length_to(side, across), length_to(side, (3cm, 0cm)), length_to(side, 25%)", side),
            "7 cm 3 cm 2.5 cm");
  EXPECT_EQ(value_of("between((0cm, 0cm), (3cm, 4cm)), between((0cm, 0cm), (3cm, 4cm), at: 1cm)"),
            "(1.5 cm, 2 cm) (6 mm, 8 mm)");
  EXPECT_EQ(value_of("foot((3cm, 4cm), side), nearest((12cm, 4cm), side), feet((12cm, 4cm), side)", side),
            "(3 cm, 0 cm) (10 cm, 0 cm) []");
  EXPECT_EQ(value_of("tangents((5cm, 5cm), circle((0cm, 0cm), 5cm))"), "[(5 cm, 0 cm), (0 cm, 5 cm)]");
  EXPECT_EQ(value_of("1 / curvature_on(circle((0cm, 0cm), 5cm), 1cm)"), "5 cm");
}

TEST(Drafting, CurvesFromCurves) {
  EXPECT_EQ(value_of("part(side, to: across), split(side, 2cm, across)", side),
            "a curve 7 cm long [a curve 2 cm long, a curve 5 cm long, a curve 3 cm long]");
  EXPECT_EQ(value_of("offset(side, 1cm).start, extend(side, before: 1cm, after: 2cm)", side),
            "(0 cm, 1 cm) a curve 13 cm long");
  EXPECT_EQ(value_of("offset(circle((0cm, 0cm), 5cm), 2cm)"), "a curve 18.8496 cm long");
  EXPECT_EQ(value_of("arc((0cm, 0cm), (2cm, 0cm), radius: 1cm), arc_about((0cm, 0cm), 2cm, 90deg, 0deg)"),
            "a curve 3.14159 cm long a curve 3.14159 cm long");
  EXPECT_EQ(value_of("sector((0cm, 0cm), 2cm, 0deg, 90deg)"), "a curve 7.14159 cm long");
  EXPECT_EQ(value_of("spline([(0cm, 0cm), (1cm, 1cm), (3cm, 3cm)]).end"), "(3 cm, 3 cm)");
  EXPECT_EQ(value_of("direction_on(spline([(0cm, 0cm), (4cm, 3cm), (9cm, 1cm)], leaving: 10deg), 0%)"), "10 deg");
  EXPECT_EQ(value_of("with_length(curve((0cm, 0cm), (20cm, 0cm), leaving: 40deg), 23.4cm)"), "a curve 23.4 cm long");
}

TEST(Drafting, EdgesThroughPointsAndOfALength) {
  const std::string garment =
      "garment g {\n  piece p {\n    outline from (0cm, 0cm) {\n"
      "      neck = curve to (9cm, 6cm) leaving 0deg arriving 80deg long 12cm\n"
      "      arm  = curve to (12cm, -6cm) through (10cm, 2cm), (11cm, -4cm) leaving -90deg\n"
      "      side = arc to (12cm, -30cm) through (11cm, -18cm) long 25cm\n"
      "      hem  = line to (0cm, -30cm)\n      fold = line to start\n    }\n  }\n}\n";
  EXPECT_EQ(value_of("length(g.p.neck), length(g.p.side), direction_on(g.p.arm, 0cm)", garment), "12 cm 25 cm -90 deg");
  EXPECT_EQ(value_of("distance(nearest((10cm, 2cm), g.p.arm), (10cm, 2cm)) < 1um", garment), "true");
}

TEST(Drafting, WhereThereIsNoPlaceItIsSaid) {
  const Script script(side +
                      "let a = intersection(side, line((0cm, 1cm), (9cm, 1cm)))\n"
                      "let b = intersection(line((-9cm, 0cm), (9cm, 0cm)), circle((0cm, 0cm), 5cm))\n"
                      "let c = point_on(side, at: (3cm, 2cm))\n"
                      "let d = foot((12cm, 1cm), side)\n"
                      "let e = part(side, from: across, to: 5cm)\n"
                      "let f = split(side, 5cm, 2cm)\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0211 3:28"), AllOf(StartsWith("E0212 4:"), HasSubstr("2 times")),
                                         AllOf(StartsWith("E0213 5:28"), HasSubstr("2 cm off")),
                                         StartsWith("E0217 6:14"), StartsWith("E0209 7:"), StartsWith("E0209 8:26")));
  EXPECT_THAT(script.rendered(), HasSubstr("extend(line, after: 10cm)"));
}

TEST(Drafting, CurvesThatCannotBeAreTold) {
  const Script script(side +
                      "let a = with_length(side, 12cm)\n"
                      "let b = with_length(curve((0cm, 0cm), (20cm, 0cm), leaving: 40deg), 19cm)\n"
                      "let c = offset(circle((0cm, 0cm), 5cm), 6cm)\n"
                      "let d = spline([(0cm, 0cm)])\n"
                      "let e = spline([(0cm, 0cm), (0cm, 0cm), (1cm, 1cm)])\n"
                      "let f = arc((0cm, 0cm), (1cm, 0cm))\n"
                      "let g = circle((0cm, 0cm), -1cm)\n"
                      "let h = spline([1cm, 2cm])\n");
  EXPECT_THAT(script.told(), ElementsAre(StartsWith("E0216 3:27"), StartsWith("E0216 4:"), StartsWith("E0215 5:"),
                                         StartsWith("E0214 6:"), StartsWith("E0214 7:"), StartsWith("E0108 8:"),
                                         StartsWith("E0208 9:"), StartsWith("E0203 10:")));
  EXPECT_THAT(script.rendered(), HasSubstr("its ends are 20 cm apart"));
}

TEST(Drafting, AClauseIsGivenOnce) {
  const Script script(
      "garment g {\n  piece p {\n    outline from (0cm, 0cm) {\n"
      "      a = curve to (9cm, 6cm) leaving 0deg leaving 10deg\n      b = line to (9cm, 0cm)\n"
      "      c = line to start\n    }\n  }\n}\n");
  EXPECT_THAT(script.told(), ElementsAre(AllOf(StartsWith("E0109 4:44"), HasSubstr("`leaving`"))));
}

}  // namespace
}  // namespace toile::test
