#include "runtime/driver/choice.hpp"

#include <fmt/format.h>

#include "compiler/diag/nearest.hpp"

namespace toile {
namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

std::optional<int> choose(Workroom& workroom, const std::vector<std::string>& names, const std::string& wanted,
                          const std::string& kind) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == wanted) return static_cast<int>(i);
  }
  const std::string listed = fmt::format("{}", fmt::join(names, ", "));
  if (names.empty()) {
    workroom.wrong_usage(fmt::format("{} has no {}", workroom.script(), kind));
  } else if (wanted.empty()) {
    workroom.wrong_usage(fmt::format("{} has several: {}", workroom.script(), listed),
                         fmt::format("say which with --{} NAME", kind));
  } else {
    workroom.wrong_usage(fmt::format("{} has no {} called {}", workroom.script(), kind, wanted),
                         suggestion(wanted, names));
  }
  return std::nullopt;
}

/// The script's first drape command for that garment, or for any when `garment` is negative.
std::optional<DrapeCommand> first_drape(Workroom& workroom, int garment) {
  while (const std::optional<Command> command = workroom.next()) {
    const auto* drape = std::get_if<DrapeCommand>(&*command);
    if (drape == nullptr) continue;
    if (garment < 0 || drape->garment == garment) return *drape;
    Result unsolved;  // later lines may mention its fields; none of those lines is carried out
    for (const auto& [field, unit] : result_schema()) unsolved[field] = 0;
    workroom.program().give(unsolved);
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> choose_garment(Workroom& workroom, const std::string& name) {
  const std::vector<std::string> names = names_of(workroom.program().garments());
  if (name.empty() && names.size() == 1) return 0;
  return choose(workroom, names, name, "garment");
}

std::optional<DrapeCommand> choose_drape(Workroom& workroom, const std::string& garment, const std::string& body) {
  int wanted = -1;
  if (!garment.empty()) {
    const std::optional<int> found = choose_garment(workroom, garment);
    if (!found) return std::nullopt;
    wanted = *found;
  }
  std::optional<DrapeCommand> command = first_drape(workroom, wanted);
  if (workroom.outcome().exit_code() != 0) return std::nullopt;
  const std::vector<std::string> bodies = names_of(workroom.program().bodies());
  if (!command) {
    const std::optional<int> found = choose_garment(workroom, garment);
    if (!found) return std::nullopt;
    command.emplace();
    command->garment = *found;
    command->written = workroom.program().garments()[static_cast<std::size_t>(*found)].written;
    if (bodies.size() == 1) command->body = 0;
    if (bodies.size() > 1 && body.empty()) return choose(workroom, bodies, body, "body"), std::nullopt;
  }
  if (!body.empty()) {
    const std::optional<int> found = choose(workroom, bodies, body, "body");
    if (!found) return std::nullopt;
    command->body = *found;
  }
  return command;
}

}  // namespace toile
