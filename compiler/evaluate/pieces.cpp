// A piece's draft.
#include "compiler/evaluate/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "compiler/evaluate/charts.hpp"
#include "compiler/evaluate/curves.hpp"
#include "compiler/evaluate/details.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

constexpr int most_plies = 20;

class PieceDrafter {
 public:
  PieceDrafter(Session& session, PieceInstance& piece)
      : session_(session), piece_(piece), module_(piece.scope->module()) {}

  DraftPiece draft() {
    draft_.name = piece_.name;
    const auto name = piece_.written.name();
    draft_.written = name ? module_.at(*name) : module_.at(piece_.written);
    if (piece_.plan.on) read_chart(*piece_.plan.on);
    // All names are checked, also those that no edge uses.
    for (const auto& definition : piece_.scope->definitions()) force(session_, *definition);
    read_outline();
    for (const auto& inner : piece_.inner) read_inner(*inner);
    read_fold();
    read_cut();
    read_grain();
    if (!read_details(session_, piece_, draft_)) fail();
    if (piece_.plan.allowance) read_allowance(*piece_.plan.allowance);
    if (piece_.plan.label) read_label(*piece_.plan.label);
    return draft_;
  }

 private:
  void fail() { piece_.sound = false; }

  Wanted wanted_for(const syntax::View& statement) const { return {session_, piece_.scope_of(statement)}; }

  void read_chart(const syntax::Expr& on) {
    const Scope& scope = piece_.scope_of(on);
    draft_.chart = chart_of(session_, evaluate(session_, scope, on), scope.module().at(on), *piece_.garment);
    if (!draft_.chart) fail();
  }

  void read_outline() {
    if (!piece_.plan.outline) {
      fail();
      if (module_.broken(piece_.written.span()) || piece_.written.varies()) return;
      session_.report.add(Problem("E0304", fmt::format("piece `{}` has no outline", piece_.name))
                              .at(draft_.written)
                              .help("outline from (0cm, 0cm) { ... }"));
      return;
    }
    read_edges(piece_.edges, *piece_.scope, draft_.outline);
  }

  void read_edges(const std::vector<PlannedEdge>& edges, const Scope& scope, std::vector<DraftEdge>& into) {
    for (const PlannedEdge& edge : edges) {
      Definition* definition = scope.own(edge.name);
      const Value value = definition == nullptr ? Value{} : force(session_, *definition);
      const auto* curve = value.as<PlaneCurve>();
      if (curve == nullptr || curve->curve == nullptr) {
        fail();
        continue;
      }
      into.push_back({edge.name, *curve->curve, piece_.plan.module_of(edge.written).at(edge.written)});
    }
  }

  void read_inner(const InnerInstance& inner) {
    DraftInner made{inner.name, {}, piece_.plan.module_of(inner.written).at(inner.written)};
    read_edges(inner.edges, *inner.scope, made.edges);
    (inner.written.is_line() ? draft_.lines : draft_.holes).push_back(std::move(made));
  }

  /// The drawn edge of that name; null with an error when there is none, null alone when its curve is not sound.
  const DraftEdge* edge(const Module& module, const std::optional<syntax::Token>& token) {
    if (!token || !piece_.plan.outline) return nullptr;
    const std::string name = session_.name_of(module, token);
    for (const DraftEdge& each : draft_.outline) {
      if (each.name == name) return &each;
    }
    fail();
    const std::vector<std::string> known = piece_.edge_names();
    if (std::find(known.begin(), known.end(), name) != known.end()) return nullptr;
    report_unknown(session_, module, *token, fmt::format("piece `{}` has no edge `{}`", piece_.name, name), known,
                   "E0308");
    return nullptr;
  }

  void read_fold() {
    if (!piece_.plan.fold) return;
    const Module& module = piece_.plan.module_of(*piece_.plan.fold);
    draft_.fold_written = module.at(*piece_.plan.fold);
    if (const DraftEdge* line = edge(module, piece_.plan.fold->edge())) draft_.fold = line->name;
  }

  void read_cut() {
    if (!piece_.plan.cut) return;
    draft_.mirrored = piece_.plan.cut->mirrored();
    const Wanted wanted = wanted_for(*piece_.plan.cut);
    const auto count = wanted.count(piece_.plan.cut->count(), "how often a piece is cut");
    if (!count) return fail();
    draft_.quantity = *count;
    read_own_cloth(*piece_.plan.cut, wanted);
    if (!draft_.mirrored || *count % 2 == 0) return;
    fail();
    session_.report.add(Problem("E0209", "pieces cut in mirrored pairs are even in number")
                            .at(wanted.scope.module().at(*piece_.plan.cut))
                            .help(fmt::format("cut {} mirrored", *count + 1)));
  }

  /// `cut 2 in fabrics.silk plies 2`.
  void read_own_cloth(const syntax::Cut& cut, const Wanted& wanted) {
    if (piece_.plan.on && (cut.fabric() || cut.plies())) {
      fail();
      session_.report.add(Problem("E0209", "pieces drawn on a body are developed in the garment's own cloth")
                              .at(wanted.scope.module().at(cut))
                              .help("give this cloth to the garment: garment NAME in FABRIC"));
      return;
    }
    if (cut.fabric()) draft_.fabric = wanted.fabric(*cut.fabric());
    if (cut.plies()) draft_.plies = wanted.count(cut.plies(), "the number of plies", most_plies).value_or(0);
    if ((cut.fabric() && !draft_.fabric) || draft_.plies == 0) fail();
  }

  /// `grain sideways`: reported.
  bool is_unknown_word(const syntax::Expr& expr) {
    const Scope& scope = piece_.scope_of(expr);
    const std::string word(session_.text(scope.module(), expr));
    if (expr.kind() != syntax::Kind::NameRef || scope.find(word) != nullptr) return false;
    session_.report.add(Problem("E0101", fmt::format("there is no direction `{}`", word))
                            .at(scope.module().at(expr))
                            .help("a grain runs `down`, `up`, `left`, `right`, on the `bias`, or at an angle"));
    return true;
  }

  void read_grain() {
    if (!piece_.plan.grain) return;
    const auto word = piece_.plan.grain->direction();
    if (const auto angle_expr = piece_.plan.grain->angle()) {
      if (is_unknown_word(*angle_expr)) return fail();
      const auto angle = wanted_for(*angle_expr).quantity(angle_expr, dimension::angle, "the direction of the grain");
      if (angle) draft_.warp = direction(*angle);
      if (!angle) fail();
      return;
    }
    if (!word) return fail();
    switch (word->kind()) {
      case syntax::Kind::KwUp:
        draft_.warp = {0, 1};
        break;
      case syntax::Kind::KwLeft:
        draft_.warp = {-1, 0};
        break;
      case syntax::Kind::KwRight:
        draft_.warp = {1, 0};
        break;
      case syntax::Kind::KwFree:
        free_grain(*word);
        break;
      case syntax::Kind::KwBias:
        draft_.warp = direction(-std::numbers::pi / 4);
        break;
      default:
        draft_.warp = {0, -1};
        break;
    }
  }

  void free_grain(const syntax::Token& word) {
    draft_.free_grain = true;
    if (piece_.plan.on) return;  // a map that is wrong is told by itself
    fail();
    session_.report.add(Problem("E0103", "only a piece that is drawn on a body finds its grain by itself")
                            .at(piece_.plan.module_of(word).at(word))
                            .help("grain down"));
  }

  static std::optional<AllowanceCorner> corner_of(const std::optional<syntax::Token>& word) {
    if (!word) return std::nullopt;
    switch (word->kind()) {
      case syntax::Kind::KwSquare:
        return AllowanceCorner::Square;
      case syntax::Kind::KwMirrored:
        return AllowanceCorner::Mirrored;
      case syntax::Kind::KwBevelled:
        return AllowanceCorner::Bevelled;
      default:
        return AllowanceCorner::Mitred;
    }
  }

  void read_allowance(const syntax::Allowance& allowance) {
    const std::string what = "a seam allowance";
    const Wanted wanted = wanted_for(allowance);
    const Module& module = wanted.scope.module();
    const auto width = wanted.not_negative(allowance.width(), dimension::length, what);
    if (width) draft_.allowances.push_back({"", *width, module.at(allowance), corner_of(allowance.corner())});
    if (!width) fail();
    std::map<std::string, Location> told;
    for (const syntax::EdgeAllowance& exception : allowance.exceptions()) {
      const auto line = named_edge(session_, piece_, wanted.scope, draft_, exception);
      const auto own = wanted.not_negative(exception.width(), dimension::length, what);
      if (!own || !line) fail();
      const auto [earlier, fresh] = told.try_emplace(line.value_or(""), module.at(exception));
      if (line && !fresh) {
        fail();
        session_.report.add(Problem("E0102", fmt::format("the allowance of `{}` is told twice", *line))
                                .at(module.at(exception), "told again here")
                                .also(earlier->second, "first told here"));
      }
      if (line && own) {
        draft_.allowances.push_back({*line, *own, module.at(exception), corner_of(exception.corner())});
      }
    }
  }

  void read_label(const syntax::Label& label) {
    const auto text = wanted_for(label).text(label.text(), "a label");
    if (text) draft_.label = *text;
    if (!text) fail();
  }

  Session& session_;
  PieceInstance& piece_;
  const Module& module_;
  DraftPiece draft_;
};

}  // namespace

DraftPiece draft_piece(Session& session, PieceInstance& piece) {
  return PieceDrafter(session, piece).draft();
}

}  // namespace toile
