#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grammar/ast.hpp"
#include "grammar/parse.hpp"

namespace toile::syntax {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using What = SyntaxError::What;

std::vector<SyntaxError> errors_of(const std::string& text) {
  return parse(Source("t.toile", text)).errors;
}

/// Every error as "line:column what text", for Unclosed with the place of what was opened behind it.
std::vector<std::string> places(const std::string& text) {
  const Source source("t.toile", text);
  std::vector<std::string> places;
  for (const SyntaxError& error : parse(source).errors) {
    static constexpr const char* names[] = {"unexpected", "unclosed", "too deep", "bad token", "no unit"};
    const LineColumn at = source.position(error.span.begin);
    const LineColumn opened = source.position(error.opened.begin);
    const bool unclosed = error.what == What::Unclosed;
    places.push_back(fmt::format("{}:{} {} '{}'{}", at.line, at.column, names[static_cast<int>(error.what)],
                                 source.slice(error.span),
                                 unclosed ? fmt::format(" from {}:{}", opened.line, opened.column) : ""));
  }
  return places;
}

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

TEST(Errors, SeveralFromOneFileWithoutNoise) {
  EXPECT_THAT(places("import bodies and\n"
                     "param length = 60cm in 30cm\n"
                     "garment skirt in {\n"
                     "  let w = (form.waist.girth + ) / 4\n"
                     "  peice lost {\n"
                     "    outline from (0cm, 0cm) {\n"
                     "      a = line to start\n"
                     "    }\n"
                     "  }\n"
                     "  piece front {\n"
                     "    outline from (0cm 0cm) {\n"
                     "      waist  curve to (w, 1cm)\n"
                     "      side  = lien to (w, -length)\n"
                     "      hem   = curve to (0cm, -length) leaving\n"
                     "      back  = line to start\n"
                     "    }\n"
                     "    notch 18cm of side\n"
                     "    dart at 5% of waist { width, depth 9cm }\n"
                     "  }\n"
                     "  sew front.side back.side\n"
                     "  wear front.waist at form.waist hold\n"
                     "}\n"
                     "drap skirt on form\n"
                     "render worn \"skirt.png\"\n"),
              ElementsAre("1:15 unexpected 'and'", "2:28 unexpected ''", "3:18 unexpected '{'", "4:31 unexpected ')'",
                          "5:3 unexpected 'peice'", "11:23 unexpected '0cm'", "12:14 unexpected 'curve'",
                          "13:15 unexpected 'lien'", "14:46 unexpected ''", "17:11 unexpected '18cm'",
                          "18:32 unexpected ','", "20:18 unexpected 'back'", "21:34 unexpected 'hold'",
                          "23:1 unexpected 'drap'", "24:13 unexpected '\"skirt.png\"'"));
}

TEST(Errors, SayWhatWasExpected) {
  const auto expected = [](const std::string& text) { return errors_of(text).at(0).expected; };
  EXPECT_THAT(expected("let w = * 2"), ElementsAre("a value"));
  EXPECT_THAT(expected("let = 2"), ElementsAre("a name"));
  EXPECT_THAT(expected("let w 2"), ElementsAre("`=`"));
  EXPECT_THAT(expected("let w = 2 3"), ElementsAre("an operator", "the end of the line"));
  EXPECT_THAT(expected("let w = (2 3)"), ElementsAre("`)`", "`,`", "an operator"));
  EXPECT_THAT(expected("expect 1 < 2 < 3"), ElementsAre("the end of the line"));
  EXPECT_THAT(expected("garment g { piece p { outline from p { a = curve to leaving 0deg } } }"),
              ElementsAre("a value"));
  EXPECT_THAT(expected("garment g { sew front to a.b }"), ElementsAre("`.`"));
  EXPECT_THAT(expected("garment g { sew to }"), ElementsAre("`.`"));
  EXPECT_THAT(expected("garment g { sew 3 }"), ElementsAre("an edge of a piece"));
  EXPECT_THAT(expected("garment g { piece p { outline from p { a = loop } } }"),
              ElementsAre("`along`", "`arc`", "`bezier`", "`circle`", "`curve`", "`line`"));
  EXPECT_THAT(expected("garment g { seam }"), ElementsAre("`allow`", "`arrange`", "`fn`", "`for`", "`let`", "`param`",
                                                          "`piece`", "`sew`", "`solve`", "`wear`"));
}

TEST(Errors, AStatementThatBreaksOffIsWrongAtItsEnd) {
  EXPECT_THAT(places("let a =   // nothing\nlet b = 3 +\nlet c = (1,\nlet d = 1\n"),
              ElementsAre("1:8 unexpected ''", "2:12 unexpected ''", "3:12 unexpected ''"));
}

TEST(Errors, ABracketIsClosedWhereItsStatementEnds) {
  EXPECT_THAT(places("let a = (1cm, 2cm\nlet b = [1, f(2\n\nlet c = 2\n"),
              ElementsAre("1:18 unclosed '' from 1:9", "2:16 unclosed '' from 2:14"));
  EXPECT_THAT(places("let a = [1, 2)\nlet b = f(\n  1,\n  2 3,\n  4\n)\nlet c = )\n"),
              ElementsAre("1:14 unexpected ')'", "4:5 unexpected '3'", "7:9 unexpected ')'"));
}

const std::string open_outline = "garment g {\n  piece p {\n    outline from (0cm, 0cm) {\n      a = line to start\n";

TEST(Errors, AForgottenBraceIsFoundByTheNextStatement) {
  EXPECT_THAT(places(open_outline + "    fold a\n  }\n  sew p.a to p.a\n}\ndrape g\n"),
              ElementsAre("5:5 unclosed 'fold' from 3:29"));
  EXPECT_THAT(places(open_outline + "    }\n    fold a\n  sew p.a to p.a\n}\ndrape g\n"),
              ElementsAre("7:3 unclosed 'sew' from 2:11"));
  EXPECT_THAT(places(open_outline + "    }\n  }\ndrape g\n"), ElementsAre("7:1 unclosed 'drape' from 1:11"));
  EXPECT_THAT(places(open_outline), ElementsAre("4:24 unclosed '' from 3:29"));
  EXPECT_THAT(places("fabric f {\n  W 2 mg/cm^2\ngarment g {\n}\n"), ElementsAre("3:1 unclosed 'garment' from 1:10"));
}

TEST(Errors, AStatementIndentedIntoTheWrongBlockIsOnlyMisplaced) {
  EXPECT_THAT(places(open_outline + "    }\n    sew p.a to p.a\n    fold a\n  }\n}\ndrape g\n"),
              ElementsAre("6:5 unexpected 'sew'"));
}

TEST(Errors, ABraceTooManyIsSaidOnce) {
  EXPECT_THAT(
      places(open_outline + "    }\n  }\n  }\n    fold a\n    grain down\n  }\n  sew p.a to p.a\n}\ndrape g drape\n"),
      ElementsAre("8:5 unexpected 'fold'", "13:9 unexpected 'drape'"));
  EXPECT_THAT(places("let a = 1\n}\n}\nlet b = 2 2\n"), ElementsAre("2:1 unexpected '}'", "4:11 unexpected '2'"));
}

TEST(Errors, WhatIsNoTokenAtAll) {
  using namespace std::string_literals;
  EXPECT_THAT(
      places("let a = 3 ; 4\nlet b = #12345\nlet c = 'x'\nlet d = \xC3\xA9\n"),
      ElementsAre("1:11 bad token ';'", "2:9 bad token '#12345'", "3:9 bad token '''", "4:9 bad token '\xC3\xA9'"));
  EXPECT_THAT(places("let a = \"x\\q\"\nlet b = \"abc\nlet c = \"\\\"\n"),
              ElementsAre("1:11 bad token '\\q'", "2:13 unclosed '' from 2:9", "3:12 unclosed '' from 3:9"));
  EXPECT_THAT(
      places("let a = 1 // \x01\nlet b = \"\x80\"\nlet \0 = 1\nlet \xff\xfe = 1\n"s),
      ElementsAre("1:14 bad token '\x01'", "2:10 bad token '\x80'", "3:5 bad token '\0'"s, "4:5 bad token '\xff\xfe'"));
}

TEST(Errors, LettersBehindANumberMustBeAUnit) {
  EXPECT_THAT(places("let a = 14xm + 2\nlet b = 3.5cmm\nlet c = 2m2\nlet d = 14 ells\n"),
              ElementsAre("1:11 no unit 'xm'", "2:12 no unit 'cmm'", "3:10 no unit 'm2'", "4:12 unexpected 'ells'"));
}

TEST(Errors, NestingHasALimit) {
  for (const char* opening : {"(", "[", "-", "not ", "if ", "f(", "a[", "1 + ", "2 ^ ", "[f(-", "(if ", "a < ("}) {
    const auto errors = errors_of("let a = " + repeated(opening, 10000) + "\nlet b = 1 2\n");
    ASSERT_THAT(errors, SizeIs(2)) << opening;
    EXPECT_EQ(errors[0].what, What::TooDeep) << opening;
    EXPECT_EQ(errors[1].what, What::Unexpected) << opening;
  }
  EXPECT_THAT(places("let a = 1" + repeated(".x", 10000)), ElementsAre(testing::HasSubstr("too deep")));
  EXPECT_THAT(errors_of("garment g " + repeated("{", 10000)), Not(IsEmpty()));
  EXPECT_THAT(errors_of(repeated("garment g {\n", 3000)), Not(IsEmpty()));
  EXPECT_THAT(errors_of(repeated("}", 10000)), SizeIs(1));
}

TEST(Errors, NobodyMeetsTheLimitByWriting) {
  EXPECT_THAT(errors_of("let a = " + repeated("(", 60) + "1" + repeated(")", 60)), IsEmpty());
  EXPECT_THAT(errors_of("let a = 1" + repeated(" + 1", 200)), IsEmpty());
  EXPECT_THAT(errors_of("let a = [1" + repeated(", 1 + f(2).x", 5000) + "]"), IsEmpty());
}

TEST(Errors, KeepWhatWasReadBeforeThem) {
  const Source source("t.toile", "let w = 3cm 4\nlet v =\ngarment skirt in {\n  piece front {\n    fold a\n  }\n}\n");
  const Parsed parsed = parse(source);
  const auto lets = all<Let>(root(parsed.tree));
  ASSERT_THAT(lets, SizeIs(2));
  EXPECT_TRUE(lets[0].value().has_value());
  EXPECT_EQ(source.slice(lets[1].name()->span()), "v");
  EXPECT_FALSE(lets[1].value().has_value());
  const auto skirt = child<Garment>(root(parsed.tree)).value();
  EXPECT_EQ(source.slice(skirt.name()->span()), "skirt");
  EXPECT_FALSE(skirt.fabric().has_value());
  EXPECT_THAT(items(skirt), SizeIs(1));
}

TEST(Errors, OfALoneExpression) {
  const auto errors = [](const std::string& text) { return parse_expression(Source("--set", text)).errors; };
  EXPECT_THAT(errors(" 20cm "), IsEmpty());
  EXPECT_THAT(errors(""), SizeIs(1));
  EXPECT_THAT(errors("20cm }"), SizeIs(1));
  EXPECT_THAT(errors("20cm\nlet a = 3"), SizeIs(1));
  EXPECT_THAT(errors("20cm +"), SizeIs(1));
}

TEST(Errors, HaveAnEndOnDenseNonsense) {
  EXPECT_THAT(errors_of(repeated("sew } ( \" \n", 20000)), Not(IsEmpty()));
  EXPECT_THAT(errors_of(repeated("( ", 200000)), Not(IsEmpty()));
  EXPECT_THAT(errors_of(repeated("x ", 200000)), SizeIs(1));
}

}  // namespace
}  // namespace toile::syntax
