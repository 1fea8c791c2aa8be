#include "compiler/evaluate/walk.hpp"

#include <fmt/format.h>

#include <map>

#include "compiler/evaluate/curves.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/want.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

using syntax::Kind;

class Walker {
 public:
  Walker(Session& session, const Scope& scope, const syntax::Walk& walk, Vec2 pen, Vec2 start)
      : session_(session), wanted_{session, scope}, walk_(walk), pen_(pen), start_(start) {}

  std::optional<Curve> draw() {
    if (clause_given_twice()) return std::nullopt;
    std::optional<Curve> curve = drawn();
    const auto length_expr = walk_.wanted_length();
    if (!length_expr) return curve;
    const auto length = wanted_.positive(length_expr, dimension::length, "the length of an edge");
    if (!curve || !length) return std::nullopt;
    return lengthened(session_, *curve, *length, at(*length_expr));
  }

 private:
  std::optional<Curve> drawn() {
    if (walk_.kind() == Kind::CircleWalk) return whole_circle();
    if (walk_.kind() == Kind::AlongWalk) return along();
    const std::optional<Vec2> target =
        walk_.to_start() ? std::optional(start_) : wanted_.point(walk_.target(), "the target of an edge");
    switch (walk_.kind()) {
      case Kind::CurveWalk:
        return tangents(target);
      case Kind::ArcWalk:
        return arc(target);
      case Kind::BezierWalk:
        return cubic(target);
      default:
        return target ? std::optional(line(pen_, *target)) : std::nullopt;
    }
  }

  /// `leaving 0deg leaving 10deg`
  bool clause_given_twice() {
    std::map<Kind, syntax::Token> given;
    for (const syntax::Token word : syntax::all<syntax::Token>(walk_)) {
      if (!syntax::is_keyword(word.kind())) continue;
      const auto [earlier, is_new] = given.try_emplace(word.kind(), word);
      if (is_new) continue;
      session_.report.add(Problem("E0109", fmt::format("`{}` is given twice", syntax::spelling(word.kind())))
                              .at(at(word), "given again here")
                              .also(at(earlier->second), "already given here"));
      return true;
    }
    return false;
  }

  Location at(const syntax::View& view) const { return wanted_.scope.module().at(view); }

  std::optional<Curve> tangents(const std::optional<Vec2>& target) {
    const auto leaving_expr = walk_.leaving();
    const auto arriving_expr = walk_.arriving();
    const auto angle = [&](const std::optional<syntax::Expr>& expr, const char* what) {
      return expr ? wanted_.quantity(expr, dimension::angle, what) : std::nullopt;
    };
    const auto leaving = angle(leaving_expr, "the direction after `leaving`");
    const auto arriving = angle(arriving_expr, "the direction after `arriving`");
    const bool sound =
        leaving.has_value() == leaving_expr.has_value() && arriving.has_value() == arriving_expr.has_value();
    std::vector<Vec2> points{pen_};
    for (const syntax::Expr& waypoint : walk_.waypoints()) {
      const auto point = wanted_.point(waypoint, "a point after `through`");
      if (!point) return std::nullopt;
      points.push_back(*point);
    }
    if (!target || !sound) return std::nullopt;
    if (points.size() == 1) return drawn_curve(pen_, *target, leaving, arriving);
    points.push_back(*target);
    return drawn_spline(session_, points, leaving, arriving, false, at(walk_));
  }

  std::optional<Curve> arc(const std::optional<Vec2>& target) {
    if (const auto through_expr = walk_.through()) {
      const auto through = wanted_.point(through_expr, "the point after `through`");
      if (!target || !through) return std::nullopt;
      return drawn_arc(session_, pen_, *target, *through, at(*through_expr));
    }
    const auto radius_expr = walk_.radius();
    if (!radius_expr) return std::nullopt;
    Value value;
    const auto radius = wanted_.quantity(radius_expr, dimension::length, "a radius", &value);
    if (!target || !radius) return std::nullopt;
    if (*radius == 0) {
      session_.report.add(Problem("E0208", "a radius cannot be zero").at(at(*radius_expr)));
      return std::nullopt;
    }
    return drawn_arc(session_, pen_, *target, *radius, walk_.large(), at(*radius_expr));
  }

  std::optional<Curve> cubic(const std::optional<Vec2>& target) {
    const auto first = wanted_.point(walk_.first_control(), "a control point");
    const auto second = wanted_.point(walk_.second_control(), "a control point");
    if (!target || !first || !second) return std::nullopt;
    return bezier(pen_, *first, *second, *target);
  }

  std::optional<Curve> whole_circle() {
    const auto centre = wanted_.point(walk_.about(), "the centre of a circle");
    if (!centre) return std::nullopt;
    if (distance(*centre, pen_) > 0) return circle(*centre, pen_);
    session_.report.add(Problem("E0208", "a circle about the pen's own place has no radius")
                            .at(at(*walk_.about()))
                            .help("the circle passes through the pen: begin the outline on it"));
    return std::nullopt;
  }

  std::optional<Curve> along() {
    const auto expr = walk_.along();
    const Value value = evaluate_curve(session_, wanted_.scope, expr);
    if (value.unknown()) return std::nullopt;
    const auto* found = value.as<PlaneCurve>();
    if (found == nullptr) {
      wanted_.wrong(*expr, value, "what an edge goes along", "a curve");
      return std::nullopt;
    }
    if (!wanted_.there(*expr, value, "an outline")) return std::nullopt;
    constexpr double touching = 1e-6;  // [m]
    const double gap = distance(found->curve->start(), pen_);
    if (gap <= touching) return *found->curve;
    Problem problem("E0209",
                    fmt::format("this curve begins {} away from the pen", format_quantity(gap, dimension::length)));
    problem.at(at(*expr), "begins at " + place(found->curve->start()) + ", the pen is at " + place(pen_));
    if (distance(found->curve->end(), pen_) <= touching) problem.help("it ends at the pen: reverse( ) it");
    session_.report.add(problem);
    return std::nullopt;
  }

  static std::string place(Vec2 point) { return format(Point{dimension::length, point}); }

  Session& session_;
  Wanted wanted_;
  const syntax::Walk& walk_;
  Vec2 pen_;
  Vec2 start_;
};

}  // namespace

std::optional<Curve> walk(Session& session, const Scope& scope, const syntax::Edge& edge, Vec2 pen, Vec2 start) {
  const auto written = edge.walk();
  if (!written) return std::nullopt;
  return Walker(session, scope, *written, pen, start).draw();
}

}  // namespace toile
