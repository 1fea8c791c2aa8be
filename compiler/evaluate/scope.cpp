#include "compiler/evaluate/scope.hpp"

#include <algorithm>

namespace toile {

Definition* Scope::own(std::string_view name) const {
  if (names_ != nullptr) {
    const auto has = [&](const Scope* model) { return model->own(name) != nullptr; };
    return std::any_of(models_.begin(), models_.end(), has) ? names_->own(name) : nullptr;
  }
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

Definition* Scope::find(std::string_view name, const Scope** where, bool prefer_edges) const {
  const Scope* place = nullptr;
  for (const Scope* scope = this; scope != nullptr; scope = scope->parent_) {
    const Definition* definition = scope->own(name);
    if (definition == nullptr) continue;
    const bool final = !definition->yields || prefer_edges;
    if (place == nullptr || final) place = scope;
    if (final) break;
  }
  if (place == nullptr) return nullptr;
  if (where != nullptr) *where = place;
  return place->own(name);
}

Definition* Scope::define(std::string name, Location at, std::function<Value()> compute) {
  if (own(name) != nullptr) {
    doubled_ = true;
    return nullptr;
  }
  definitions_.push_back(std::make_unique<Definition>());
  Definition* definition = definitions_.back().get();
  definition->name = name;
  definition->at = at;
  definition->compute = std::move(compute);
  by_name_.emplace(std::move(name), definition);
  return definition;
}

void Scope::define_value(std::string name, Location at, Value value) {
  Definition* definition = define(std::move(name), at, {});
  if (definition == nullptr) return;
  definition->value = std::move(value);
  definition->state = Definition::State::Done;
}

std::vector<std::string> Scope::own_names() const {
  std::vector<std::string> names;
  for (const Scope* model : models_) {
    for (std::string& name : model->own_names()) names.push_back(std::move(name));
  }
  for (const auto& definition : definitions_) names.push_back(definition->name);
  return names;
}

std::vector<std::string> Scope::visible_names() const {
  std::vector<std::string> names;
  for (const Scope* scope = this; scope != nullptr; scope = scope->parent_) {
    for (std::string& name : scope->own_names()) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace toile
