// The command line as plain data. CLI11 is seen by arguments.cpp alone.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/evaluate/program.hpp"
#include "runtime/drape/drape.hpp"

namespace toile {

enum class Task { Run, Check, Compile, Draft, Drape, Develop, Render, Fmt, Explain, Doc, Test, Import, Kes };
enum class MessageFormat { Human, Json, Sarif };
enum class WhenColour { Auto, Always, Never };

struct Arguments {
  Task task = Task::Run;
  std::vector<std::string> files;  // scripts; for `test`, at most one path; for `import`, the foreign file
  std::string code;                // `explain`
  std::string module;              // `doc`

  // common
  MessageFormat messages = MessageFormat::Human;
  WhenColour colour = WhenColour::Auto;
  int threads = 0;  // 0: as many as there are
  bool quiet = false;
  bool progress = false;

  // of scripts
  std::vector<Setting> settings;
  std::string size;
  std::string out;  // `run`
  int triangles = 2500;
  std::string garment, body, fabric;
  std::optional<double> accuracy;
  DrapeOptions::Solver solver = DrapeOptions::Solver::Newton;
  bool warm = false;
  std::string stage;                    // `compile`
  bool sewing = false, nested = false;  // `draft`
  std::vector<std::string> outputs;     // -o
  std::string report, profile;
  std::string view, field;  // `render`
  int width = 800, height = 800;
  bool check = false;   // `fmt`
  bool update = false;  // `test`
};

/// The arguments, or the exit code of a call that ends here: 0 after --help or --version, 2 after wrong usage, which
/// has then been said on standard error.
std::variant<Arguments, int> read_arguments(int argc, const char* const* argv);

}  // namespace toile
