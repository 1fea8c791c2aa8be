#include "runtime/driver/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/syntax_errors.hpp"
#include "grammar/reference/reference.hpp"
#include "runtime/driver/files.hpp"
#include "stdlib/stdlib.hpp"

namespace toile {
namespace {

std::optional<std::string> standard_module(const std::string& name) {
  const auto found = std::ranges::find(stdlib_modules(), name, &Module::name);
  return found == stdlib_modules().end() ? std::nullopt : std::optional(std::string(found->text));
}

std::string known_modules() {
  std::string names;
  for (const Module& module : stdlib_modules()) names += (names.empty() ? "" : "\n") + std::string(module.name);
  return names;
}

}  // namespace

Outcome document_module(const std::string& module, Listener& listener) {
  Outcome outcome;
  if (module.empty()) {
    listener.printed(known_modules());
    return outcome;
  }
  std::optional<std::string> text = standard_module(module);
  if (!text) {
    std::string error;
    text = read_file(module, error);
    if (!text) {
      std::vector<std::string> names;
      for (const Module& each : stdlib_modules()) names.emplace_back(each.name);
      listener.failed(error, suggestion(module, names));
      outcome.file_failed = true;
      return outcome;
    }
  }
  Sources sources;
  const FileId id = sources.add(Source(module, *text));
  const syntax::Parsed parsed = syntax::parse(sources[id]);
  for (const syntax::SyntaxError& error : parsed.errors) {
    listener.diagnosed(syntax_diagnostic(error, sources[id], id), sources);
    outcome.script_failed = true;
  }
  if (!parsed.errors.empty()) return outcome;
  std::string page = syntax::reference(parsed, sources[id], std::filesystem::path(module).stem().string());
  page.pop_back();  // the line's end comes with printing
  listener.printed(page);
  return outcome;
}

}  // namespace toile
