// A script's commands, one after another.
#include "runtime/driver/run.hpp"

#include <fmt/format.h>

#include <map>

#include "runtime/driver/outputs.hpp"
#include "runtime/driver/result.hpp"

namespace toile {
namespace {

class Execution {
 public:
  explicit Execution(Workroom& workroom) : workroom_(workroom) {}

  void operator()(const DrapeCommand& command) {
    std::optional<Draped> draped = command.developed.empty()
                                       ? workroom_.drape(command)
                                       : workroom_.drape(command, developments_.at(command.developed));
    if (!draped) {
      stopped_ = true;  // what follows may ask for the result
      return;
    }
    workroom_.program().give(result_of(*draped));
    results_.insert_or_assign(command.name, *std::move(draped));
  }

  void operator()(const DevelopCommand& command) {
    std::optional<Developed> developed = workroom_.develop(command);
    if (!developed) {
      stopped_ = true;
      return;
    }
    workroom_.program().give(result_of(*developed));
    results_.insert_or_assign(command.name, developed->on_form);
    developments_.insert_or_assign(command.name, *std::move(developed));
  }

  void operator()(const RenderCommand& command) {
    const std::optional<View> view = view_named(command.view);
    if (!view) return refuse("E0504", command.written, "no view is called \"" + command.view + "\"", view_names());
    if (!command.field.empty() && !is_field(command.field)) {
      return refuse("E0504", command.written, "no field is called \"" + command.field + "\"", field_names());
    }
    if (command.path.size() < 5 || command.path.substr(command.path.size() - 4) != ".png") {
      return refuse("E0503", command.written, "pictures are PNG files", {"a name that ends in .png"});
    }
    const Draped& draped = results_.at(command.result);
    workroom_.write_below(command.path, picture(draped, {*view, command.field, command.width, command.height}),
                          command.written);
  }

  void operator()(const ExportCommand& command) {
    const auto development = developments_.find(command.result);
    const std::optional<std::string> bytes =
        command.garment ? pattern_file(command.path, workroom_.program().garments()[garment(command)])
        : development != developments_.end()
            ? development_file(command.path, development->second, workroom_.script())
            : drape_file(command.path, results_.at(command.result), workroom_.script());
    if (!bytes) {
      return refuse("E0503", command.written,
                    fmt::format("\"{}\" is no kind of file that this can be exported to", command.path),
                    {"a name that ends in " + (command.garment ? pattern_endings() : drape_endings())});
    }
    workroom_.write_below(command.path, *bytes, command.written);
  }

  void operator()(const PrintCommand& command) { workroom_.listener().printed(command.text); }

  void operator()(const ExpectCommand& command) {
    if (command.holds) return;
    workroom_.diagnose(
        at_place(Severity::Error, "E0507", command.written, "this does not hold: " + command.text, command.found));
  }

  bool stopped() const { return stopped_; }

 private:
  static std::size_t garment(const ExportCommand& command) { return static_cast<std::size_t>(*command.garment); }

  static bool is_field(const std::string& name) {
    for (const std::string& known : field_names()) {
      if (known == name) return true;
    }
    return false;
  }

  void refuse(const char* code, Location written, const std::string& message,
              const std::vector<std::string>& possible) {
    workroom_.diagnose(
        at_place(Severity::Error, code, written, message, "", fmt::format("give {}", fmt::join(possible, ", "))));
  }

  Workroom& workroom_;
  std::map<std::string, Draped> results_;  // of a development the cloth on its form
  std::map<std::string, Developed> developments_;
  bool stopped_ = false;
};

}  // namespace

void run_commands(Workroom& workroom) {
  Execution execution(workroom);
  while (!execution.stopped()) {
    const std::optional<Command> command = workroom.next();
    if (!command) return;
    std::visit(execution, *command);
  }
}

}  // namespace toile
