// The calls that do one thing with a script, whatever its own commands are.
#include <fmt/format.h>

#include "compiler/diag/nearest.hpp"
#include "runtime/driver/choice.hpp"
#include "runtime/driver/outputs.hpp"
#include "runtime/driver/run.hpp"
#include "runtime/driver/sizes.hpp"
#include "runtime/export/export.hpp"

namespace toile {
namespace {

bool is_known_field(Workroom& workroom, const std::string& name) {
  const std::vector<std::string> names = field_names();
  for (const std::string& known : names) {
    if (name.empty() || known == name) return true;
  }
  workroom.wrong_usage(fmt::format("no field is called {}", name), suggestion(name, names));
  return false;
}

}  // namespace

void draft(Workroom& workroom, const std::string& garment, const std::filesystem::path& file) {
  if (!is_pattern_file(file)) {
    return workroom.wrong_usage(fmt::format("{} is no kind of file for a flat pattern", file.string()),
                                fmt::format("give a name that ends in {}", pattern_endings()));
  }
  const std::optional<int> chosen = choose_garment(workroom, garment);
  if (!chosen) return;
  workroom.write(file, *pattern_file(file, workroom.program().garments()[static_cast<std::size_t>(*chosen)]));
}

Outcome draft_nested(const std::filesystem::path& script, const WorkroomOptions& options, const std::string& garment,
                     const std::filesystem::path& file, Listener& listener, const Job& job) {
  WorkroomOptions all = options;
  if (all.size.empty()) all.size = "all";
  std::vector<SizedGarment> sizes;
  const std::vector<WorkroomOptions> each = one_by_size(script, all);
  for (const WorkroomOptions& own : each) {
    WorkroomOptions unnamed = own;
    unnamed.size_in_names = false;
    Workroom workroom(unnamed, listener, job);
    if (!workroom.load(script)) return workroom.outcome();
    const std::optional<int> chosen = choose_garment(workroom, garment);
    if (!chosen) return workroom.outcome();
    sizes.push_back({own.size, workroom.program().garments()[static_cast<std::size_t>(*chosen)]});
    if (&own != &each.back()) continue;
    if (file.extension() == ".svg") {
      workroom.write(file, nested_svg(sizes));
    } else {
      workroom.wrong_usage(fmt::format("{} is no kind of file for nested sizes", file.string()),
                           "give a name that ends in .svg");
    }
    return workroom.outcome();
  }
  return {};
}

void draft_sewing(Workroom& workroom, const std::string& garment, const std::filesystem::path& file) {
  const std::optional<int> chosen = choose_garment(workroom, garment);
  if (!chosen) return;
  const auto text = sewing_file(file, workroom.program().garments()[static_cast<std::size_t>(*chosen)]);
  if (text) return workroom.write(file, *text);
  workroom.wrong_usage(fmt::format("{} is no kind of file for the order of sewing", file.string()),
                       fmt::format("give a name that ends in {}", sewing_endings()));
}

void drape_once(Workroom& workroom, const DrapeRequest& request) {
  for (const std::filesystem::path& file : request.files) {
    if (!is_drape_file(file)) {
      return workroom.wrong_usage(fmt::format("{} is no kind of file for a drape", file.string()),
                                  fmt::format("give a name that ends in {}", drape_endings()));
    }
  }
  const std::optional<DrapeCommand> command = choose_drape(workroom, request.garment, request.body);
  if (!command) return;
  const std::optional<Draped> draped = workroom.drape(*command);
  if (!draped) return;
  for (const std::filesystem::path& file : request.files) {
    workroom.write(file, *drape_file(file, *draped, workroom.script()));
  }
  if (!request.report.empty()) workroom.write(request.report, report_json(workroom.script(), draped->view()));
}

void develop_once(Workroom& workroom, const DevelopRequest& request) {
  for (const std::filesystem::path& file : request.files) {
    if (is_development_file(file)) continue;
    return workroom.wrong_usage(
        fmt::format("{} is no kind of file for a development", file.string()),
        fmt::format("give a name that ends in .toile, {}, {}", pattern_endings(), drape_endings()));
  }
  const std::optional<DevelopCommand> command = choose_development(workroom, request.garment);
  if (!command) return;
  const std::optional<Developed> developed = workroom.develop(*command);
  if (!developed) return;
  for (const std::filesystem::path& file : request.files) {
    workroom.write(file, *development_file(file, *developed, workroom.script()));
  }
  if (!request.report.empty()) workroom.write(request.report, development_report(*developed, workroom.script()));
}

void render_once(Workroom& workroom, const RenderRequest& request) {
  const std::optional<View> view = view_named(request.view);
  if (!view) {
    return workroom.wrong_usage(fmt::format("no view is called {}", request.view),
                                suggestion(request.view, view_names()));
  }
  if (!is_known_field(workroom, request.field)) return;
  const std::optional<DrapeCommand> command = choose_drape(workroom, request.drape.garment, request.drape.body);
  if (!command) return;
  const std::optional<Draped> draped = workroom.drape(*command);
  if (!draped) return;
  workroom.write(request.file, picture(*draped, {*view, request.field, request.width, request.height}));
}

}  // namespace toile
