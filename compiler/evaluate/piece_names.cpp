// A piece's names: its lets, edges, holes, lines and notches.
#include <fmt/format.h>

#include <map>

#include "compiler/evaluate/curves.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/pieces.hpp"
#include "compiler/evaluate/repetition.hpp"
#include "compiler/evaluate/solve.hpp"
#include "compiler/evaluate/walk.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

/// Edges that the pen walks one after another: an outline, a hole or a line.
struct Walk {
  const Scope* scope = nullptr;          // in which their names are
  const PieceInstance* piece = nullptr;  // of whose plan they are; null where they are read in that scope
  const std::vector<PlannedEdge>* edges = nullptr;
  std::optional<syntax::Expr> origin;
  const char* begins = "";  // what the origin is
};

/// In which what is written of an edge is read.
const Scope& read_in(const Walk& loop, const PlannedEdge& edge) {
  if (edge.scope != nullptr) return *edge.scope;
  return loop.piece == nullptr ? *loop.scope : loop.piece->scope_of(edge.written);
}

Definition* definition_of(const Walk& loop, std::size_t edge) {
  return loop.scope->own((*loop.edges)[edge].name);
}

/// The curve of the i-th edge: walks on from the one before it.
Value edge_curve(Session& session, const Walk& loop, std::size_t i) {
  const Scope& at_start = loop.piece == nullptr || !loop.origin ? *loop.scope : loop.piece->scope_of(*loop.origin);
  const std::optional<Vec2> start = Wanted{session, at_start}.point(loop.origin, loop.begins);
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
  auto curve = walk(session, read_in(loop, edge), edge.written, *pen, *start);
  return curve ? curve_value(std::move(*curve)) : Value{};
}

/// Puts the edges of each `for` out, one behind the other: side1, side2, … And `side` is the list of all of them.
bool put_out(Session& session, PieceInstance& piece) {
  std::vector<PlannedEdge> edges;
  std::map<std::string, std::vector<std::string>> repeated;
  std::map<std::string, std::pair<const Module*, syntax::Token>> names;
  bool good = true;
  for (const PlannedEdge& planned : piece.plan.edges) {
    if (!planned.each) {
      edges.push_back(planned);
      continue;
    }
    const auto known =
        for_each_value(session, piece.scope_of(*planned.each), *planned.each->values(), piece.turns, [&](const Scope&) {
          const Scope& turn = *piece.turns.back();
          for (const syntax::View item : syntax::items(*planned.each)) {
            const auto edge = syntax::as<syntax::Edge>(item);
            if (!edge || !edge->name()) continue;
            const std::string name = session.name_of(turn.module(), edge->name());
            std::vector<std::string>& all = repeated[name];
            names.try_emplace(name, &turn.module(), *edge->name());
            all.push_back(fmt::format("{}{}", name, all.size() + 1));
            edges.push_back({all.back(), *edge, std::nullopt, &turn});
          }
        });
    good = good && known.has_value();
  }
  piece.edges = std::move(edges);
  for (const auto& [name, all] : repeated) {
    Definition* made =
        define(session, *piece.scope, *names.at(name).first, names.at(name).second, [&session, &piece, each = all] {
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
    const Module& module = read_in(loop, edge).module();
    Definition* made = edge.scope == nullptr ? define(session, scope, module, edge.written.name(), curve)
                                             : scope.define(edge.name, module.at(*edge.written.name()), curve);
    if (made == nullptr && edge.scope != nullptr) {
      session.report.add(Problem("E0102", fmt::format("edge `{}` is drawn twice", edge.name))
                             .at(module.at(*edge.written.name()), "drawn again here, by `for`")
                             .also(scope.own(edge.name)->at, "first drawn here"));
    }
    if (made != nullptr) made->yields = true;
    good = good && made != nullptr;
  }
  return good;
}

void define_inner(Session& session, PieceInstance& piece, const syntax::Inner& written) {
  InnerInstance& inner = *piece.inner.emplace_back(std::make_unique<InnerInstance>());
  const Scope& around = piece.scope_of(written);
  Module& module = around.module();
  inner.name = session.name_of(module, written.name());
  inner.written = written;
  inner.scope = std::make_unique<Scope>(module, &around);
  for (const syntax::View item : syntax::items(written)) {
    const auto edge = syntax::as<syntax::Edge>(item);
    if (edge && edge->name()) inner.edges.push_back({session.name_of(module, edge->name()), *edge});
  }
  const Walk walk{inner.scope.get(), nullptr, &inner.edges, written.origin(),
                  written.is_line() ? "the place where a line begins" : "the place where a hole begins"};
  if (!define_edges(session, *inner.scope, walk)) piece.sound = false;
  if (!written.name()) return;
  Definition* made =
      define(session, *piece.scope, module, written.name(), [&inner]() -> Value { return InnerRef{&inner}; });
  if (made != nullptr) made->yields = true;
  if (made == nullptr) piece.sound = false;
}

/// The name of a notch stands for its place: the point where it is drawn.
void define_notch(Session& session, PieceInstance& piece, const syntax::Notch& notch) {
  const Module& module = piece.plan.module_of(notch);
  Definition* made = define(session, *piece.scope, module, notch.name(), [&session, &piece, &module, notch]() -> Value {
    const auto position = notch.position();
    if (!position) return Unknown{};
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
    const Value where = evaluate(session, piece.scope_of(notch), position->where());
    if (curve == nullptr || curve->curve == nullptr || where.unknown()) return Unknown{};  // told with the notch itself
    const auto s = arc_length_at(session, *curve->curve, where, module.at(*position->where()), "the end of the edge");
    return s ? Value{Point{dimension::length, curve->curve->at(*s)}} : Value{};
  });
  if (made == nullptr) piece.sound = false;
}

/// Around a variation: its models' parameters, where it has any.
const Scope* parameters_of_models(Session& session, PieceInstance& piece) {
  for (const PieceSource& source : piece.plan.sources) {
    if (source.model == &piece || !source.model->written.parameters()) continue;
    if (piece.parameters == nullptr) {
      piece.parameters = std::make_unique<Scope>(piece.outer->module(), piece.outer);
    }
    for (const auto& parameter : source.model->outer->definitions()) {
      piece.parameters->define(parameter->name, parameter->at,
                               [&session, given = parameter.get()] { return force(session, *given); });
    }
  }
  return piece.parameters == nullptr ? piece.outer : piece.parameters.get();
}

}  // namespace

void define_piece_names(Session& session, PieceInstance& piece) {
  piece.scope = std::make_unique<Scope>(piece.outer->module(), parameters_of_models(session, piece));
  for (const PieceSource& source : piece.plan.sources) {
    const PieceInstance* model = source.model;
    if (model == &piece || piece.elsewhere.contains(model)) continue;
    std::vector<const Scope*> models{model->scope.get()};
    if (model->written.parameters()) models.push_back(model->outer);  // a let replaces a parameter as well
    piece.elsewhere[model] =
        std::make_unique<Scope>(model->outer->module(), model->outer, *piece.scope, std::move(models));
  }
  for (const syntax::Let& let : piece.plan.lets) {
    const Scope& scope = piece.scope_of(let);
    Definition* made = define(session, *piece.scope, scope.module(), let.name(),
                              [&session, &scope, expr = let.value()] { return evaluate(session, scope, expr); });
    if (made != nullptr) made->is_let = true;
  }
  for (const syntax::Solve& solve : piece.plan.solves) {
    define_solve(session, *piece.scope, piece.scope_of(solve), solve);
  }
  if (!put_out(session, piece)) piece.sound = false;
  const auto& outline = piece.plan.outline;
  const Walk loop{piece.scope.get(), &piece, &piece.edges, outline ? outline->origin() : std::nullopt,
                  "the place where an outline begins"};
  if (!define_edges(session, *piece.scope, loop)) piece.sound = false;
  for (const syntax::Inner& inner : piece.plan.inner) define_inner(session, piece, inner);
  for (const Repeated& detail : piece.plan.details) {
    const auto notch = syntax::as<syntax::Notch>(detail.written);
    if (notch && notch->name() && !detail.each) define_notch(session, piece, *notch);
  }
}

}  // namespace toile
