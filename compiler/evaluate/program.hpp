// The front end's face: text in; diagnostics, patterns and a plan of commands out. The driver alternates: it asks for
// the next command, executes it and hands the result back as a plain record for later lines to use.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/diag/diagnostic.hpp"
#include "compiler/pattern/body_spec.hpp"
#include "compiler/pattern/draft.hpp"
#include "compiler/pattern/pattern.hpp"

namespace toile {

/// What a script may know of a body's line while it is evaluated: `form.waist.girth`, `form.waist.level`.
struct BodyLineFacts {
  std::string name;
  double girth = 0;  // [m]
  double level = 0;  // [m]
};

/// Everything outside that evaluation needs: the embedded stdlib and files beside the script, and measuring bodies.
class World {
 public:
  virtual ~World() = default;
  /// The text of a file, `path` relative to `from` (the importing file's name), or nullopt.
  virtual std::optional<std::string> read(const std::string& path, const std::string& from) = 0;
  /// The text of a stdlib module by name ("bodies"), or nullopt; and all names, for suggestions.
  virtual std::optional<std::string> module(const std::string& name) = 0;
  virtual std::vector<std::string> module_names() = 0;
  /// Lines of a body, or an error in words.
  virtual std::variant<std::vector<BodyLineFacts>, std::string> measure(const BodySpec& body) = 0;
};

/// A result's fields by dotted name, SI: "contact.weight_error" -> 3e-4. Dimensions are in result_schema().
using Result = std::map<std::string, double>;

struct DrapeCommand {
  int garment = 0;          // index into Program::garments
  std::vector<int> over{};  // the garments that it is worn over, from the outside in
  std::string developed;    // the name of the development whose pattern is draped, back on its form; else empty
  int body = -1;            // index into Program::bodies, or -1: floats, no gravity
  std::string name;         // "worn"; empty when unnamed
  std::optional<double> accuracy;
  Location written;
};
struct DevelopCommand {
  int garment = 0;
  int body = 0;
  std::string name;
  std::optional<double> strain;  // that darts are to be proposed for, until 95 % of the cloth have no more
  std::optional<double> within;  // [m] of the form when it is draped back, which the pattern is to be corrected for
  Location written;
};
struct RenderCommand {
  std::string result;  // the name of a drape or a development
  std::string path;
  std::string view;   // "front", "back", "left", "right", "above", "" for the default
  std::string field;  // "strain.warp" or empty
  int width = 800, height = 800;
  Location written;
};
struct ExportCommand {
  std::optional<int> garment;  // flat: svg, json
  std::string result;          // or a drape: obj, ply, glb, json; or a development: toile, svg, json
  std::string path;
  Location written;
};
struct PrintCommand {
  std::string text;  // already formatted, with units
  Location written;
};
struct ExpectCommand {
  bool holds = true;
  std::string text;   // the source of the expectation
  std::string found;  // the values of both sides, with units
  Location written;
};
using Command = std::variant<DrapeCommand, DevelopCommand, RenderCommand, ExportCommand, PrintCommand, ExpectCommand>;

struct Setting {
  std::string name;
  std::string expression;  // Toile text: "--set flare=20cm"
};

class Program {
 public:
  virtual ~Program() = default;

  virtual const Sources& sources() const = 0;
  /// All diagnostics so far, in the order of the text; with an Error among them there are no commands.
  virtual const std::vector<Diagnostic>& diagnostics() const = 0;
  bool ok() const;

  virtual const std::vector<Garment>& garments() const = 0;
  /// What they were made of, one for one.
  virtual const std::vector<DraftGarment>& drafts() const = 0;
  virtual const std::vector<BodySpec>& bodies() const = 0;
  /// The garments that the script names or drapes itself, and not only takes pieces from: indices into garments().
  virtual std::vector<int> own_garments() const = 0;
  /// Whether the script allows a warning at its place.
  virtual bool allows(const Diagnostic& warning) const = 0;
  /// Makes the script's bodies; one that cannot be made is then among the diagnostics.
  virtual void check_bodies() = 0;
  /// The names of the sizes that can be chosen: those that each size table has.
  virtual std::vector<std::string> sizes() const = 0;

  /// The next command with its expressions evaluated, or nullopt at the end (or after an error, which is then among the
  /// diagnostics).
  virtual std::optional<Command> next() = 0;
  /// The result of the drape or develop command just handed out.
  virtual void give(const Result& result) = 0;
};

/// Parses, resolves, checks and evaluates everything but the commands. Never throws, always returns. `size` chooses the
/// row of every size table; empty leaves each at its own.
std::unique_ptr<Program> load(const std::string& name, std::string text, const std::vector<Setting>& settings,
                              World& world, const std::string& size = "");

/// The tree as stable text for `toile compile --emit ast`, and the evaluated patterns for `--emit pattern`.
std::string emit_ast(const std::string& name, std::string text);
std::string emit_pattern(const Program& program);

/// The fields of a drape's result, dotted, with a sample of their unit ("m", "1", "%", "N", "J", "Pa", "N/m", "rad").
/// Values in a Result are SI all the same (3 % is 0.03); truths are 0 or 1. All names are those of the report but for
///   area            the cloth's area as cut [m2]
///   folds           local maxima of the distance from the axis along the lowest free boundary loop
///   hem.length      length of that loop as draped; hem.low, hem.high: its lowest and highest z
///   bounds.width    extent of the drape in x; bounds.depth in y; bounds.low, bounds.high: least and greatest z
const std::vector<std::pair<std::string, std::string>>& result_schema();

/// The same for a drape of a development, which has
///   form.distance, form.slip   how far the cloth is from the form it was developed for, and how far its points lie
///   from
///                              where they were drawn, each with mean p95 max [m]
const std::vector<std::pair<std::string, std::string>>& form_drape_schema();

/// The same for a development: what it has in common with a drape, and
///   area, target_area   of the flat pattern, of the form [m2]
///   strain.worst        95 % of the cloth have no elongation, compression or shear beyond it
///   darts.proposed      how many darts of the pieces as drawn were proposed
///   seams.mismatch      the largest difference between two sides that are sewn together [m]
const std::vector<std::pair<std::string, std::string>>& development_schema();

}  // namespace toile
