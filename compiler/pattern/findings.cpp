#include "compiler/pattern/findings.hpp"

#include <fmt/format.h>

#include <cmath>

namespace toile {
namespace {

// At most two decimals, without trailing zeros.
std::string short_number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

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
  if (size > 0 && size < 0.5e-3) return fmt::format("{:.1g} mm", 1e3 * metres);
  return short_number(100 * metres) + " cm";
}

std::string script_cm(double metres) {
  return short_number(100 * metres) + "cm";
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
