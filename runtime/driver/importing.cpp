#include "runtime/driver/importing.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "grammar/format/format.hpp"
#include "runtime/driver/files.hpp"
#include "runtime/import/garmentcode.hpp"
#include "runtime/import/script_text.hpp"

namespace toile {
namespace {

std::string in_layout(const std::string& name, const std::string& text) {
  const Source source(name, text);
  return syntax::format(syntax::parse(source), source);
}

Outcome file_failure(const std::string& message, const std::string& help, Listener& listener) {
  listener.failed(message, help);
  Outcome outcome;
  outcome.file_failed = true;
  return outcome;
}

}  // namespace

Outcome import_pattern(const std::string& input, const std::string& output, Listener& listener) {
  std::string error;
  const std::optional<std::string> json = read_file(input, error);
  if (!json) return file_failure(error, "", listener);
  const std::optional<ForeignPattern> pattern = read_garmentcode(*json, error);
  if (!pattern) {
    return file_failure(fmt::format("{}: {}", input, error), "a pattern specification of GarmentCode is read",
                        listener);
  }
  const ImportedScript script = script_text(*pattern, std::filesystem::path(input).filename().string());
  if (!write_file(output, in_layout(output, script.text), error)) return file_failure(error, "", listener);
  listener.noted(fmt::format("{} pieces, {} seams", pattern->panels.size(), pattern->stitches.size()));
  for (const std::string& note : script.notes) listener.noted(note);
  listener.wrote(output);
  return {};
}

}  // namespace toile
