#include "compiler/evaluate/instances.hpp"

#include <algorithm>

namespace toile {

bool Module::broken(Span span) const {
  return std::any_of(parsed.errors.begin(), parsed.errors.end(), [&](const syntax::SyntaxError& error) {
    return error.span.begin <= span.end && span.begin <= error.span.end;
  });
}

std::vector<std::string> PieceInstance::edge_names() const {
  if (taken != nullptr) return taken->edge_names();
  std::vector<std::string> names;
  for (const PlannedEdge& edge : plan.edges) names.push_back(edge.name);
  return names;
}

const HoleInstance* PieceInstance::hole(std::string_view hole_name) const {
  if (taken != nullptr) return taken->hole(hole_name);
  const auto found =
      std::find_if(holes.begin(), holes.end(), [&](const auto& each) { return each->name == hole_name; });
  return found == holes.end() || hole_name.empty() ? nullptr : found->get();
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
