// Messages as JSON for editors, scripts and reviews: one object a line, or a SARIF log of the whole call.
#pragma once

#include <memory>
#include <string>

#include "compiler/diag/diagnostic.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

/// {"type": "diagnostic", "severity", "code", "message", "help", "labels": [{"file", "line", "column", "end_line",
/// "end_column", "text", "primary"}]}; lines and columns count from 1, columns in Unicode code points.
std::string json_diagnostic(const Diagnostic& diagnostic, const Sources& sources);
/// {"type": "failure", "message", "help"}
std::string json_failure(const std::string& message, const std::string& help);
/// {"type": "progress", "phase", "fraction", "iteration", "residual"}
std::string json_progress(const Progress& progress);
/// {"type": type, key: value}
std::string json_message(const std::string& type, const std::string& key, const std::string& value);

/// A log in SARIF 2.1.0 (OASIS): diagnostics are results with rules, regions in Unicode code points and related
/// locations; failures outside the scripts are notifications of the run.
class SarifLog {
 public:
  SarifLog();
  ~SarifLog();
  SarifLog(const SarifLog&) = delete;
  SarifLog& operator=(const SarifLog&) = delete;

  void add(const Diagnostic& diagnostic, const Sources& sources);
  void add_failure(const std::string& message, const std::string& help);
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toile
