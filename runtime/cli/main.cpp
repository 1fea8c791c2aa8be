// The `toile` command: arguments in, one call of the driver, an exit code out.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "runtime/cli/arguments.hpp"
#include "runtime/cli/console.hpp"
#include "runtime/cli/interrupt.hpp"
#include "runtime/cli/threads.hpp"
#include "runtime/driver/explain.hpp"
#include "runtime/driver/formatting.hpp"
#include "runtime/driver/golden.hpp"
#include "runtime/driver/importing.hpp"
#include "runtime/driver/laboratory.hpp"
#include "runtime/driver/reference.hpp"
#include "runtime/driver/run.hpp"
#include "runtime/driver/sizes.hpp"

namespace toile {
namespace {

WorkroomOptions workroom_options(const Arguments& arguments) {
  WorkroomOptions options;
  options.settings = arguments.settings;
  options.size = arguments.size;
  options.out = arguments.out;
  options.triangles = arguments.triangles;
  options.accuracy = arguments.accuracy;
  options.solver = arguments.solver;
  options.threads = arguments.threads;
  options.warm = arguments.warm;
  options.patterns_only = arguments.task == Task::Compile || arguments.task == Task::Draft;
  if (!arguments.fabric.empty()) options.fabric = arguments.fabric;
  return options;
}

DrapeRequest drape_request(const Arguments& arguments) {
  return {arguments.garment, arguments.body, {arguments.outputs.begin(), arguments.outputs.end()}, arguments.report};
}

void compile(Workroom& workroom, const Arguments& arguments) {
  const std::optional<std::string> text = emit_stage(workroom, *stage_named(arguments.stage), arguments.garment);
  if (!text) return;
  if (arguments.outputs.empty()) {
    fmt::print("{}", *text);
  } else {
    workroom.write(arguments.outputs.front(), *text);
  }
}

void carry_out(Workroom& workroom, const Arguments& arguments) {
  switch (arguments.task) {
    case Task::Run:
      return run_commands(workroom);
    case Task::Check:
      return check_meshes(workroom);
    case Task::Compile:
      return compile(workroom, arguments);
    case Task::Draft:
      return (arguments.sewing ? draft_sewing : draft)(workroom, arguments.garment, arguments.outputs.front());
    case Task::Drape:
      return drape_once(workroom, drape_request(arguments));
    case Task::Develop:
      return develop_once(workroom,
                          {arguments.garment, {arguments.outputs.begin(), arguments.outputs.end()}, arguments.report});
    case Task::Render: {
      DrapeRequest drape = drape_request(arguments);
      drape.files.clear();
      return render_once(workroom, {std::move(drape), arguments.outputs.front(), arguments.view, arguments.field,
                                    arguments.width, arguments.height});
    }
    case Task::Fmt:
    case Task::Explain:
    case Task::Doc:
    case Task::Test:
    case Task::Import:
    case Task::Kes:
      break;  // have no workroom of their own
  }
}

Outcome work_on(const std::string& file, const WorkroomOptions& options, const Arguments& arguments, Console& console,
                const Job& job) {
  // The last script is not cleared away, which would take a sixth of the time that checking it takes: the system takes
  // back all of its memory at once.
  static auto* const last = new std::unique_ptr<Workroom>;
  *last = std::make_unique<Workroom>(options, console, job);
  Workroom& workroom = **last;
  const bool loaded = workroom.load(std::filesystem::path(file));
  // The tree is lossless and stands for a faulty text too.
  const bool shows_tree = arguments.task == Task::Compile && arguments.stage == "ast" && !workroom.text().empty();
  if (loaded || shows_tree) carry_out(workroom, arguments);
  if (!arguments.profile.empty()) workroom.write(arguments.profile, profile_json(workroom.profile()));
  return workroom.outcome();
}

/// On a cloth of a script, or of the standard library.
Outcome test_cloth(const Arguments& arguments, Console& console, const Job& job) {
  Workroom workroom({}, console, job);
  const bool loaded = arguments.files.empty() ? workroom.load("toile kes", "import fabrics\n")
                                              : workroom.load(std::filesystem::path(arguments.files.front()));
  const bool is_standard = arguments.files.empty() && !arguments.fabric.starts_with("fabrics.");
  const std::string drawing = arguments.outputs.empty() ? arguments.fabric + ".kes.svg" : arguments.outputs.front();
  if (loaded) test_fabric(workroom, (is_standard ? "fabrics." : "") + arguments.fabric, drawing);
  return workroom.outcome();
}

/// Several scripts (`check`) and sizes are gone through one by one; the gravest outcome counts.
Outcome work_through(const Arguments& arguments, Console& console, const Job& job) {
  Outcome all;
  for (const std::string& file : arguments.files) {
    if (arguments.nested) {
      all.add(
          draft_nested(file, workroom_options(arguments), arguments.garment, arguments.outputs.front(), console, job));
      continue;
    }
    for (const WorkroomOptions& options : one_by_size(file, workroom_options(arguments))) {
      if (options.size_in_names) console.noted("size " + options.size);
      all.add(work_on(file, options, arguments, console, job));
      if (all.interrupted) return all;
    }
  }
  return all;
}

Outcome outcome_of(const Arguments& arguments, Console& console, const Job& job) {
  switch (arguments.task) {
    case Task::Fmt:
      return format_files(arguments.files, arguments.check, console);
    case Task::Explain:
      return explain(arguments.code, console);
    case Task::Doc:
      return document_module(arguments.module, console);
    case Task::Test:
      return test_scripts(arguments.files.empty() ? "." : arguments.files.front(), arguments.update, console, job);
    case Task::Import:
      return import_pattern(arguments.files.front(), arguments.outputs.front(), console);
    case Task::Kes:
      return test_cloth(arguments, console, job);
    default:
      return work_through(arguments, console, job);
  }
}

int toile_main(int argc, const char* const* argv) {
  const std::variant<Arguments, int> read = read_arguments(argc, argv);
  if (const int* code = std::get_if<int>(&read)) return *code;
  const auto& arguments = std::get<Arguments>(read);
  const ThreadLimit limit(arguments.threads);
  Console console(arguments);
  Job job;
  job.cancelled = &watch_for_interrupt();
  if (console.shows_progress()) job.report = [&console](const Progress& progress) { console.progressed(progress); };
  return outcome_of(arguments, console, job).exit_code();
}

}  // namespace
}  // namespace toile

int main(int argc, char** argv) {
  try {
    return toile::toile_main(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 4;  // out of memory, a file system that fails: nothing of the script's
  }
}
