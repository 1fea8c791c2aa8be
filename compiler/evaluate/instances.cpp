#include "compiler/evaluate/instances.hpp"

#include <algorithm>

namespace toile {

bool Module::broken(Span span) const {
  return std::any_of(parsed.errors.begin(), parsed.errors.end(), [&](const syntax::SyntaxError& error) {
    return error.span.begin <= span.end && span.begin <= error.span.end;
  });
}

const PieceSource& PiecePlan::source_of(const syntax::View& statement) const {
  const Span inside = statement.span();
  const auto found = std::find_if(sources.rbegin(), sources.rend(), [&](const PieceSource& source) {
    const Span span = source.written.span();
    return source.written.tree == statement.tree && span.begin <= inside.begin && inside.end <= span.end;
  });
  return found == sources.rend() ? sources.back() : *found;
}

const Module& PiecePlan::module_of(const syntax::View& statement) const {
  return source_of(statement).model->outer->module();
}

const Scope& PieceInstance::scope_of(const syntax::View& statement) const {
  const PieceInstance* model = plan.source_of(statement).model;
  return model == this ? *scope : *elsewhere.at(model);
}

std::vector<std::string> PieceInstance::edge_names() const {
  if (taken != nullptr) return taken->edge_names();
  std::vector<std::string> names;
  for (const PlannedEdge& edge : edges) names.push_back(edge.name);
  return names;
}

const InnerInstance* PieceInstance::inner_called(std::string_view inner_name) const {
  if (taken != nullptr) return taken->inner_called(inner_name);
  const auto found =
      std::find_if(inner.begin(), inner.end(), [&](const auto& each) { return each->name == inner_name; });
  return found == inner.end() || inner_name.empty() ? nullptr : found->get();
}

PieceInstance* GarmentInstance::piece(std::string_view piece_name) const {
  const auto found = by_name_.find(piece_name);
  return found == by_name_.end() ? nullptr : found->second;
}

void GarmentInstance::add(std::unique_ptr<PieceInstance> piece) {
  by_name_.try_emplace(piece->name, piece.get());
  pieces.push_back(std::move(piece));
}

}  // namespace toile
