// A piece's names and its draft.
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
#include "compiler/evaluate/repetition.hpp"
#include "compiler/evaluate/solve.hpp"
#include "compiler/evaluate/walk.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

constexpr int most_plies = 20;

/// Edges that the pen walks one after another: an outline, a hole or a line.
struct Walk {
  const Scope* scope = nullptr;
  const std::vector<PlannedEdge>* edges = nullptr;
  std::optional<syntax::Expr> origin;
  const char* begins = "";  // what the origin is
};

Definition* definition_of(const Walk& loop, std::size_t edge) {
  return loop.scope->own((*loop.edges)[edge].name);
}

/// The curve of the i-th edge: walks on from the one before it.
Value edge_curve(Session& session, const Walk& loop, std::size_t i) {
  const std::optional<Vec2> start = Wanted{session, *loop.scope}.point(loop.origin, loop.begins);
  std::optional<Vec2> pen = start;
  if (i > 0) {
    // One after another, so that a long outline is no deep recursion.
    std::size_t first = i;
    const auto fresh = [&](std::size_t edge) {
      const Definition* definition = definition_of(loop, edge);
      return definition != nullptr && definition->state == Definition::State::Fresh;
    };
    while (first > 0 && fresh(first - 1)) --first;
    for (std::size_t earlier = first; earlier + 1 < i; ++earlier) force(session, *definition_of(loop, earlier));
    Definition* before = definition_of(loop, i - 1);
    const Value value = before == nullptr ? Value{} : force(session, *before);
    const auto* curve = value.as<PlaneCurve>();
    pen = curve != nullptr && curve->curve ? std::optional(curve->curve->end()) : std::nullopt;
  }
  if (!pen || !start) return Unknown{};
  const PlannedEdge& edge = (*loop.edges)[i];
  auto curve = walk(session, edge.scope != nullptr ? *edge.scope : *loop.scope, edge.written, *pen, *start);
  return curve ? curve_value(std::move(*curve)) : Value{};
}

/// Puts the edges of each `for` out, one behind the other: side1, side2, … And `side` is the list of all of them.
bool put_out(Session& session, PieceInstance& piece) {
  std::vector<PlannedEdge> edges;
  std::map<std::string, std::vector<std::string>> repeated;
  std::map<std::string, syntax::Token> names;
  bool good = true;
  for (const PlannedEdge& planned : piece.plan.edges) {
    if (!planned.each) {
      edges.push_back(planned);
      continue;
    }
    const auto known = for_each_value(session, *piece.scope, *planned.each->values(), piece.turns, [&](const Scope&) {
      const Scope& turn = *piece.turns.back();
      for (const syntax::View item : syntax::items(*planned.each)) {
        const auto edge = syntax::as<syntax::Edge>(item);
        if (!edge || !edge->name()) continue;
        const std::string name = session.name_of(turn.module(), edge->name());
        std::vector<std::string>& all = repeated[name];
        names.emplace(name, *edge->name());
        all.push_back(fmt::format("{}{}", name, all.size() + 1));
        edges.push_back({all.back(), *edge, std::nullopt, &turn});
      }
    });
    good = good && known.has_value();
  }
  piece.plan.edges = std::move(edges);
  for (const auto& [name, all] : repeated) {
    Definition* made = define(session, *piece.scope, names.at(name), [&session, &piece, each = all] {
      std::vector<Value> curves;
      for (const std::string& edge : each) curves.push_back(force(session, *piece.scope->own(edge)));
      return list_value(std::move(curves));
    });
    if (made != nullptr) made->yields = true;
    good = good && made != nullptr;
  }
  return good;
}

/// False when a name is taken.
bool define_edges(Session& session, Scope& scope, const Walk& loop) {
  bool good = true;
  for (std::size_t i = 0; i < loop.edges->size(); ++i) {
    const PlannedEdge& edge = (*loop.edges)[i];
    const auto curve = [&session, loop, i] { return edge_curve(session, loop, i); };
    Definition* made = edge.scope == nullptr ? define(session, scope, edge.written.name(), curve)
                                             : scope.define(edge.name, scope.module().at(*edge.written.name()), curve);
    if (made == nullptr && edge.scope != nullptr) {
      session.report.add(Problem("E0102", fmt::format("edge `{}` is drawn twice", edge.name))
                             .at(scope.module().at(*edge.written.name()), "drawn again here, by `for`")
                             .also(scope.own(edge.name)->at, "first drawn here"));
    }
    if (made != nullptr) made->yields = true;
    good = good && made != nullptr;
  }
  return good;
}

void define_inner(Session& session, PieceInstance& piece, const syntax::Inner& written) {
  InnerInstance& inner = *piece.inner.emplace_back(std::make_unique<InnerInstance>());
  Module& module = piece.scope->module();
  inner.name = session.name_of(module, written.name());
  inner.written = written;
  inner.scope = std::make_unique<Scope>(module, piece.scope.get());
  for (const syntax::View item : syntax::items(written)) {
    const auto edge = syntax::as<syntax::Edge>(item);
    if (edge && edge->name()) inner.edges.push_back({session.name_of(module, edge->name()), *edge});
  }
  const Walk walk{inner.scope.get(), &inner.edges, written.origin(),
                  written.is_line() ? "the place where a line begins" : "the place where a hole begins"};
  if (!define_edges(session, *inner.scope, walk)) piece.sound = false;
  if (!written.name()) return;
  Definition* made = define(session, *piece.scope, written.name(), [&inner]() -> Value { return InnerRef{&inner}; });
  if (made != nullptr) made->yields = true;
  if (made == nullptr) piece.sound = false;
}

class PieceDrafter {
 public:
  PieceDrafter(Session& session, PieceInstance& piece)
      : session_(session), piece_(piece), module_(piece.scope->module()), wanted_{session, *piece.scope} {}

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

  void read_chart(const syntax::Expr& on) {
    draft_.chart = chart_of(session_, evaluate(session_, *piece_.scope, on), module_.at(on), *piece_.garment);
    if (!draft_.chart) fail();
  }

  void read_outline() {
    if (!piece_.plan.outline) {
      fail();
      if (module_.broken(piece_.written.span()) || piece_.written.base()) return;
      session_.report.add(Problem("E0304", fmt::format("piece `{}` has no outline", piece_.name))
                              .at(draft_.written)
                              .help("outline from (0cm, 0cm) { ... }"));
      return;
    }
    read_edges(piece_.plan.edges, *piece_.scope, draft_.outline);
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
      into.push_back({edge.name, *curve->curve, module_.at(edge.written)});
    }
  }

  void read_inner(const InnerInstance& inner) {
    DraftInner made{inner.name, {}, module_.at(inner.written)};
    read_edges(inner.edges, *inner.scope, made.edges);
    (inner.written.is_line() ? draft_.lines : draft_.holes).push_back(std::move(made));
  }

  /// The drawn edge of that name; null with an error when there is none, null alone when its curve is not sound.
  const DraftEdge* edge(const std::optional<syntax::Token>& token) {
    if (!token || !piece_.plan.outline) return nullptr;
    const std::string name = session_.name_of(module_, token);
    for (const DraftEdge& each : draft_.outline) {
      if (each.name == name) return &each;
    }
    fail();
    const std::vector<std::string> known = piece_.edge_names();
    if (std::find(known.begin(), known.end(), name) != known.end()) return nullptr;
    report_unknown(session_, module_, *token, fmt::format("piece `{}` has no edge `{}`", piece_.name, name), known,
                   "E0308");
    return nullptr;
  }

  void read_fold() {
    if (!piece_.plan.fold) return;
    draft_.fold_written = module_.at(*piece_.plan.fold);
    if (const DraftEdge* line = edge(piece_.plan.fold->edge())) draft_.fold = line->name;
  }

  void read_cut() {
    if (!piece_.plan.cut) return;
    draft_.mirrored = piece_.plan.cut->mirrored();
    const auto count = wanted_.count(piece_.plan.cut->count(), "how often a piece is cut");
    if (!count) return fail();
    draft_.quantity = *count;
    read_own_cloth(*piece_.plan.cut);
    if (!draft_.mirrored || *count % 2 == 0) return;
    fail();
    session_.report.add(Problem("E0209", "pieces cut in mirrored pairs are even in number")
                            .at(module_.at(*piece_.plan.cut))
                            .help(fmt::format("cut {} mirrored", *count + 1)));
  }

  /// `cut 2 in fabrics.silk plies 2`.
  void read_own_cloth(const syntax::Cut& cut) {
    if (piece_.plan.on && (cut.fabric() || cut.plies())) {
      fail();
      session_.report.add(Problem("E0209", "pieces drawn on a body are developed in the garment's own cloth")
                              .at(module_.at(cut))
                              .help("give this cloth to the garment: garment NAME in FABRIC"));
      return;
    }
    if (cut.fabric()) draft_.fabric = wanted_.fabric(*cut.fabric());
    if (cut.plies()) draft_.plies = wanted_.count(cut.plies(), "the number of plies", most_plies).value_or(0);
    if ((cut.fabric() && !draft_.fabric) || draft_.plies == 0) fail();
  }

  /// `grain sideways`: reported.
  bool is_unknown_word(const syntax::Expr& expr) {
    const std::string word(session_.text(module_, expr));
    if (expr.kind() != syntax::Kind::NameRef || piece_.scope->find(word) != nullptr) return false;
    session_.report.add(Problem("E0101", fmt::format("there is no direction `{}`", word))
                            .at(module_.at(expr))
                            .help("a grain runs `down`, `up`, `left`, `right`, on the `bias`, or at an angle"));
    return true;
  }

  void read_grain() {
    if (!piece_.plan.grain) return;
    const auto word = piece_.plan.grain->direction();
    if (const auto angle_expr = piece_.plan.grain->angle()) {
      if (is_unknown_word(*angle_expr)) return fail();
      const auto angle = wanted_.quantity(angle_expr, dimension::angle, "the direction of the grain");
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
    if (draft_.chart || piece_.plan.on) return;  // a map that is wrong is told by itself
    fail();
    session_.report.add(Problem("E0103", "only a piece that is drawn on a body finds its grain by itself")
                            .at(module_.at(word))
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
    const auto width = wanted_.not_negative(allowance.width(), dimension::length, what);
    if (width) draft_.allowances.push_back({"", *width, module_.at(allowance), corner_of(allowance.corner())});
    if (!width) fail();
    std::map<std::string, Location> told;
    for (const syntax::EdgeAllowance& exception : allowance.exceptions()) {
      const auto line = named_edge(session_, piece_, *piece_.scope, draft_, exception);
      const auto own = wanted_.not_negative(exception.width(), dimension::length, what);
      if (!own || !line) fail();
      const auto [earlier, fresh] = told.try_emplace(line.value_or(""), module_.at(exception));
      if (line && !fresh) {
        fail();
        session_.report.add(Problem("E0102", fmt::format("the allowance of `{}` is told twice", *line))
                                .at(module_.at(exception), "told again here")
                                .also(earlier->second, "first told here"));
      }
      if (line && own) {
        draft_.allowances.push_back({*line, *own, module_.at(exception), corner_of(exception.corner())});
      }
    }
  }

  void read_label(const syntax::Label& label) {
    const auto text = wanted_.text(label.text(), "a label");
    if (text) draft_.label = *text;
    if (!text) fail();
  }

  Session& session_;
  PieceInstance& piece_;
  const Module& module_;
  Wanted wanted_;
  DraftPiece draft_;
};

/// The name of a notch stands for its place: the point where it is drawn.
void define_notch(Session& session, PieceInstance& piece, const syntax::Notch& notch) {
  Definition* made = define(session, *piece.scope, notch.name(), [&session, &piece, notch]() -> Value {
    const auto position = notch.position();
    if (!position) return Unknown{};
    const Module& module = piece.scope->module();
    const std::vector<syntax::Token> path = position->path();
    const Scope* scope = piece.scope.get();
    if (path.size() == 2) {
      const InnerInstance* inner = piece.inner_called(session.name_of(module, path[0]));
      if (inner == nullptr) return Unknown{};
      scope = inner->scope.get();
    }
    Definition* edge = path.empty() ? nullptr : scope->own(session.name_of(module, path.back()));
    const Value drawn = edge == nullptr ? Value{} : force(session, *edge);
    const auto* curve = drawn.as<PlaneCurve>();
    const Value where = evaluate(session, *piece.scope, position->where());
    if (curve == nullptr || curve->curve == nullptr || where.unknown()) return Unknown{};  // told with the notch itself
    const auto s = arc_length_at(session, *curve->curve, where, module.at(*position->where()), "the end of the edge");
    return s ? Value{Point{dimension::length, curve->curve->at(*s)}} : Value{};
  });
  if (made == nullptr) piece.sound = false;
}

}  // namespace

void define_piece_names(Session& session, PieceInstance& piece) {
  for (const syntax::Let& let : piece.plan.lets) {
    define(session, *piece.scope, let.name(),
           [&session, &piece, expr = let.value()] { return evaluate(session, *piece.scope, expr); });
  }
  for (const syntax::Solve& solve : piece.plan.solves) define_solve(session, *piece.scope, solve);
  if (!put_out(session, piece)) piece.sound = false;
  const auto& outline = piece.plan.outline;
  const Walk loop{piece.scope.get(), &piece.plan.edges, outline ? outline->origin() : std::nullopt,
                  "the place where an outline begins"};
  if (!define_edges(session, *piece.scope, loop)) piece.sound = false;
  for (const syntax::Inner& inner : piece.plan.inner) define_inner(session, piece, inner);
  for (const Repeated& detail : piece.plan.details) {
    const auto notch = syntax::as<syntax::Notch>(detail.written);
    if (notch && notch->name() && !detail.each) define_notch(session, piece, *notch);
  }
}

DraftPiece draft_piece(Session& session, PieceInstance& piece) {
  return PieceDrafter(session, piece).draft();
}

}  // namespace toile
