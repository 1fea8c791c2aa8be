// Collecting a garment's errors, and the words they share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compiler/diag/diagnostic.hpp"

namespace toile {

class Findings {
 public:
  explicit Findings(std::vector<Diagnostic>& diagnostics) : diagnostics_(diagnostics) {}

  /// The first label is the primary one.
  void error(std::string code, std::string message, std::vector<Label> labels, std::string help = "");
  void warning(std::string code, std::string message, std::vector<Label> labels, std::string help = "");
  int errors() const { return errors_; }

 private:
  std::vector<Diagnostic>& diagnostics_;
  int errors_ = 0;
};

/// "68.2 cm"; "0.03 mm" for what cannot be seen in centimetres.
std::string in_cm(double metres);
/// As a script writes it: "0.8cm".
std::string script_cm(double metres);
/// "`front`".
std::string quoted(const std::string& name);
/// "`front`, `back` and `band`".
std::string listed(const std::vector<std::string>& names);

}  // namespace toile
