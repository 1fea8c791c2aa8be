#include "runtime/driver/world.hpp"

#include "runtime/develop/drawn_lines.hpp"
#include "runtime/driver/files.hpp"
#include "stdlib/stdlib.hpp"

namespace toile {

std::optional<std::string> FileWorld::read(const std::string& path, const std::string& from) {
  std::string why;
  std::optional<std::string> text = read_file(beside(from, path), why);
  if (!text) missed_a_file_ = true;
  return text;
}

std::optional<std::string> FileWorld::module(const std::string& name) {
  for (const Module& module : stdlib_modules()) {
    if (module.name == name) return std::string(module.text);
  }
  return std::nullopt;
}

std::vector<std::string> FileWorld::module_names() {
  std::vector<std::string> names;
  for (const Module& module : stdlib_modules()) names.emplace_back(module.name);
  return names;
}

std::variant<std::vector<BodyLineFacts>, std::string> FileWorld::measure(const BodySpec& spec) {
  std::string error;
  const std::shared_ptr<const Body> made = body(spec, error);
  if (!made) return error;
  std::vector<BodyLineFacts> facts;
  for (const BodyLine& line : made->lines()) {
    double level = 0;
    for (const Vec3& point : line.points) level += point.z / static_cast<double>(line.points.size());
    facts.push_back({line.name, line.girth, level});
  }
  return facts;
}

std::variant<ChartAnswer, std::string> FileWorld::charted(const BodySpec& spec, const ChartSpec& chart,
                                                          const ChartQuestion& question) {
  std::string error;
  const std::shared_ptr<const Body> made = body(spec, error);
  if (!made) return error;
  std::unique_ptr<BodyChart>& drawn_in = charts_[identity(spec) + '/' + identity(chart)];
  if (!drawn_in) drawn_in = std::make_unique<BodyChart>(*made, chart, error);
  if (!error.empty()) {
    drawn_in.reset();
    return error;
  }
  ChartAnswer found = answer(question, *made, *drawn_in, error);
  if (!error.empty()) return error;
  return found;
}

std::shared_ptr<const Body> FileWorld::body(const BodySpec& spec, std::string& error) {
  const auto [entry, is_new] = bodies_.try_emplace(identity(spec));
  Made& made = entry->second;
  if (is_new) {
    BodySpec located = spec;
    if (auto* mesh = std::get_if<MeshSpec>(&located.shape)) {
      mesh->path = beside(script_, mesh->path).string();
      std::error_code code;
      if (!std::filesystem::is_regular_file(mesh->path, code)) missed_a_file_ = true;
    }
    made.body = Body::make(located, &made.error);
  }
  error = made.error;
  return made.body;
}

}  // namespace toile
