#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "grammar/ast.hpp"
#include "grammar/parse.hpp"

namespace toile::syntax {
namespace {

/// The tree of an expression with all its brackets, numbers as number_unit: "a + 2cm * b" is "(a + (2_cm * b))".
std::string shape(View view, const Source& source) {
  const auto part = [&](std::optional<Expr> expr) { return expr ? shape(*expr, source) : "?"; };
  const auto word = [&](std::optional<Token> leaf) { return leaf ? std::string(source.slice(leaf->span())) : "?"; };
  const auto list = [&](const auto& parts) {
    std::string joined;
    for (const auto& each : parts) joined += (joined.empty() ? "" : ", ") + shape(each, source);
    return joined;
  };
  if (const auto e = as<Binary>(view))
    return fmt::format("({} {} {})", part(e->left()), word(e->op()), part(e->right()));
  if (const auto e = as<Unary>(view)) return fmt::format("({} {})", word(e->op()), part(e->operand()));
  if (const auto e = as<Member>(view)) return fmt::format("{}.{}", part(e->object()), word(e->name()));
  if (const auto e = as<Index>(view)) return fmt::format("{}[{}]", part(e->object()), part(e->index()));
  if (const auto e = as<Call>(view)) return fmt::format("{}({})", part(e->callee()), list(e->arguments()));
  if (const auto e = as<Argument>(view)) {
    return e->name() ? fmt::format("{}: {}", word(e->name()), part(e->value())) : part(e->value());
  }
  if (const auto e = as<Number>(view)) {
    return e->unit() ? fmt::format("{}_{}", word(e->digits()), word(e->unit())) : word(e->digits());
  }
  if (const auto e = as<Tuple>(view)) return fmt::format("<{}>", list(e->parts()));
  if (const auto e = as<List>(view)) {
    const auto loop = e->generator();
    if (!loop) return fmt::format("[{}]", list(e->elements()));
    const std::string to = loop->to() ? fmt::format("..{}", part(loop->to())) : "";
    return fmt::format("[{} for {} in {}{}]", list(e->elements()), word(loop->name()), part(loop->from()), to);
  }
  if (const auto e = as<If>(view)) {
    return fmt::format("{{{} ? {} : {}}}", part(e->condition()), part(e->then()), part(e->otherwise()));
  }
  return std::string(source.slice(view.span()));
}

std::string shape(const std::string& text) {
  const Source source("expression", text);
  const Parsed parsed = parse_expression(source);
  const auto expr = child<Expr>(root(parsed.tree));
  if (!parsed.errors.empty()) return "an error";
  return expr ? shape(*expr, source) : "nothing";
}

TEST(Expression, OperatorsBindAsInSchool) {
  EXPECT_EQ(shape("1 + 2 * 3 - 4"), "((1 + (2 * 3)) - 4)");
  EXPECT_EQ(shape("a / b / c"), "((a / b) / c)");
  EXPECT_EQ(shape("2 ^ 3 ^ 2"), "(2 ^ (3 ^ 2))");
  EXPECT_EQ(shape("-a ^ 2"), "(- (a ^ 2))");
  EXPECT_EQ(shape("2 ^ -a * b"), "((2 ^ (- a)) * b)");
  EXPECT_EQ(shape("-a * b"), "((- a) * b)");
  EXPECT_EQ(shape("a - -b"), "(a - (- b))");
  EXPECT_EQ(shape("not a < b and c or d"), "(((not (a < b)) and c) or d)");
  EXPECT_EQ(shape("a == b + 1 or c != d"), "((a == (b + 1)) or (c != d))");
  EXPECT_EQ(shape("a and not not b"), "(a and (not (not b)))");
}

TEST(Expression, ComparisonsDoNotChain) {
  EXPECT_EQ(shape("a < b < c"), "an error");
  EXPECT_EQ(shape("not a < b < c"), "an error");
  EXPECT_EQ(shape("(a < b) == c"), "(<(a < b)> == c)");
}

TEST(Expression, NumbersTakeTheirUnit) {
  EXPECT_EQ(shape("60cm"), "60_cm");
  EXPECT_EQ(shape("60 cm"), "60_cm");
  EXPECT_EQ(shape("19.2 mg/cm^2"), "19.2_mg/cm^2");
  EXPECT_EQ(shape("0.65 gf/cm/deg"), "0.65_gf/cm/deg");
  EXPECT_EQ(shape("2 gf*cm^2/cm"), "2_gf*cm^2/cm");
  EXPECT_EQ(shape("1e-6"), "1e-6");
  EXPECT_EQ(shape("2.5E3mm"), "2.5E3_mm");
  EXPECT_EQ(shape("3.5% * w"), "(3.5_% * w)");
}

TEST(Expression, WhatIsNoUnitIsDividedBy) {
  EXPECT_EQ(shape("60cm/w"), "(60_cm / w)");
  EXPECT_EQ(shape("60cm/s"), "60_cm/s");
  EXPECT_EQ(shape("60cm / s"), "(60_cm / s)");
  EXPECT_EQ(shape("60cm/4"), "(60_cm / 4)");
  EXPECT_EQ(shape("60cm^n"), "(60_cm ^ n)");
  EXPECT_EQ(shape("60cm*size"), "(60_cm * size)");
  EXPECT_EQ(shape("2 * m"), "(2 * m)");
}

TEST(Expression, RangesDoNotEatDots) {
  EXPECT_EQ(shape("[i for i in 1..3]"), "[i for i in 1..3]");
}

TEST(Expression, PostfixesChain) {
  EXPECT_EQ(shape("form.waist.girth"), "form.waist.girth");
  EXPECT_EQ(shape("f(a, width: 2cm,)(b)[i].x"), "f(a, width: 2_cm)(b)[i].x");
  EXPECT_EQ(shape("-f(x) ^ 2"), "(- (f(x) ^ 2))");
  EXPECT_EQ(shape("a.fold.if"), "a.fold.if");
}

TEST(Expression, BracketsGroupAndMakePoints) {
  EXPECT_EQ(shape("(a)"), "<a>");
  EXPECT_EQ(shape("(0cm, -b)"), "<0_cm, (- b)>");
  EXPECT_EQ(shape("(1, 2, 3)"), "<1, 2, 3>");
  EXPECT_EQ(shape("[]"), "[]");
  EXPECT_EQ(shape("[1, (2, 3),]"), "[1, <2, 3>]");
  EXPECT_EQ(shape("[f(p) for p in points]"), "[f(p) for p in points]");
  EXPECT_EQ(shape("()"), "an error");
  EXPECT_EQ(shape("(1, 2, 3, 4)"), "an error");
}

TEST(Expression, ChoiceMayStandOnThreeLines) {
  EXPECT_EQ(shape("if a > 1cm then b else c + 1"), "{(a > 1_cm) ? b : (c + 1)}");
  EXPECT_EQ(shape("if a\n  then b\n  else if c then d\n  else e"), "{a ? b : {c ? d : e}}");
}

TEST(Expression, GoesOnOverLineEndsOnlyWhereItCannotEnd) {
  EXPECT_EQ(shape("a +\n  b"), "(a + b)");
  EXPECT_EQ(shape("(a\n  + b)"), "<(a + b)>");
  EXPECT_EQ(shape("f(\n  a,  // one\n  b\n)"), "f(a, b)");
  EXPECT_EQ(shape("(\n  if a then b else c)"), shape("(if a then b else c)"));
  EXPECT_EQ(shape("a\n+ b"), "an error");
}

TEST(Expression, MostKeywordsCanNameValues) {
  EXPECT_EQ(shape("length + ease - label"), "((length + ease) - label)");
  EXPECT_EQ(shape("line(a, b)"), "line(a, b)");
  EXPECT_EQ(shape("through - radius"), "(through - radius)");
  EXPECT_EQ(shape("then + 1"), "an error");
}

TEST(Values, OfNumbersAndTexts) {
  const auto value = [](const std::string& text) {
    const Source source("expression", text);
    const Parsed parsed = parse_expression(source);
    return number_value(child<Number>(root(parsed.tree))->digits().value(), source);
  };
  EXPECT_EQ(value("2.5cm"), 2.5);
  EXPECT_EQ(value("1e-6"), 1e-6);
  EXPECT_EQ(value("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(value("1e-999"), 0);

  const Source source("expression", R"("a \"b\" \\ \n é")");
  const Parsed parsed = parse_expression(source);
  EXPECT_EQ(string_value(child<String>(root(parsed.tree)).value(), source), "a \"b\" \\ \n é");
}

TEST(Values, InTexts) {
  const Source source("expression", R"("a {n}{ w + 1cm in mg/cm^2 } \{b}")");
  const Parsed parsed = parse_expression(source);
  EXPECT_TRUE(parsed.errors.empty());
  const String text = child<String>(root(parsed.tree)).value();
  ASSERT_EQ(text.pieces().size(), 3u);
  EXPECT_EQ(string_value(text.pieces()[0], source), "a ");
  EXPECT_EQ(string_value(text.pieces()[1], source), "");
  EXPECT_EQ(string_value(text.pieces()[2], source), " {b}");
  EXPECT_EQ(source.slice(text.inserted()[1].value()->span()), "w + 1cm");
  EXPECT_EQ(source.slice(text.inserted()[1].unit()->span()), "mg/cm^2");
}

TEST(Values, ByNameAndByCondition) {
  const Source source("expression", "[(name: \"S\", at: (1cm, 2cm)) for i in 1..4 if i > 2]");
  const Parsed parsed = parse_expression(source);
  EXPECT_TRUE(parsed.errors.empty());
  const List list = child<List>(root(parsed.tree)).value();
  EXPECT_EQ(source.slice(list.generator()->condition()->span()), "i > 2");
  const auto record = as<RecordLiteral>(list.elements().at(0));
  ASSERT_TRUE(record);
  EXPECT_EQ(source.slice(record->fields().at(1).name()->span()), "at");
}

}  // namespace
}  // namespace toile::syntax
