#include "runtime/driver/choice.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    const bool is_development = std::holds_alternative<DevelopCommand>(*command);
    if (drape == nullptr && !is_development) continue;
    if (drape != nullptr && drape->developed.empty() && (garment < 0 || drape->garment == garment)) return *drape;
    Result unsolved;  // later lines may mention its fields; none of those lines is carried out
    for (const auto& [field, unit] : is_development ? development_schema() : form_drape_schema()) unsolved[field] = 0;
    workroom.program().give(unsolved);
  }
  return std::nullopt;
}

std::optional<DevelopCommand> first_development(Workroom& workroom, const std::string& garment) {
  while (const std::optional<Command> command = workroom.next()) {
    Result unsolved;
    if (const auto* develop = std::get_if<DevelopCommand>(&*command)) {
      const std::string& name = workroom.program().garments()[static_cast<std::size_t>(develop->garment)].name;
      if (garment.empty() || garment == name) return *develop;
      for (const auto& [field, unit] : development_schema()) unsolved[field] = 0;
    } else if (std::holds_alternative<DrapeCommand>(*command)) {
      for (const auto& [field, unit] : form_drape_schema()) unsolved[field] = 0;
    } else {
      continue;
    }
    workroom.program().give(unsolved);
  }
  return std::nullopt;
}

}  // namespace

std::optional<DevelopCommand> choose_development(Workroom& workroom, const std::string& garment) {
  if (auto command = first_development(workroom, garment)) return command;
  if (workroom.outcome().exit_code() != 0) return std::nullopt;
  const std::vector<Garment>& garments = workroom.program().garments();
  const std::vector<BodySpec>& bodies = workroom.program().bodies();
  std::vector<std::string> names;
  for (const Garment& each : garments) {
    if (!each.drawn_on.empty()) names.push_back(each.name);
  }
  const std::optional<int> chosen =
      choose(workroom, names, names.size() == 1 && garment.empty() ? names[0] : garment, "garment drawn on a body");
  if (!chosen) return std::nullopt;
  DevelopCommand command;
  for (std::size_t g = 0; g < garments.size(); ++g) {
    if (garments[g].name != names[static_cast<std::size_t>(*chosen)]) continue;
    command.garment = static_cast<int>(g);
    command.written = garments[g].written;
    const auto body = std::find_if(bodies.begin(), bodies.end(),
                                   [&](const BodySpec& spec) { return spec.name == garments[g].drawn_on; });
    if (body == bodies.end()) {
      return workroom.wrong_usage(fmt::format("{} is drawn on a body that the script does not name", garments[g].name),
                                  "give the script a develop command"),
             std::nullopt;
    }
    command.body = static_cast<int>(body - bodies.begin());
  }
  return command;
}

std::optional<int> choose_garment(Workroom& workroom, const std::string& name) {
  const std::vector<std::string> names = names_of(workroom.program().garments());
  const std::vector<int> own = workroom.program().own_garments();
  if (name.empty() && names.size() == 1) return 0;
  if (name.empty() && own.size() == 1) return own.front();
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
  const Garment& chosen = workroom.program().garments()[static_cast<std::size_t>(command->garment)];
  if (!chosen.drawn_on.empty()) {
    workroom.wrong_usage(
        fmt::format("{} is drawn on {} and has no flat pattern to drape yet", chosen.name, chosen.drawn_on),
        fmt::format("toile develop {} -o pattern.toile", workroom.script()));
    return std::nullopt;
  }
  if (!body.empty()) {
    const std::optional<int> found = choose(workroom, bodies, body, "body");
    if (!found) return std::nullopt;
    command->body = *found;
  }
  return command;
}

}  // namespace toile
