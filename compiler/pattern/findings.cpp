#include "compiler/pattern/findings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/pattern/decimal.hpp"

namespace toile {
void Findings::error(std::string code, std::string message, std::vector<Label> labels, std::string help) {
  if (!labels.empty()) labels.front().primary = true;
  diagnostics_.push_back({Severity::Error, std::move(code), std::move(message), std::move(labels), std::move(help)});
  ++errors_;
}

void Findings::warning(std::string code, std::string message, std::vector<Label> labels, std::string help) {
  if (!labels.empty()) labels.front().primary = true;
  diagnostics_.push_back({Severity::Warning, std::move(code), std::move(message), std::move(labels), std::move(help)});
}

std::string in_cm(double metres) {
  const double size = std::abs(metres);
  constexpr double rounding = 1e-9;  // [m]
  if (size > rounding && size < 0.5e-3) return fmt::format("{:.1g} mm", 1e3 * metres);
  return decimal(100 * metres, 2) + " cm";
}

std::string script_cm(double metres) {
  return decimal(100 * metres, 2) + "cm";
}

std::string quoted(const std::string& name) {
  return "`" + name + "`";
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += quoted(names[i]);
  }
  return text;
}

}  // namespace toile
