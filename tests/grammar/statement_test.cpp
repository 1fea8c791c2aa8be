#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "grammar/ast.hpp"
#include "grammar/parse.hpp"

namespace toile::syntax {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A script that must be right, and texts of its parts.
class Script {
 public:
  explicit Script(std::string text) : source_("t.toile", std::move(text)), parsed_(parse(source_)) {
    EXPECT_THAT(parsed_.errors, IsEmpty()) << source_.text();
  }
  template <typename T>
  T only() const {
    return all<T>(root(parsed_.tree)).at(0);
  }
  template <typename T>
  T in_garment() const {
    return all<T>(child<Block>(only<Garment>()).value()).at(0);
  }
  template <typename T>
  T in_piece() const {
    return all<T>(child<Block>(in_garment<Piece>()).value()).at(0);
  }
  View file() const { return root(parsed_.tree); }
  const Source& source() const { return source_; }
  template <typename Part>
  std::string operator()(const std::optional<Part>& part) const {
    return part ? std::string(source_.slice(part->span())) : "-";
  }
  template <typename Part>
  std::vector<std::string> operator()(const std::vector<Part>& parts) const {
    std::vector<std::string> texts;
    for (const Part& part : parts) texts.emplace_back(source_.slice(part.span()));
    return texts;
  }

 private:
  Source source_;
  Parsed parsed_;
};

Script in_garment(const std::string& text) {
  return Script("garment g {\n" + text + "\n}\n");
}
Script in_piece(const std::string& text) {
  return in_garment("piece p {\n" + text + "\n}");
}

TEST(Statement, TheFirstScript) {
  std::ifstream file(TOILE_SOURCE_DIR "/tests/grammar/first_script.toile");
  std::ostringstream text;
  text << file.rdbuf();
  const Script script(text.str());
  EXPECT_EQ(items(script.file()).size(), 12u);
  EXPECT_EQ(doc(items(script.file())[0], script.source()), "A flared skirt, cut on the fold, worn at the waist.");

  const auto skirt = script.only<Garment>();
  EXPECT_EQ(script(skirt.name()), "skirt");
  EXPECT_EQ(script(skirt.fabric()), "fabrics.wool_serge");
  std::vector<Kind> kinds;
  for (const View item : items(skirt)) kinds.push_back(item.kind());
  EXPECT_THAT(kinds, ElementsAre(Kind::Let, Kind::Piece, Kind::Piece, Kind::Sew, Kind::Wear));

  const auto outline = script.in_piece<Outline>();
  EXPECT_EQ(script(outline.origin()), "(0cm, 0cm)");
  const auto waist = as<Edge>(items(outline).at(0)).value();
  EXPECT_EQ(script(waist.name()), "waist");
  EXPECT_EQ(script(waist.walk()->target()), "(w, 1.2cm)");
  EXPECT_EQ(script(waist.walk()->leaving()), "0deg");
  EXPECT_EQ(script(waist.walk()->arriving()), "10deg");
  EXPECT_TRUE(as<Edge>(items(outline).at(3))->walk()->to_start());
}

TEST(Statement, Import) {
  const Script script("import bodies as b\nimport \"my cuffs.toile\"\n");
  const auto imports = all<Import>(script.file());
  EXPECT_EQ(script(imports[0].module()), "bodies");
  EXPECT_EQ(script(imports[0].alias()), "b");
  EXPECT_EQ(string_value(imports[1].path().value(), script.source()), "my cuffs.toile");
  EXPECT_EQ(script(imports[1].alias()), "-");
}

TEST(Statement, ParamWithRangeAndDoc) {
  const Script script("// not this\n\n/// From waist to hem.\n/// Knee: 60.\nparam length = 60cm in 30cm..110cm\n");
  const auto param = script.only<Param>();
  EXPECT_EQ(script(param.value()), "60cm");
  EXPECT_EQ(script(param.range()->low()), "30cm");
  EXPECT_EQ(script(param.range()->high()), "110cm");
  EXPECT_EQ(doc(param, script.source()), "From waist to hem.\nKnee: 60.");
}

TEST(Statement, DocStandsDirectlyAbove) {
  const Script script("/// Of nothing.\n\nlet a = 1\n");
  EXPECT_EQ(doc(script.only<Let>(), script.source()), "");
}

TEST(Statement, Functions) {
  const Script script("fn f(a, b = 2cm) = a + b\nfn g() {\n  let c = 1\n  c * 2\n}\n");
  const auto functions = all<Fn>(script.file());
  EXPECT_THAT(script(functions[0].parameters()->list()), ElementsAre("a", "b = 2cm"));
  EXPECT_EQ(script(functions[0].parameters()->list()[1].fallback()), "2cm");
  EXPECT_EQ(script(functions[0].result()), "a + b");
  EXPECT_EQ(items(functions[1]).size(), 1u);
  EXPECT_EQ(script(functions[1].result()), "c * 2");
}

TEST(Statement, FabricRowsMayBeginWithDigits) {
  const Script script(
      "fabric serge = base with {\n  LT 0.62, 0.60 // warp, weft\n  2HG5 1.3 gf/cm\n  source \"sheet\"\n}\n");
  const auto fabric = script.only<Fabric>();
  EXPECT_EQ(script(fabric.base()), "base");
  const auto rows = items(fabric);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_THAT(script(as<Row>(rows[0])->values()), ElementsAre("0.62", "0.60"));
  EXPECT_EQ(script(as<Row>(rows[1])->name()), "2HG5");
  EXPECT_THAT(script(as<Row>(rows[1])->values()), ElementsAre("1.3 gf/cm"));
}

TEST(Statement, TextileRows) {
  const Script script("textile tartan {\n  warp 8, #1f3a5f, 2, #fff\n}\n");
  EXPECT_THAT(script(as<Row>(items(script.only<Textile>())[0])->values()), ElementsAre("8", "#1f3a5f", "2", "#fff"));
}

TEST(Statement, DetailsUnderFor) {
  const Script script =
      in_piece("for i in 1..4 if i != 2 {\n  notch at i * 5cm of side\n  dart at 1cm of hem { }\n}\nfold a");
  const auto repeat = script.in_piece<Repeat>();
  EXPECT_EQ(script(repeat.values()->name()), "i");
  EXPECT_EQ(script(repeat.values()->to()), "4");
  EXPECT_EQ(script(repeat.values()->condition()), "i != 2");
  EXPECT_EQ(items(repeat).size(), 2u);
  EXPECT_EQ(script(script.in_piece<Fold>().edge()), "a");
}

TEST(Statement, SizesMayBeNumbers) {
  const Script script("sizes women(waist, height = 168cm) at 38 {\n  38 68cm\n  2XL -2cm, 172cm\n}\nlet sizes = 3\n");
  const auto sizes = script.only<Sizes>();
  EXPECT_EQ(script(sizes.name()), "women");
  EXPECT_EQ(script(sizes.base()), "38");
  EXPECT_EQ(sizes.measures()->list().size(), 2u);
  const auto rows = items(sizes);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(script(as<SizeRow>(rows[0])->name()), "38");
  EXPECT_EQ(script(as<SizeRow>(rows[1])->name()), "2XL");
  EXPECT_THAT(script(as<SizeRow>(rows[1])->values()), ElementsAre("-2cm", "172cm"));
}

TEST(Statement, Bodies) {
  const Script script(
      "body form(waist = 68cm) {\n"
      "  let k = 1\n"
      "  section hips at 82cm { girth 94cm, width 34cm\n offset 1cm }\n"
      "  limb arm { girth 28cm }\n"
      "  ball at 1m { radius 10cm }\n"
      "}\n"
      "body other = form(waist: 70cm) with {\n  line high at 104cm {}\n}\n");
  const auto bodies = all<Body>(script.file());
  EXPECT_EQ(script(bodies[0].parameters()), "(waist = 68cm)");
  const auto parts = all<BodyPart>(child<Block>(bodies[0]).value());
  EXPECT_EQ(parts[0].role()->kind(), Kind::KwSection);
  EXPECT_EQ(script(parts[0].name()), "hips");
  EXPECT_EQ(script(parts[0].at()), "82cm");
  EXPECT_THAT(script(parts[0].properties()), ElementsAre("girth 94cm", "width 34cm", "offset 1cm"));
  EXPECT_EQ(script(parts[1].at()), "-");
  EXPECT_EQ(script(parts[2].role()), "ball");
  EXPECT_EQ(script(parts[2].name()), "-");
  EXPECT_EQ(script(bodies[1].base()), "form(waist: 70cm)");
  EXPECT_EQ(as<BodyPart>(items(bodies[1])[0])->role()->kind(), Kind::KwLine);
}

TEST(Statement, EveryWalk) {
  const Script script = in_piece(
      "outline from (0, 0) {\n"
      "  a = line to p\n"
      "  b = curve to p arriving 3deg leaving 4deg\n"
      "  c = arc to p through q\n"
      "  d = arc to p radius 3cm large\n"
      "  e = bezier to p via q, r\n"
      "  f = circle about q\n"
      "  g = along neckline.mirrored\n"
      "  fold = line to start.x\n"
      "  h = arc to radius through through\n"
      "}");
  std::vector<Walk> walks;
  for (const View edge : items(script.in_piece<Outline>())) walks.push_back(as<Edge>(edge)->walk().value());
  EXPECT_EQ(walks[0].kind(), Kind::LineWalk);
  EXPECT_EQ(script(walks[1].leaving()), "4deg");
  EXPECT_EQ(script(walks[2].through()), "q");
  EXPECT_FALSE(walks[2].large());
  EXPECT_EQ(script(walks[3].radius()), "3cm");
  EXPECT_TRUE(walks[3].large());
  EXPECT_EQ(script(walks[4].first_control()), "q");
  EXPECT_EQ(script(walks[4].second_control()), "r");
  EXPECT_EQ(script(walks[5].about()), "q");
  EXPECT_EQ(script(walks[6].along()), "neckline.mirrored");
  EXPECT_FALSE(walks[7].to_start());
  EXPECT_EQ(script(walks[7].target()), "start.x");
  EXPECT_EQ(script(walks[8].target()), "radius");
  EXPECT_EQ(script(walks[8].through()), "through");
}

TEST(Statement, PieceDetails) {
  const Script script = in_piece(
      "hole pocket from (1, 1) {\n  round = circle about (2, 2)\n}\n"
      "fold line\ncut 2 mirrored\ngrain bias\n"
      "dart d at 3cm of waist {\n  width 2cm\n  depth 9cm\n}\n"
      "notch at 18cm of fold\nallowance 1cm, hem 4cm, side 2cm\nlabel \"front\"");
  EXPECT_EQ(script(script.in_piece<Inner>().name()), "pocket");
  EXPECT_EQ(script(script.in_piece<Inner>().origin()), "(1, 1)");
  EXPECT_EQ(script(script.in_piece<Fold>().edge()), "line");
  EXPECT_TRUE(script.in_piece<Cut>().mirrored());
  EXPECT_EQ(script.in_piece<Grain>().direction()->kind(), Kind::KwBias);
  const auto dart = script.in_piece<Dart>();
  EXPECT_EQ(script(dart.name()), "d");
  EXPECT_EQ(script(dart.position()->where()), "3cm");
  EXPECT_THAT(script(dart.properties()), ElementsAre("width 2cm", "depth 9cm"));
  EXPECT_EQ(script(script.in_piece<Notch>().position()->edge()), "fold");
  EXPECT_THAT(script(script.in_piece<Allowance>().exceptions()), ElementsAre("hem 4cm", "side 2cm"));
  EXPECT_EQ(script(script.in_piece<Label>().text()), "\"front\"");
}

TEST(Statement, LinesOfAPieceAreWalkedLikeHoles) {
  const Script script =
      in_piece("line place from (1, 1) {\n  left = line to (1, 5)\n}\nnotch half at 50% of place.left");
  EXPECT_TRUE(script.in_piece<Inner>().is_line());
  EXPECT_EQ(script(script.in_piece<Inner>().name()), "place");
  EXPECT_EQ(script(script.in_piece<Inner>().origin()), "(1, 1)");
  EXPECT_EQ(script(script.in_piece<Notch>().name()), "half");
}

TEST(Statement, GrainIsAWordOrAnAngle) {
  const Script angle = in_piece("grain 30deg");
  EXPECT_EQ(angle(angle.in_piece<Grain>().angle()), "30deg");
  EXPECT_EQ(angle(angle.in_piece<Grain>().direction()), "-");
  const Script word = in_piece("grain left");
  EXPECT_EQ(word(word.in_piece<Grain>().direction()), "left");
  EXPECT_EQ(word(word.in_piece<Grain>().angle()), "-");
  const Script value = in_piece("grain left + 3deg");
  EXPECT_EQ(value(value.in_piece<Grain>().angle()), "left + 3deg");
}

TEST(Statement, VariedPiece) {
  const Script script = in_garment("piece back = front with {\n  outline {\n    hem = line to p\n  }\n}");
  EXPECT_EQ(script(script.in_garment<Piece>().base()), "front");
  EXPECT_EQ(script(script.in_piece<Outline>().origin()), "-");
}

TEST(Statement, SewAndWear) {
  const Script script = in_garment(
      "sew a.x + b.y.mirrored +\n  c.z to d.x gather 3cm reversed\n"
      "wear a.neck at form.neck placed from (0cm, 1cm, 2cm)");
  const auto sew = script.in_garment<Sew>();
  EXPECT_THAT(script(sew.first()->edges()), ElementsAre("a.x", "b.y.mirrored", "c.z"));
  EXPECT_THAT(script(sew.first()->edges()[1].path()), ElementsAre("b", "y", "mirrored"));
  EXPECT_THAT(script(sew.second()->edges()), ElementsAre("d.x"));
  EXPECT_THAT(script(sew.options()), ElementsAre("gather 3cm", "reversed"));
  EXPECT_EQ(script(sew.options()[0].amount()), "3cm");
  const auto wear = script.in_garment<Wear>();
  EXPECT_EQ(script(wear.line()), "form.neck");
  EXPECT_EQ(wear.options().at(0).word()->kind(), Kind::KwPlaced);
  EXPECT_EQ(script(wear.options().at(1).origin()), "(0cm, 1cm, 2cm)");
}

TEST(Statement, Commands) {
  const Script script(
      "drape skirt on form as worn to 1e-6\n"
      "render worn to \"a.png\" pixels 640, 480 from front showing strain.warp\n"
      "export worn to \"a.glb\"\nprint \"l\", worn.x\nexpect worn.x < 1%");
  const auto drape = script.only<Drape>();
  EXPECT_EQ(script(drape.garment()), "skirt");
  EXPECT_EQ(script(drape.body()), "form");
  EXPECT_EQ(script(drape.name()), "worn");
  EXPECT_EQ(script(drape.accuracy()), "1e-6");
  const auto options = script.only<Render>().options();
  EXPECT_THAT(script(options.at(0).sizes()), ElementsAre("640", "480"));
  EXPECT_THAT(script(options.at(1).names()), ElementsAre("front"));
  EXPECT_THAT(script(options.at(2).names()), ElementsAre("strain", "warp"));
  EXPECT_EQ(script(script.only<Export>().path()), "\"a.glb\"");
  EXPECT_THAT(script(script.only<Print>().values()), ElementsAre("\"l\"", "worn.x"));
  EXPECT_EQ(script(script.only<Expect>().condition()), "worn.x < 1%");
}

TEST(Statement, PiecesDrawnOnABodyAndTheirDevelopment) {
  const Script script(
      "garment g {\n  piece back on form.waist = front with { }\n}\ndevelop g as flat with darts to 2% until within "
      "3mm\ndevelop g");
  const auto piece = script.in_garment<Piece>();
  EXPECT_EQ(script(piece.on()), "form.waist");
  EXPECT_EQ(script(piece.base()), "front");
  const auto develops = all<Develop>(script.file());
  EXPECT_EQ(script(develops.at(0).garment()), "g");
  EXPECT_EQ(script(develops.at(0).name()), "flat");
  EXPECT_EQ(script(develops.at(0).strain()), "2%");
  EXPECT_EQ(script(develops.at(0).within()), "3mm");
  EXPECT_FALSE(develops.at(1).name());
}

TEST(Statement, SolveStandsOverLines) {
  const Script script("solve h in 8cm..20cm, w in a..b\n  so length(cap(h)) = x + 2cm,\n     (h, w) = p");
  const auto solve = script.only<Solve>();
  EXPECT_EQ(script(solve.unknowns().at(1).name()), "w");
  EXPECT_EQ(script(solve.unknowns().at(0).range()->high()), "20cm");
  EXPECT_EQ(script(solve.equations().at(0).right()), "x + 2cm");
  EXPECT_EQ(script(solve.equations().at(1).left()), "(h, w)");
  EXPECT_EQ(items(script.file()).size(), 1u);
  EXPECT_EQ(items(Script("solve x in 0..1 so x = so\nlet so = 1\nlet solve = so").file()).size(), 3u);
}

TEST(Statement, ParamsWithChoices) {
  const Script script("param a = \"x\" in [\"x\", \"y\"]\nparam b = 2 in low[1]..high");
  EXPECT_EQ(script(all<Param>(script.file()).at(0).choices()->list()), "[\"x\", \"y\"]");
  EXPECT_FALSE(all<Param>(script.file()).at(0).range());
  EXPECT_EQ(script(all<Param>(script.file()).at(1).range()->low()), "low[1]");
}

TEST(Statement, EdgesThroughPointsAndOfALength) {
  const Script script = in_piece(
      "outline from (0, 0) {\n  a = curve to p leaving 1deg through q, r, s long 3cm arriving 2deg\n"
      "  b = arc to p radius 2cm large long 9cm\n}");
  const auto edges = items(script.in_piece<Outline>());
  const auto curve = as<Edge>(edges.at(0))->walk().value();
  EXPECT_THAT(script(curve.waypoints()), ElementsAre("q", "r", "s"));
  EXPECT_EQ(script(curve.wanted_length()), "3cm");
  EXPECT_EQ(script(curve.arriving()), "2deg");
  EXPECT_EQ(script(as<Edge>(edges.at(1))->walk()->wanted_length()), "9cm");
}

TEST(Statement, KeywordsNameEdgesAndPieces) {
  const Script script = in_garment(
      "piece sew {\n  outline from (0, 0) {\n    from = line to p\n    to = line to start\n  }\n  fold from\n}\n"
      "sew sew.from + sew.at to sew.to");
  EXPECT_EQ(script(script.in_garment<Piece>().name()), "sew");
  EXPECT_EQ(script(as<Edge>(items(script.in_piece<Outline>())[0])->name()), "from");
  EXPECT_THAT(script(script.in_garment<Sew>().first()->edges()), ElementsAre("sew.from", "sew.at"));
}

TEST(Statement, LineEndsOfEveryKind) {
  const Script script("let a = 1\r\nlet b =\r\n  2\r\n\r\nlet c = (1,\r\n  2)");
  EXPECT_THAT(script(items(script.file())), ElementsAre("let a = 1", "let b =\r\n  2", "let c = (1,\r\n  2)"));
}

}  // namespace
}  // namespace toile::syntax
