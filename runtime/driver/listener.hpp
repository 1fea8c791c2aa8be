// Who hears what happens in a workroom: the command line, the test runner.
#pragma once

#include <string>

#include "compiler/diag/diagnostic.hpp"

namespace toile {

class Listener {
 public:
  virtual ~Listener() = default;
  /// A diagnostic of the script.
  virtual void diagnosed(const Diagnostic& diagnostic, const Sources& sources) = 0;
  /// A line that the script prints.
  virtual void printed(const std::string& line) = 0;
  /// A line about what was done ("skirt on form: 2,484 triangles, …").
  virtual void noted(const std::string& line) = 0;
  /// A file that now stands complete under its name.
  virtual void wrote(const std::string& path) = 0;
  /// Something outside the script went wrong: a file, a name on the command line.
  virtual void failed(const std::string& message, const std::string& help) = 0;
};

}  // namespace toile
