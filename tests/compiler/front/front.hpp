// What the tests of the front end share: a world without files, and ways to look at a script's diagnostics.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "compiler/evaluate/program.hpp"
#include "stdlib/stdlib.hpp"

namespace toile::test {

/// The real standard library, files by name, and bodies whose lines are simply their named sections.
class FakeWorld : public World {
 public:
  std::map<std::string, std::string> files;
  int measured = 0;

  std::optional<std::string> read(const std::string& path, const std::string&) override {
    const auto found = files.find(path);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<std::string> module(const std::string& name) override {
    for (const Module& each : stdlib_modules()) {
      if (each.name == name) return std::string(each.text);
    }
    return std::nullopt;
  }
  std::vector<std::string> module_names() override {
    std::vector<std::string> names;
    for (const Module& each : stdlib_modules()) names.emplace_back(each.name);
    return names;
  }
  std::variant<std::vector<BodyLineFacts>, std::string> measure(const BodySpec& body) override {
    ++measured;
    std::vector<BodyLineFacts> lines;
    if (const auto* form = std::get_if<FormSpec>(&body.shape)) {
      for (const BodySection& section : form->sections) {
        if (!section.name.empty()) lines.push_back({section.name, section.girth, section.level});
      }
    }
    if (const auto* mesh = std::get_if<MeshSpec>(&body.shape)) {
      if (mesh->path == "missing.obj") return std::string("missing.obj cannot be read");
      for (const MeshSpec::Line& line : mesh->lines) lines.push_back({line.name, 0.7, line.pz});
    }
    return lines;
  }
  /// A body that is flat, seen from above: its lines run straight across, as all other lines do.
  std::variant<ChartAnswer, std::string> charted(const BodySpec&, const ChartSpec&,
                                                 const ChartQuestion& question) override {
    if (question.kind == ChartQuestion::Kind::Geodesic) return ChartAnswer{{}, line(question.from, question.to)};
    if (question.points.empty()) return ChartAnswer{{}, line({-0.3, 0}, {0.3, 0})};
    const auto at = [](const std::array<double, 3>& point) { return Vec2{point[0], point[1]}; };
    const Vec2 first = at(question.points.front());
    return ChartAnswer{first, question.points.size() > 1 ? line(first, at(question.points.back())) : Curve{}};
  }
};

/// A loaded script with its world.
struct Script {
  FakeWorld world;
  std::unique_ptr<Program> program;

  explicit Script(const std::string& text, const std::vector<Setting>& settings = {},
                  std::map<std::string, std::string> files = {}) {
    world.files = std::move(files);
    program = load("test.toile", text, settings, world);
    program->check_bodies();
  }

  /// "E0201 3:11 message" for each diagnostic.
  std::vector<std::string> told() const {
    std::vector<std::string> lines;
    for (const Diagnostic& diagnostic : program->diagnostics()) lines.push_back(line_of(diagnostic));
    return lines;
  }
  std::string rendered() const {
    std::string text;
    for (const Diagnostic& diagnostic : program->diagnostics()) text += render(diagnostic, program->sources(), false);
    return text;
  }
  /// What the script's `print` commands say, drapes answered by `result`.
  std::vector<std::string> printed(const Result& result = {}) {
    std::vector<std::string> lines;
    while (const auto command = program->next()) {
      if (const auto* print = std::get_if<PrintCommand>(&*command)) lines.push_back(print->text);
      if (std::holds_alternative<DrapeCommand>(*command)) program->give(result);
    }
    return lines;
  }

 private:
  std::string line_of(const Diagnostic& diagnostic) const {
    for (const Label& label : diagnostic.labels) {
      if (!label.primary) continue;
      const LineColumn at = program->sources()[label.at.file].position(label.at.span.begin);
      return diagnostic.code + " " + std::to_string(at.line) + ":" + std::to_string(at.column) + " " +
             diagnostic.message;
    }
    return diagnostic.code + " " + diagnostic.message;
  }
};

/// What `print EXPRESSION` says; the diagnostics when it cannot.
inline std::string value_of(const std::string& expression, const std::string& before = "") {
  Script script(before + "\nprint " + expression + "\n");
  if (!script.program->ok()) return script.rendered();
  const std::vector<std::string> lines = script.printed();
  return lines.size() == 1 ? lines.front() : script.rendered();
}

}  // namespace toile::test
