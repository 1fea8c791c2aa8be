// A script being worked through: the one place that sees the compiler and the runtime. It loads the script, makes its
// garments, drapes them, writes files, and remembers how all of that went.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/evaluate/program.hpp"
#include "runtime/drape/levels.hpp"
#include "runtime/driver/drape_store.hpp"
#include "runtime/driver/draped.hpp"
#include "runtime/driver/listener.hpp"
#include "runtime/driver/outcome.hpp"
#include "runtime/driver/world.hpp"
#include "runtime/report/report.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

struct WorkroomOptions {
  std::vector<Setting> settings;
  std::string size;                   // a row of the script's size tables; empty: each table's own choice
  bool size_in_names = false;         // of the files written: several sizes are made side by side
  std::filesystem::path out;          // folder of the script's outputs; empty: beside the script
  int triangles = 2500;               // of a garment, about
  std::optional<double> accuracy;     // overrides the script's
  std::optional<std::string> fabric;  // a Toile expression that replaces the garment's cloth
  DrapeOptions::Solver solver = DrapeOptions::Solver::Newton;
  int threads = 0;             // 0: as many as there are
  bool warm = false;           // drapes start from the last one of their garment, and are kept for the next
  bool patterns_only = false;  // nothing is put on: bodies need not be made where their measurements are known
};

class Workroom {
 public:
  Workroom(WorkroomOptions options, Listener& listener, Job job);

  /// Reads and compiles. False when that failed; the listener then knows why and so does the outcome.
  bool load(const std::filesystem::path& script);
  /// The same for a text at hand: `name` is how diagnostics call it, a path seen from `base`.
  bool load(const std::string& name, std::string text, const std::filesystem::path& base = {});

  Program& program() { return *program_; }
  const std::string& script() const { return script_; }
  const std::string& text() const { return text_; }
  const WorkroomOptions& options() const { return options_; }
  Listener& listener() { return *listener_; }

  /// The next command of the script. Diagnostics that evaluating it brought up have been passed on.
  std::optional<Command> next();

  /// A garment of the program, meshed and sewn once; null when that was interrupted or its cloth cannot be had.
  std::shared_ptr<const MadeGarment> make(int garment) { return make(std::vector<int>{garment}); }
  /// Several that are worn over each other, from the outside in, as one.
  std::shared_ptr<const MadeGarment> make(const std::vector<int>& outside_in);
  /// Places and solves; nullopt when that is not possible or was interrupted, which has then been said.
  std::optional<Draped> drape(const DrapeCommand& command);
  /// The same for the pattern of a development, from the form on which it was drawn.
  std::optional<Draped> drape(const DrapeCommand& command, const Developed& developed);

  /// Where the pieces of a garment that is drawn on a body lie on it; nullopt where they do not, which has been said.
  std::optional<Target> target(const MadeGarment& made, const Body& body);
  /// The body of that name among the script's; null when it has none or it cannot be made.
  std::shared_ptr<const Body> body_called(const std::string& name, Location wanted);
  /// The flat pattern of a garment that is drawn on a body; nullopt as for drape().
  std::optional<Developed> develop(const DevelopCommand& command);

  /// A cloth as the script could name it, `fabrics.silk`; nullopt when there is none, which has been said, with `asked`
  /// before the name.
  std::optional<FabricSheet> fabric_called(const std::string& expression, const std::string& asked = "");
  const Job& job() const { return job_; }

  /// Writes a whole file unless interrupted.
  void write(const std::filesystem::path& wanted, const std::string& bytes);
  /// Writes below the output folder for a command of the script.
  void write_below(const std::string& path, const std::string& bytes, Location written);

  /// Passes on a diagnostic of the driver's own.
  void diagnose(const Diagnostic& diagnostic);
  void wrong_usage(const std::string& message, const std::string& help = "");
  void file_failed(const std::string& message);
  /// A solve that did not reach equilibrium.
  void unsettled(const std::string& message);

  /// True once Ctrl-C was pressed; the outcome then says so.
  bool interrupted();
  const Outcome& outcome() const { return outcome_; }
  Profile profile() const;

 private:
  void pass_on_diagnostics();
  std::shared_ptr<const Body> body(int number, Location wanted);
  void flatten_to(const Target& target, Developed& developed);
  void correct(const DevelopCommand& command, const Target& form, Developed& developed);
  void propose_darts(const DevelopCommand& command, Developed& developed);
  void lay_on_form(Developed& developed);
  using AtRestOnForm = std::function<void(const RestState&, const FormDistance&)>;
  std::optional<Draped> drape_on_form(const DrapeCommand& command, const Developed& developed, const Target& form,
                                      const AtRestOnForm& at_rest);
  void note_strain(const DevelopCommand& command, const Developed& developed);
  void note_tried(const TriedDart& dart);
  int triangles_of_a_piece(const DraftGarment& draft) const;
  void note_development(const DevelopCommand& command, const Developed& developed);
  /// The meshes that draping begins on, the coarsest first.
  const std::vector<CoarseGarment>& coarse(const std::vector<int>& outside_in, const MadeGarment& made);
  DrapeOptions drape_options(const DrapeCommand& command) const;
  /// From the placed pieces, through the coarse meshes.
  DrapedLevels drape_cold(const DrapeCommand& command, const Draped& draped);
  /// From the drape kept last; nullopt when there is none of such pieces or it leads to no rest.
  std::optional<DrapedLevels> drape_warm(const DrapeCommand& command, const Draped& draped);
  std::string warm_key(const Draped& draped) const;
  void note_drape(const DrapeCommand& command, const Draped& draped);
  void note_tightness(const DrapeCommand& command, const Draped& draped);

  WorkroomOptions options_;
  Listener* listener_;
  Job job_;
  std::string script_;
  std::string text_;
  std::unique_ptr<FileWorld> world_;
  std::unique_ptr<Program> program_;
  std::size_t passed_on_ = 0;
  std::map<std::vector<int>, std::shared_ptr<const MadeGarment>> made_;  // by their garments, from the outside in
  std::map<std::vector<int>, std::vector<CoarseGarment>> coarse_;
  DrapeStore kept_{DrapeStore::usual_folder()};
  Outcome outcome_;
  Profile profile_;
};

/// A diagnostic about one place of the script.
Diagnostic at_place(Severity severity, const char* code, Location written, std::string message, std::string label = "",
                    std::string help = "");

}  // namespace toile
