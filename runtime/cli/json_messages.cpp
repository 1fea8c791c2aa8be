#include "runtime/cli/json_messages.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace

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
