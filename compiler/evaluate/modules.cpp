#include "compiler/evaluate/modules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/allowances.hpp"
#include "compiler/evaluate/definitions.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/syntax_errors.hpp"

namespace toile {
namespace {

constexpr std::size_t most_modules = 200;

/// `path` as seen from the folder of the importing file, without "." and "..".
std::string beside(const std::string& importer, const std::string& path) {
  const std::size_t slash = importer.rfind('/');
  const std::string joined =
      path.starts_with('/') || slash == std::string::npos ? path : importer.substr(0, slash + 1) + path;
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= joined.size();) {
    const std::size_t end = std::min(joined.find('/', begin), joined.size());
    const std::string part = joined.substr(begin, end - begin);
    const bool goes_up = part == ".." && !parts.empty() && parts.back() != ".." && !parts.back().empty();
    if (goes_up) {
      parts.pop_back();
    } else if (part != "." && (!part.empty() || begin == 0)) {
      parts.push_back(part);
    }
    begin = end + 1;
  }
  std::string clean;
  for (std::size_t i = 0; i < parts.size(); ++i) clean += (i == 0 ? "" : "/") + parts[i];
  return clean;
}

Module* loaded(const Session& session, const std::string& name, bool from_stdlib) {
  for (const auto& module : session.modules) {
    if (module->name == name && module->from_stdlib == from_stdlib) return module.get();
  }
  return nullptr;
}

/// The modules from the one that is imported again to the one that does so, and back.
void report_circle(Session& session, const Module& importer, const syntax::Import& written, const Module& again) {
  std::string path;
  for (const auto& module : session.modules) {
    const bool on_the_way = module->loading && (module.get() == &again || !path.empty());
    if (on_the_way) path += "`" + module->name + "` -> ";
  }
  path += "`" + again.name + "`";
  session.report.add(Problem("E0105", "modules import each other in a circle: " + path)
                         .at(importer.at(written), "this closes the circle")
                         .help("move what both need into a third module"));
}

Module* load_module(Session& session, Module& importer, const syntax::Import& written) {
  const auto path_token = written.path();
  const auto module_token = written.module();
  if (!path_token && !module_token) return nullptr;
  const std::string wanted = path_token ? syntax::string_value(*path_token, session.sources[importer.file])
                                        : session.name_of(importer, module_token);
  const bool from_stdlib = !path_token.has_value();
  const std::string name = from_stdlib ? wanted : beside(importer.name, wanted);
  if (Module* earlier = loaded(session, name, from_stdlib)) {
    if (!earlier->loading) return earlier;
    report_circle(session, importer, written, *earlier);
    return nullptr;
  }
  const Location at = path_token ? importer.at(*path_token) : importer.at(*module_token);
  if (session.modules.size() >= most_modules) {
    session.report.add(Problem("E0113", fmt::format("more than {} modules", most_modules)).at(at));
    return nullptr;
  }
  std::optional<std::string> text =
      from_stdlib ? session.world.module(wanted) : session.world.read(wanted, importer.name);
  if (!text) {
    Problem problem("E0104", from_stdlib ? fmt::format("there is no module `{}` in the standard library", wanted)
                                         : fmt::format("the file \"{}\" cannot be read", wanted));
    problem.at(at);
    problem.help(from_stdlib ? suggestion(wanted, session.world.module_names())
                             : "the path is relative to the file that imports it");
    session.report.add(problem);
    importer.not_found.push_back(wanted);
    return nullptr;
  }
  return &add_module(session, name, std::move(*text), from_stdlib);
}

}  // namespace

Module& add_module(Session& session, const std::string& name, std::string text, bool from_stdlib) {
  session.modules.push_back(std::make_unique<Module>());
  Module& module = *session.modules.back();
  module.name = name;
  module.from_stdlib = from_stdlib;
  module.loading = true;
  module.file = session.sources.add(Source(from_stdlib ? "<" + name + ">" : name, std::move(text)));
  module.parsed = syntax::parse(session.sources[module.file]);
  module.scope = std::make_unique<Scope>(module, nullptr);
  read_allowances(session, module);
  report_syntax_errors(session, module);
  define_module(session, module);
  module.loading = false;
  return module;
}

void define_import(Session& session, Module& importer, const syntax::Import& written) {
  Module* module = load_module(session, importer, written);
  const auto compute = [module] { return module == nullptr ? Value{} : Value{ModuleRef{module}}; };
  const auto path = written.path();
  const std::string name = written.alias()    ? session.name_of(importer, written.alias())
                           : written.module() ? session.name_of(importer, written.module())
                           : path             ? module_stem(syntax::string_value(*path, session.sources[importer.file]))
                                              : "";
  if (module != nullptr) importer.imports.emplace_back(name, module);
  if (written.alias() || written.module()) {
    define(session, *importer.scope, written.alias() ? written.alias() : written.module(), compute);
    return;
  }
  if (path) {
    if (importer.scope->define(name, importer.at(*path), compute) != nullptr) return;
    session.report.add(Problem("E0102", "`" + name + "` is defined twice")
                           .at(importer.at(*path), "imported under this name here")
                           .also(importer.scope->own(name)->at, "first defined here")
                           .help("give the module another name: import \"...\" as other"));
  }
}

std::string module_stem(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  const std::string file = slash == std::string::npos ? name : name.substr(slash + 1);
  return file.substr(0, file.find('.'));
}

void add_setting(Session& session, const Setting& setting) {
  session.modules.push_back(std::make_unique<Module>());
  Module& module = *session.modules.back();
  module.name = "--set " + setting.name;
  module.file = session.sources.add(Source(module.name, setting.expression));
  module.parsed = syntax::parse_expression(session.sources[module.file]);
  module.scope = std::make_unique<Scope>(module, nullptr);
  report_syntax_errors(session, module);
  session.settings.push_back({setting.name, &module, false});
}

std::optional<syntax::Expr> setting_value(const Module& module) {
  if (!module.parsed.errors.empty()) return std::nullopt;
  return syntax::child<syntax::Expr>(syntax::root(module.parsed.tree));
}

}  // namespace toile
