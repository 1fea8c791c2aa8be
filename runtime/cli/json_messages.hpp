// Messages as JSON, one object a line, for editors and scripts.
#pragma once

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

}  // namespace toile
