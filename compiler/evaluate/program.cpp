#include "compiler/evaluate/program.hpp"

#include <algorithm>
#include <set>

#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/commands.hpp"
#include "compiler/evaluate/definitions.hpp"
#include "compiler/evaluate/modules.hpp"
#include "compiler/evaluate/sizes.hpp"
#include "compiler/evaluate/unused.hpp"
#include "grammar/emit.hpp"
#include "grammar/parse.hpp"

namespace toile {
namespace {

class LoadedProgram final : public Program {
 public:
  explicit LoadedProgram(World& world) : session_(world), commands_(session_) {}

  void load(const std::string& name, std::string text, const std::vector<Setting>& settings, const std::string& size) {
    session_.size = size;
    Module& script = add_module(session_, name, std::move(text), false);
    for (const Setting& setting : settings) add_setting(session_, setting);
    commands_.define_results();
    // The standard library is checked by its own tests, and here by what is used of it.
    for (const auto& module : session_.modules) {
      if (!module->from_stdlib) check_module(session_, *module);
    }
    check_functions(session_);
    enter_bodies(script);
    report_unused_settings(session_);
    commands_.check();
    report_unused_size(session_);
    report_unused_lets(session_);
  }

  const Sources& sources() const override { return session_.sources; }
  const std::vector<Diagnostic>& diagnostics() const override { return session_.report.all(); }
  const std::vector<Garment>& garments() const override { return session_.garments; }
  const std::vector<DraftGarment>& drafts() const override { return session_.drafts; }
  const std::vector<BodySpec>& bodies() const override { return session_.bodies; }
  std::vector<int> own_garments() const override {
    std::set<int> own = commands_.garments();
    for (const auto& definition : session_.modules.front()->scope->definitions()) {
      const auto* garment = definition->value.as<GarmentRef>();
      if (garment != nullptr && (*garment)->index >= 0) own.insert((*garment)->index);
    }
    return {own.begin(), own.end()};
  }
  bool allows(const Diagnostic& warning) const override { return session_.report.allows(warning); }
  void check_bodies() override {
    for (const auto& definition : session_.modules.front()->scope->definitions()) {
      const auto* body = definition->value.as<BodyValue>();
      if (body != nullptr) body_lines(session_, *body->body, definition->at);
    }
  }
  std::vector<std::string> sizes() const override { return common_sizes(session_); }
  std::optional<Command> next() override { return commands_.next(); }
  void give(const Result& result) override { commands_.give(result); }

 private:
  /// The script's own bodies come first, in the order of the text, whether or not they are used.
  void enter_bodies(const Module& script) {
    for (const auto& definition : script.scope->definitions()) {
      const auto* body = definition->value.as<BodyValue>();
      if (body != nullptr) index_of(session_, *body->body);
    }
  }

  Session session_;
  Commands commands_;
};

}  // namespace

bool Program::ok() const {
  return std::none_of(diagnostics().begin(), diagnostics().end(),
                      [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
}

std::unique_ptr<Program> load(const std::string& name, std::string text, const std::vector<Setting>& settings,
                              World& world, const std::string& size) {
  auto program = std::make_unique<LoadedProgram>(world);
  program->load(name, std::move(text), settings, size);
  return program;
}

std::string emit_ast(const std::string& name, std::string text) {
  const Source source(name, std::move(text));
  return syntax::emit(syntax::parse(source).tree, source);
}

}  // namespace toile
