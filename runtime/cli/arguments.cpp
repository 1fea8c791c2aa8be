#include "runtime/cli/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <map>

#include "compiler/diag/nearest.hpp"

namespace toile {
namespace {

constexpr const char* version = TOILE_VERSION;

void common_flags(CLI::App& app, Arguments& arguments) {
  const std::map<std::string, MessageFormat> formats{
      {"human", MessageFormat::Human}, {"json", MessageFormat::Json}, {"sarif", MessageFormat::Sarif}};
  const std::map<std::string, WhenColour> colours{
      {"auto", WhenColour::Auto}, {"always", WhenColour::Always}, {"never", WhenColour::Never}};
  app.add_option("--message-format", arguments.messages,
                 "on standard error: human, json (an object a line) or sarif (a log at the end)")
      ->transform(CLI::CheckedTransformer(formats).description("human|json|sarif"));
  app.add_option("--color", arguments.colour, "colours in messages")
      ->transform(CLI::CheckedTransformer(colours).description("auto|always|never"));
  app.add_option("--threads", arguments.threads, "threads to use; as many as there are by default")
      ->type_name("N")
      ->check(CLI::Range(1, 1024).description(""));
  app.add_flag("--quiet", arguments.quiet, "say nothing but errors and what the script prints");
  app.add_flag("--progress", arguments.progress, "show progress even where standard error is no terminal");
}

void script_file(CLI::App& app, Arguments& arguments) {
  app.add_option("FILE", arguments.files, "the script")->required()->expected(1)->type_name("");
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [&arguments](const std::vector<std::string>& all) {
           for (const std::string& one : all) {
             const std::size_t equals = one.find('=');
             if (equals == 0 || equals == std::string::npos) {
               throw CLI::ValidationError("--set " + one, "write NAME=EXPR, for example --set flare=20cm");
             }
             arguments.settings.push_back({one.substr(0, equals), one.substr(equals + 1)});
           }
         },
         "set a parameter of the script")
      ->type_name("NAME=EXPR")
      ->expected(1)
      ->take_all();
  app.add_option("--size", arguments.size,
                 "a size of the script's size tables; all makes one after the other, its files named by the size")
      ->type_name("NAME");
}

void triangles_option(CLI::App& app, Arguments& arguments) {
  app.add_option("--triangles", arguments.triangles, "about how many triangles a garment is divided into")
      ->type_name("N")
      ->check(CLI::Range(20, 200000).description(""))
      ->capture_default_str();
}

double read_accuracy(const std::string& text) {
  if (text == "draft") return 1e-2;
  if (text == "final") return 1e-6;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= 1e-9 && value <= 0.1)) {
    throw CLI::ValidationError("--accuracy " + text, "give draft, final or a number from 1e-9 to 0.1");
  }
  return value;
}

void solve_options(CLI::App& app, Arguments& arguments) {
  app.add_option_function<std::string>(
         "--accuracy", [&arguments](const std::string& text) { arguments.accuracy = read_accuracy(text); },
         "residual to reach, relative to a vertex's load: draft (1e-2), final (1e-6) or a number; 1e-3 by default")
      ->type_name("draft|final|REL");
  const std::map<std::string, DrapeOptions::Solver> solvers{{"newton", DrapeOptions::Solver::Newton},
                                                            {"okabe", DrapeOptions::Solver::Okabe}};
  app.add_option("--solver", arguments.solver, "newton, or okabe: the method of the paper of 1992")
      ->transform(CLI::CheckedTransformer(solvers).description("newton|okabe"));
  app.add_flag("--warm", arguments.warm,
               "start from the last drape of the garment that was made with --warm (kept in the user's cache)");
  app.add_option("--profile", arguments.profile, "write timings and memory as JSON")->type_name("P.json");
  triangles_option(app, arguments);
}

void choice_options(CLI::App& app, Arguments& arguments) {
  app.add_option("--garment", arguments.garment, "which garment; by default that of the script's first drape command")
      ->type_name("NAME");
  app.add_option("--body", arguments.body, "on which body; by default that of the drape command")->type_name("NAME");
  app.add_option("--fabric", arguments.fabric, "a cloth instead of the garment's own, as the script would name it")
      ->type_name("F");
}

void read_pixels(const std::string& text, Arguments& arguments) {
  const std::size_t cross = text.find('x');
  const auto number = [&text](std::size_t begin, std::size_t end) {
    int value = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    return error == std::errc{} && stop == text.data() + end ? value : 0;
  };
  if (cross != std::string::npos) {
    arguments.width = number(0, cross);
    arguments.height = number(cross + 1, text.size());
  }
  const auto is_sensible = [](int n) { return n >= 16 && n <= 8192; };
  if (cross == std::string::npos || !is_sensible(arguments.width) || !is_sensible(arguments.height)) {
    throw CLI::ValidationError("--pixels " + text, "give WIDTHxHEIGHT, each from 16 to 8192, for example 800x800");
  }
}

CLI::App& subcommand(CLI::App& app, Arguments& arguments, Task task, const char* name, const char* does,
                     const char* example) {
  CLI::App* sub = app.add_subcommand(name, does);
  sub->footer(fmt::format("Example:\n  {}\n", example));
  sub->callback([&arguments, task] { arguments.task = task; });
  return *sub;
}

void build(CLI::App& app, Arguments& arguments) {
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", fmt::format("toile {}", version));
  app.failure_message(CLI::FailureMessage::simple);
  app.footer("Example:\n  toile run examples/flared_skirt/flared_skirt.toile --out out\n");
  common_flags(app, arguments);

  CLI::App& run = subcommand(app, arguments, Task::Run, "run", "Run a script: its commands in order",
                             "toile run skirt.toile --set flare=20cm --out out");
  script_file(run, arguments);
  run.add_option("--out", arguments.out, "folder for the script's files; beside the script by default")
      ->type_name("DIR");
  solve_options(run, arguments);

  CLI::App& check = subcommand(app, arguments, Task::Check, "check",
                               "Check scripts up to the sewn meshes' topology; nothing is solved",
                               "toile check skirt.toile cape.toile");
  script_file(check, arguments);
  check.get_option("FILE")->expected(1, 1000);

  CLI::App& compile = subcommand(app, arguments, Task::Compile, "compile", "Show a stage of the compiler as text",
                                 "toile compile skirt.toile --emit smesh -o skirt.smesh");
  script_file(compile, arguments);
  compile.add_option("--emit", arguments.stage, "the stage: ast, pattern, sewing, pmesh or smesh")
      ->required()
      ->type_name("STAGE")
      ->check(CLI::IsMember({"ast", "pattern", "sewing", "pmesh", "smesh"}).description(""));
  compile.add_option("-o", arguments.outputs, "the file; standard output by default")->type_name("F")->expected(1);
  compile.add_option("--garment", arguments.garment, "which garment, where the script has several")->type_name("NAME");
  triangles_option(compile, arguments);

  CLI::App& draft = subcommand(app, arguments, Task::Draft, "draft", "Draw the flat pattern, nothing is solved",
                               "toile draft skirt.toile -o skirt.svg");
  script_file(draft, arguments);
  draft.add_flag("--sewing", arguments.sewing, "write the order of sewing instead, step by step: .txt or .json");
  draft.add_flag("--nested", arguments.nested, "all sizes of the script's size table in one drawing: .svg");
  draft.add_option("-o", arguments.outputs, "the file: .svg (true scale), .dxf or .json")
      ->required()
      ->type_name("F")
      ->expected(1);
  draft.add_option("--garment", arguments.garment, "which garment, where the script has several")->type_name("NAME");

  CLI::App& drape = subcommand(app, arguments, Task::Drape, "drape", "Drape a garment, even without a drape command",
                               "toile drape skirt.toile --accuracy final -o skirt.glb --report skirt.report.json");
  script_file(drape, arguments);
  choice_options(drape, arguments);
  drape.add_option("-o", arguments.outputs, "a file: .glb, .obj, .ply, .vtu or .json; may be given several times")
      ->type_name("F")
      ->expected(1)
      ->take_all();
  drape.add_option("--report", arguments.report, "write the report as JSON")->type_name("R.json");
  solve_options(drape, arguments);

  CLI::App& develop = subcommand(
      app, arguments, Task::Develop, "develop", "Develop a garment that is drawn on a body to its flat pattern",
      "toile develop bodice.toile -o pattern.toile -o pattern.svg --report bodice.report.json");
  script_file(develop, arguments);
  develop.add_option("--garment", arguments.garment, "which garment; by default that of the first develop command")
      ->type_name("NAME");
  develop
      .add_option("-o", arguments.outputs,
                  "a file: .toile, .svg, .dxf, .json, .obj, .ply, .vtu or .glb; may be given several times")
      ->type_name("F")
      ->expected(1)
      ->take_all();
  develop.add_option("--report", arguments.report, "write the report as JSON")->type_name("R.json");
  develop.add_option("--profile", arguments.profile, "write timings and memory as JSON")->type_name("P.json");
  triangles_option(develop, arguments);

  CLI::App& render = subcommand(app, arguments, Task::Render, "render", "Make a picture, draping first",
                                "toile render skirt.toile -o strain.png --from front --show strain.warp");
  script_file(render, arguments);
  choice_options(render, arguments);
  render.add_option("-o", arguments.outputs, "the PNG file")->required()->type_name("F.png")->expected(1);
  render.add_option("--from", arguments.view, "front, back, left, right, above or three_quarter")->type_name("V");
  render.add_option("--show", arguments.field, "a field in false colours: strain.warp, contact.pressure, …")
      ->type_name("FIELD");
  render
      .add_option_function<std::string>(
          "--pixels", [&arguments](const std::string& text) { read_pixels(text, arguments); },
          "size of the picture; 800x800 by default")
      ->type_name("WxH");
  solve_options(render, arguments);

  CLI::App& fmt = subcommand(app, arguments, Task::Fmt, "fmt", "Set scripts in the one layout, comments kept",
                             "toile fmt skirt.toile cape.toile");
  fmt.add_option("FILE", arguments.files, "scripts; - is standard input, laid out on standard output")
      ->required()
      ->expected(1, 100000)
      ->type_name("");
  fmt.add_flag("--check", arguments.check, "write nothing, and exit with 1 where a file is not in the layout");

  CLI::App& explain = subcommand(app, arguments, Task::Explain, "explain", "Say what a diagnostic means, with examples",
                                 "toile explain E0316");
  explain.add_option("CODE", arguments.code, "the code of a diagnostic; without one all are listed")->type_name("");

  CLI::App& doc =
      subcommand(app, arguments, Task::Doc, "doc", "Write a module's reference as Markdown", "toile doc blocks");
  doc.add_option("MODULE", arguments.module,
                 "a module of the standard library, or a script; without one the library's modules are listed")
      ->type_name("");

  CLI::App& test = subcommand(app, arguments, Task::Test, "test", "Compare scripts with their golden files",
                              "toile test tests/golden --update");
  test.add_option("PATH", arguments.files, "a script or a folder of scripts; this folder by default")
      ->expected(0, 1)
      ->type_name("");
  test.add_flag("--update", arguments.update, "write what was found as the new golden files");

  CLI::App& import = subcommand(app, arguments, Task::Import, "import", "Turn another program's pattern into a script",
                                "toile import skirt_specification.json -o skirt.toile");
  import.add_option("FILE", arguments.files, "a pattern specification of GarmentCode (JSON)")
      ->required()
      ->expected(1)
      ->type_name("");
  import.add_option("-o", arguments.outputs, "the script")->required()->type_name("F.toile")->expected(1);

  CLI::App& kes = subcommand(app, arguments, Task::Kes, "kes",
                             "Test a cloth on virtual KES instruments: its sheet read back, and the curves",
                             "toile kes wool_serge -o wool_serge.svg");
  kes.add_option("FABRIC", arguments.fabric, "a cloth of the module fabrics, or of the script given by --in")
      ->required()
      ->type_name("");
  kes.add_option("--in", arguments.files, "the script that has the cloth")->type_name("FILE")->expected(1);
  kes.add_option("-o", arguments.outputs, "the drawing of the curves; FABRIC.kes.svg by default")
      ->type_name("F.svg")
      ->expected(1);
}

/// The subcommand that was probably meant by the first word of the call.
std::string meant_instead(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) {
    if (sub->get_name() == argv[1]) return "";
    names.push_back(sub->get_name());
  }
  const std::optional<std::string> near = nearest(argv[1], names);
  return near ? fmt::format("help: did you mean `toile {}`?\n", *near) : "";
}

}  // namespace

std::variant<Arguments, int> read_arguments(int argc, const char* const* argv) {
  Arguments arguments;
  CLI::App app("Toile: garments as text. Checks, drafts, sews, drapes, renders and tests .toile scripts.", "toile");
  build(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    app.exit(error, std::cout, std::cerr);
    std::cerr << meant_instead(app, argc, argv);
    return 2;
  }
  return arguments;
}

}  // namespace toile
