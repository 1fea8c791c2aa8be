// `toile doc`: what a module's comments and definitions come to.
#include "grammar/reference/reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace toile::syntax {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page(const std::string& text) {
  const Source source("parts.toile", text);
  return reference(parse(source), source, "parts");
}

TEST(Reference, HasWhatADefinitionIsCalledWithAndWhatItsCommentSays) {
  EXPECT_EQ(
      page("/// Parts of shirts.\nimport fabrics\n\n"
           "/// A band that goes round.\n/// Straight.\npiece band(\n  around,\n  depth = 4cm,    // high\n) {\n}\n"
           "/// A quarter of a girth.\nfn quarter(girth, ease = 2cm) = (girth + ease) / 4\n"
           "let unsaid = 3cm\n/// A seam's usual width.\nlet seam = 1cm\n"),
      "# parts\n\nParts of shirts.\n\n## Pieces\n\n### `band(around, depth = 4cm)`\n\nA band that goes "
      "round.\nStraight.\n"
      "\n## Functions\n\n### `quarter(girth, ease = 2cm)`\n\nA quarter of a girth.\n"
      "\n## Values\n\n### `seam = 1cm`\n\nA seam's usual width.\n");
}

TEST(Reference, TellsParamsSizesAndSources) {
  const std::string text = page(
      "/// At the hem.\nparam flare = 14cm in 0cm..60cm\n"
      "garment skirt {\n  /// From the waist.\n  param length = 60cm\n}\n"
      "sizes women(waist, hip) {\n  S 64cm, 90cm\n  2XL 90cm, 116cm\n}\nfabric felt {\n  source \"my own\"\n  W 3 "
      "mg/cm^2\n}\n");
  EXPECT_THAT(text, HasSubstr("### `flare = 14cm in 0cm..60cm`\n\nAt the hem.\n"));
  EXPECT_THAT(text, HasSubstr("### `skirt`\n\n- `param length = 60cm`: From the waist.\n"));
  EXPECT_THAT(text, HasSubstr("### `women(waist, hip)`\n\nSizes: S, 2XL.\n"));
  EXPECT_THAT(text, HasSubstr("### `felt`\n\nSource: my own.\n"));
}

TEST(Reference, NamesPiecesAndTheirEdges) {
  const std::string text = page(
      "garment skirt {\n  /// What the band is sewn to.\n  let top = 70cm\n  piece front {\n    outline from (0cm, "
      "0cm) {\n"
      "      waist = line to (9cm, 0cm)\n      centre = line to start\n    }\n"
      "    fold centre\n    line place from (1cm, 1cm) {\n      left = line to (1cm, 2cm)\n    }\n  }\n"
      "  piece back = front with { label \"B\" }\n  piece band = parts.band(70cm)\n}\n"
      "piece cuff(around) {\n  outline from (0cm, 0cm) {\n    head = line to (around, 0cm)\n  }\n}\n");
  EXPECT_THAT(text, HasSubstr("- `top = 70cm`: What the band is sewn to.\n"));
  EXPECT_THAT(text, HasSubstr("- `front`: `waist`, `centre` (fold), `place.left`\n- `back` = `front` varied\n"
                              "- `band` = `parts.band(70cm)`\n"));
  EXPECT_THAT(text, HasSubstr("### `cuff(around)`\n\nEdges: `head`.\n"));
}

TEST(Reference, ACommentOfItsOwnIsTheModules) {
  EXPECT_THAT(page("/// About it.\n\n/// Of a.\nlet a = 1\n"), HasSubstr("# parts\n\nAbout it.\n\n## Values"));
  EXPECT_THAT(page("/// Of a.\nlet a = 1\n"), HasSubstr("# parts\n\n## Values"));
  EXPECT_EQ(page(""), "# parts\n");
}

}  // namespace
}  // namespace toile::syntax
