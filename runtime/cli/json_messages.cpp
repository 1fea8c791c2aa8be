#include "runtime/cli/json_messages.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <nlohmann/json.hpp>

#include "compiler/diag/codes.hpp"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

/// On one line; bytes that are no UTF-8 (a name from a broken file) are replaced rather than fatal.
std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      break;
  }
  return "note";
}

Json json_label(const Label& label, const Sources& sources) {
  const Source& source = sources[label.at.file];
  const LineColumn begin = source.position(label.at.span.begin);
  const LineColumn end = source.position(label.at.span.end);
  return {{"file", source.name()},    {"line", begin.line}, {"column", begin.column},  {"end_line", end.line},
          {"end_column", end.column}, {"text", label.text}, {"primary", label.primary}};
}

/// A path as a URI reference.
std::string uri(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos);
    text += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return text;
}

Json sarif_location(const Label& label, const Sources& sources) {
  const Source& source = sources[label.at.file];
  const LineColumn begin = source.position(label.at.span.begin);
  const LineColumn end = source.position(label.at.span.end);
  Json location{{"physicalLocation",
                 {{"artifactLocation", {{"uri", uri(source.name())}}},
                  {"region",
                   {{"startLine", begin.line},
                    {"startColumn", begin.column},
                    {"endLine", end.line},
                    {"endColumn", end.column}}}}}};
  if (!label.text.empty()) location["message"] = {{"text", label.text}};
  return location;
}

std::string with_help(const std::string& message, const std::string& help) {
  return help.empty() ? message : message + "\nhelp: " + help;
}

}  // namespace

struct SarifLog::State {
  Json rules = Json::array();
  std::map<std::string, std::size_t> rule_numbers;
  Json results = Json::array();
  Json failures = Json::array();

  std::size_t rule(const std::string& code) {
    const auto [known, is_new] = rule_numbers.emplace(code, rules.size());
    if (is_new) {
      Json rule{{"id", code}};
      if (const CodeEntry* entry = find_code(code)) {
        rule["shortDescription"] = {{"text", entry->title}};
        rule["fullDescription"] = {{"text", entry->explanation}};
      }
      rules.push_back(std::move(rule));
    }
    return known->second;
  }
};

SarifLog::SarifLog() : state_(std::make_unique<State>()) {}
SarifLog::~SarifLog() = default;

void SarifLog::add(const Diagnostic& diagnostic, const Sources& sources) {
  Json result{{"ruleId", diagnostic.code},
              {"ruleIndex", state_->rule(diagnostic.code)},
              {"level", name_of(diagnostic.severity)},
              {"message", {{"text", with_help(diagnostic.message, diagnostic.help)}}}};
  Json places = Json::array(), related = Json::array();
  for (const Label& label : diagnostic.labels) {
    (label.primary && places.empty() ? places : related).push_back(sarif_location(label, sources));
  }
  if (!places.empty()) result["locations"] = std::move(places);
  if (!related.empty()) result["relatedLocations"] = std::move(related);
  state_->results.push_back(std::move(result));
}

void SarifLog::add_failure(const std::string& message, const std::string& help) {
  state_->failures.push_back({{"level", "error"}, {"message", {{"text", with_help(message, help)}}}});
}

std::string SarifLog::text() const {
  const Json driver{{"name", "toile"}, {"version", TOILE_VERSION}, {"rules", state_->rules}};
  Json run{{"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", state_->results}};
  run["invocations"] = Json::array(
      {{{"executionSuccessful", state_->failures.empty()}, {"toolExecutionNotifications", state_->failures}}});
  const Json log{
      {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", Json::array({run})}};
  return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string json_diagnostic(const Diagnostic& diagnostic, const Sources& sources) {
  Json labels = Json::array();
  for (const Label& label : diagnostic.labels) labels.push_back(json_label(label, sources));
  return one_line({{"type", "diagnostic"},
                   {"severity", name_of(diagnostic.severity)},
                   {"code", diagnostic.code},
                   {"message", diagnostic.message},
                   {"help", diagnostic.help},
                   {"labels", labels}});
}

std::string json_failure(const std::string& message, const std::string& help) {
  return one_line({{"type", "failure"}, {"message", message}, {"help", help}});
}

std::string json_progress(const Progress& progress) {
  return one_line({{"type", "progress"},
                   {"phase", progress.phase},
                   {"fraction", progress.fraction},
                   {"iteration", progress.iteration},
                   {"residual", progress.residual}});
}

std::string json_message(const std::string& type, const std::string& key, const std::string& value) {
  return one_line({{"type", type}, {key, value}});
}

}  // namespace toile
