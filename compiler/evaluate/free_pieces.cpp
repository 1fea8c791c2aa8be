#include "compiler/evaluate/free_pieces.hpp"

#include <fmt/format.h>

#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"

namespace toile {
namespace {

/// The piece that a value is; null for none, which is reported.
PieceInstance* as_piece(Session& session, const Value& value, Location at) {
  if (const auto* piece = value.as<PieceRef>()) return *piece;
  if (value.unknown()) return nullptr;
  const auto* form = value.as<PieceTemplateRef>();
  if (form == nullptr) {
    session.report.add(
        Problem("E0202", "a piece is wanted here, and this is " + describe(value)).at(at, describe(value)));
    return nullptr;
  }
  for (const Formal& formal : formals_of(session, (*form)->scope->module(), (*form)->written.parameters())) {
    if (formal.optional) continue;
    session.report.add(
        Problem("E0108", fmt::format("piece `{}` needs `{}`", (*form)->name, formal.name)).at(at, "not given here"));
    return nullptr;
  }
  const Value made = instantiate(session, **form, {});
  const auto* piece = made.as<PieceRef>();
  return piece == nullptr ? nullptr : *piece;
}

/// The piece that is taken or varied: behind the `=`.
PieceInstance* model_of(Session& session, const Scope& scope, const syntax::Piece& written) {
  if (const auto taken = written.taken()) {
    return as_piece(session, evaluate(session, scope, taken), scope.module().at(*taken));
  }
  const auto base = written.base();
  if (!base) return nullptr;
  return as_piece(session, look_up(session, scope, *base, Wish::Value), scope.module().at(*base));
}

/// A piece that stands by itself, in a garment that has no other one.
PieceInstance& by_itself(Session& session, const Scope& outer, const syntax::Piece& written, const std::string& name) {
  GarmentInstance& around = *session.garment_instances.emplace_back(std::make_unique<GarmentInstance>());
  around.draft.name = name;
  auto made = std::make_unique<PieceInstance>();
  PieceInstance& piece = *made;
  piece.name = name;
  piece.garment = &around;
  piece.outer = &outer;
  piece.written = written;
  around.add(std::move(made));
  return piece;
}

/// Its statements, and those of the piece that it varies, if any; then its names.
void plan(Session& session, PieceInstance& piece, GarmentInstance& around) {
  PiecePlanner planner(session, around);
  if (!piece.written.varies()) {
    planner.plan_all();
  } else if (const PieceInstance* model = model_of(session, *piece.outer, piece.written)) {
    planner.vary(piece, *model);
  } else {
    piece.sound = false;
  }
  define_piece_names(session, piece);
}

/// The parameters' names are those of the garment around it.
PieceInstance& drawn(Session& session, const Scope& scope, const syntax::Piece& written, const std::string& name,
                     const std::vector<std::optional<Given>>& arguments) {
  std::string kinds;
  for (const auto& argument : arguments) kinds += argument ? signature(argument->value) : "-";
  auto parameters = std::make_unique<Scope>(scope.module(), &scope, false, kinds);
  Scope& inside = *parameters;
  PieceInstance& piece = by_itself(session, inside, written, name);
  piece.garment->scope = std::move(parameters);
  if (const auto formals = written.parameters()) define_parameters(session, inside, *formals, arguments);
  plan(session, piece, *piece.garment);
  for (const auto& parameter : inside.definitions()) force(session, *parameter);
  return piece;
}

}  // namespace

void define_free_piece(Session& session, Scope& scope, const syntax::Piece& written) {
  const std::string name = session.name_of(scope.module(), written.name());
  if (written.parameters()) {
    session.piece_templates.push_back({written, &scope, name});
    define(session, scope, written.name(),
           [piece = PieceTemplateRef{&session.piece_templates.back()}]() -> Value { return piece; });
    return;
  }
  define(session, scope, written.name(), [&session, &scope, written, name]() -> Value {
    if (const auto taken = written.taken(); taken && !written.varies()) return evaluate(session, scope, taken);
    PieceInstance& piece = drawn(session, scope, written, name, {});
    draft_piece(session, piece);  // mistakes are told though no garment may ever take it
    return PieceRef{&piece};
  });
}

Value instantiate(Session& session, const PieceTemplate& piece, const std::vector<std::optional<Given>>& arguments) {
  if (session.supposing > 0) return Unknown{};  // nothing is cut on supposition
  return PieceRef{&drawn(session, *piece.scope, piece.written, piece.name, arguments)};
}

Value take(Session& session, PieceInstance& piece) {
  if (piece.written.varies()) {
    PieceInstance& varied = by_itself(session, *piece.outer, piece.written, piece.name);
    GarmentInstance& alone = *varied.garment;
    varied.garment = piece.garment;
    plan(session, varied, alone);
    piece.taken = &varied;
  } else {
    piece.taken = model_of(session, *piece.outer, piece.written);
  }
  piece.sound = piece.taken != nullptr;
  return piece.sound ? Value{PieceRef{piece.taken}} : Value{};
}

DraftPiece draft_taken(Session& session, PieceInstance& piece) {
  const Module& module = piece.garment->scope->module();
  DraftPiece draft;
  if (piece.taken != nullptr && piece.taken->sound) draft = draft_piece(session, *piece.taken);
  piece.sound = piece.sound && piece.taken != nullptr && piece.taken->sound;
  draft.name = piece.name;
  const auto name = piece.written.name();
  draft.written = name ? module.at(*name) : module.at(piece.written);
  return draft;
}

}  // namespace toile
