// Lines, drill holes, buttons and buttonholes.
#include <cmath>
#include <numbers>
#include <variant>

#include "compiler/evaluate/detail_properties.hpp"
#include "compiler/evaluate/details.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

class MarkReader {
 public:
  MarkReader(Session& session, const Scope& scope, DraftPiece& draft)
      : session_(session), module_(scope.module()), wanted_{session, scope}, scope_(scope), draft_(draft) {}

  bool read(const syntax::View& written) {
    const Location at = module_.at(written);
    if (const auto mark = syntax::as<syntax::Mark>(written)) return read_line(*mark, at);
    if (const auto drill = syntax::as<syntax::Drill>(written)) {
      return add({PointMark::Kind::Drill, {}, 0, 0, at}, drill->point());
    }
    if (const auto button = syntax::as<syntax::Button>(written)) {
      return add({PointMark::Kind::Button, {}, 0, 0, at}, button->point());
    }
    const auto hole = syntax::as<syntax::Buttonhole>(written);
    return !hole || read_buttonhole(*hole, at);
  }

 private:
  bool read_line(const syntax::Mark& mark, Location at) {
    const auto expr = mark.curve();
    const Value value = evaluate(session_, scope_, expr);
    if (value.unknown()) return false;
    const auto* curve = value.as<PlaneCurve>();
    if (curve == nullptr) wanted_.wrong(*expr, value, "what is marked", "a curve");
    if (curve == nullptr || curve->curve == nullptr) return false;
    const auto fold = mark.fold();
    if (!fold) {
      draft_.marks.push_back({LineMark::Kind::Line, *curve->curve, at});
      return true;
    }
    const auto angle = wanted_.quantity(fold, dimension::angle, "the angle by which a piece is folded");
    return angle && is_straight(*curve->curve, *expr) && check_fold(session_, *angle, module_.at(*fold)) &&
           (draft_.marks.push_back({LineMark::Kind::Crease, *curve->curve, at, *angle}), true);
  }

  bool is_straight(const Curve& curve, const syntax::Expr& written) {
    if (curve.segments().size() == 1 && std::holds_alternative<LineSegment>(curve.segments()[0])) return true;
    session_.report.add(Problem("E0306", "a piece is folded along straight lines, and this is a curve")
                            .at(module_.at(written))
                            .help("mark line(from, to) folded 90deg"));
    return false;
  }

  bool add(PointMark mark, const std::optional<syntax::Expr>& point) {
    const auto place = wanted_.point(point, "the place of a mark");
    if (!place) return false;
    mark.at = *place;
    draft_.spots.push_back(mark);
    return true;
  }

  bool read_buttonhole(const syntax::Buttonhole& hole, Location at) {
    DetailProperties sizes(session_, module_, "buttonhole", {"length", "angle"});
    for (const syntax::Property& property : hole.properties()) {
      const auto name = sizes.name(property);
      if (!name) continue;
      sizes.set(*name, *name == "length"
                           ? wanted_.positive(property.value(), dimension::length, "the length of a buttonhole")
                           : wanted_.quantity(property.value(), dimension::angle, "the direction of a buttonhole"));
    }
    const bool told = sizes.complete({"length"}, hole.span(), "buttonhole at (1.5cm, -4cm) { length 2cm, angle 0deg }");
    return told && add({PointMark::Kind::Buttonhole, {}, sizes.size("length"), sizes.size("angle"), at}, hole.point());
  }

  Session& session_;
  const Module& module_;
  Wanted wanted_;
  const Scope& scope_;
  DraftPiece& draft_;
};

}  // namespace

bool check_fold(Session& session, double angle, Location written) {
  if (std::abs(angle) <= std::numbers::pi) return true;
  session.report.add(Problem("E0209", "cloth is folded by 180 degrees at most")
                         .at(written)
                         .help("0deg is flat; a positive angle has the right side outside, a negative one inside"));
  return false;
}

bool read_mark(Session& session, const Scope& scope, const syntax::View& written, DraftPiece& draft) {
  return MarkReader(session, scope, draft).read(written);
}

}  // namespace toile
