#include "runtime/driver/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compiler/diag/codes.hpp"
#include "compiler/diag/nearest.hpp"
#include "compiler/diag/pages.hpp"

namespace toile {
namespace {

std::string_view without_last_line_end(std::string_view text) {
  return text.ends_with('\n') ? text.substr(0, text.size() - 1) : text;
}

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace

Outcome explain(const std::string& code, Listener& listener) {
  Outcome outcome;
  if (code.empty()) {
    for (const CodeEntry& entry : code_registry()) listener.printed(fmt::format("{}  {}", entry.code, entry.title));
    return outcome;
  }
  const std::string wanted = upper_case(code);
  const auto page = std::ranges::find(error_pages(), wanted, &ErrorPage::code);
  if (page != error_pages().end()) {
    listener.printed(std::string(without_last_line_end(page->text)));
    return outcome;
  }
  std::vector<std::string> known;
  for (const ErrorPage& each : error_pages()) known.emplace_back(each.code);
  const std::string near = suggestion(wanted, known);
  listener.failed(fmt::format("no diagnostic has the code {}", code),
                  near.empty() ? "toile explain alone lists them all" : near);
  outcome.wrong_usage = true;
  return outcome;
}

}  // namespace toile
