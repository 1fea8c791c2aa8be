#include "compiler/evaluate/detail_properties.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/evaluate/names.hpp"

namespace toile {

std::optional<std::string> DetailProperties::name(const syntax::Property& property) {
  const auto token = property.name();
  if (!token) return std::nullopt;
  std::string found = session_.name_of(module_, token);
  if (std::find(known_.begin(), known_.end(), found) == known_.end()) {
    if (!property.value()) session_.report.withdraw_syntax(module_.at(property));
    std::vector<std::string> possible = known_;
    possible.insert(possible.end(), words_.begin(), words_.end());
    report_unknown(session_, module_, *token, fmt::format("a {} has no `{}`", owner_, found), possible, "E0103");
    good_ = false;
    misspelt_ = true;
    return std::nullopt;
  }
  if (!sizes_.try_emplace(found).second) {
    session_.report.add(Problem("E0102", "`" + found + "` is given twice").at(module_.at(*token)));
    good_ = false;
    return std::nullopt;
  }
  return found;
}

void DetailProperties::set(const std::string& name, std::optional<double> value) {
  good_ = good_ && value.has_value();
  sizes_[name] = value;
}

double DetailProperties::size(const std::string& name) const {
  const auto found = sizes_.find(name);
  return found == sizes_.end() ? 0 : found->second.value_or(0);
}

bool DetailProperties::complete(std::initializer_list<const char*> needed, Span span, const std::string& help) {
  for (const char* name : needed) {
    if (has(name)) continue;
    good_ = false;
    if (module_.broken(span) || misspelt_) continue;
    session_.report.add(
        Problem("E0310", fmt::format("the {} does not tell its {}", owner_, name)).at(module_.at(span)).help(help));
  }
  return good_;
}

}  // namespace toile
