#include "compiler/evaluate/names.hpp"

#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/builtins.hpp"

namespace toile {
namespace {

void report_circle(Session& session, const Definition& definition) {
  const auto first = std::find(session.running.begin(), session.running.end(), &definition);
  std::string path;
  for (auto it = first; it != session.running.end(); ++it) path += "`" + (*it)->name + "` -> ";
  path += "`" + definition.name + "`";
  Problem told("E0106", "`" + definition.name + "` depends on itself: " + path);
  for (auto it = first; it != session.running.end(); ++it) {
    const std::string& next = it + 1 == session.running.end() ? definition.name : (*(it + 1))->name;
    if (*it == &definition) {
      told.at((*it)->at, "needs `" + next + "`");
    } else {
      told.also((*it)->at, "needs `" + next + "`");
    }
  }
  session.report.add(told);
}

/// Names inside text that the parser gave up on may well be defined there.
bool stands_in_broken_text(const Session& session, const Module& module, std::string_view name) {
  if (module.parsed.errors.empty()) return false;
  const syntax::Tree& tree = module.parsed.tree;
  for (syntax::NodeId id = 0; id < tree.size(); ++id) {
    if (tree[id].kind != syntax::Kind::Error) continue;
    if (session.sources[module.file].slice(tree[id].span).find(name) != std::string_view::npos) return true;
  }
  return false;
}

bool callable(const Value& value) {
  return value.unknown() || value.as<FunctionRef>() != nullptr || value.as<BuiltinRef>() != nullptr ||
         value.as<BodyTemplateRef>() != nullptr || value.as<GarmentTemplateRef>() != nullptr ||
         value.as<PieceTemplateRef>() != nullptr;
}

/// The value tried, or the one made before, as long as that holds.
std::optional<Value> value_at_hand(Session& session, Definition& definition) {
  if (definition.tried) {
    note_try(session, definition.tried->depth);
    return definition.tried->value;
  }
  if (definition.state != Definition::State::Done) return std::nullopt;
  if (!definition.depends_on_try) return definition.value;
  if (definition.made_in_try != session.tries) return std::nullopt;
  note_try(session, *definition.depends_on_try);
  return definition.value;
}

/// Whether what runs inside of the definition is a solve whose equations need it: `let area = side^2` asks for `side`,
/// and that is sought so that the area comes out right. With a value to try that is no circle.
bool needed_by_a_try(const Session& session, const Definition& definition) {
  for (auto inner = session.running.rbegin(); inner != session.running.rend() && *inner != &definition; ++inner) {
    if ((*inner)->tried) return true;
  }
  return false;
}

Value computed_for_a_try(Session& session, Definition& definition) {
  const std::optional<std::size_t> depended = definition.depends_on_try;
  session.running.push_back(&definition);
  const Holding<int> for_real(session.supposing, 0);
  Value value = definition.compute();
  session.running.pop_back();
  definition.depends_on_try = depended;
  return value;
}

/// A definition inside a call, seen from a branch that is not taken: computed in supposition only.
Value supposed_value(Definition& definition) {
  if (definition.tried) return forget(definition.tried->value);
  if (definition.state == Definition::State::Done) return forget(definition.value);
  if (definition.state == Definition::State::Running) return Unknown{};
  if (!definition.supposed) {
    definition.supposed = Value{};  // what a circle sees
    definition.supposed = forget(definition.compute());
  }
  return *definition.supposed;
}

Value value_of(Session& session, Definition& definition, const Scope& where) {
  if (session.supposing > 0 && where.is_call()) return supposed_value(definition);
  Value value = force(session, definition);
  return session.supposing > 0 ? forget(value) : value;
}

}  // namespace

void note_try(Session& session, std::size_t depth) {
  for (std::size_t i = depth + 1; i < session.running.size(); ++i) {
    std::optional<std::size_t>& depends = session.running[i]->depends_on_try;
    depends = std::min(depends.value_or(depth), depth);
  }
}

std::optional<std::size_t> depth_of_try(const Session& session) {
  if (session.running.empty()) return std::nullopt;
  const Definition& innermost = *session.running.back();
  return innermost.tried ? std::optional(innermost.tried->depth) : innermost.depends_on_try;
}

void mark_try(const Session& session, Definition& definition) {
  definition.depends_on_try = depth_of_try(session);
  definition.made_in_try = session.tries;
}

Value force(Session& session, Definition& definition) {
  if (const std::optional<Value> value = value_at_hand(session, definition)) return *value;
  if (definition.state == Definition::State::Running) {
    if (needed_by_a_try(session, definition)) return computed_for_a_try(session, definition);
    report_circle(session, definition);
    return Unknown{};
  }
  definition.state = Definition::State::Running;
  definition.depends_on_try.reset();
  session.running.push_back(&definition);
  const std::size_t put_aside = session.report.put_aside();
  Value value;
  {
    const Holding<int> for_real(session.supposing, 0);
    value = definition.compute();
  }
  session.running.pop_back();
  definition.made_in_try = session.tries;
  if (!definition.depends_on_try) session.report.release(put_aside);
  // What only a drape will tell is asked for again after it.
  const bool settled = value.unknown() || value.known();
  definition.state = settled ? Definition::State::Done : Definition::State::Fresh;
  if (settled) definition.value = value;
  return value;
}

void report_unknown(Session& session, const Module& module, const syntax::Token& name, const std::string& message,
                    const std::vector<std::string>& known, const std::string& code) {
  const std::string text = session.name_of(module, name);
  if (session.report.full()) return;
  if (stands_in_broken_text(session, module, text)) return;
  session.report.add(Problem(code, message).at(module.at(name)).help(suggestion(text, known)));
}

namespace {

/// The name of an imported module that has a definition of that name.
std::string importing(const Scope& scope, std::string_view text) {
  for (const auto& [name, module] : scope.module().imports) {
    if (module->scope->own(text) != nullptr) return name;
  }
  return "";
}

}  // namespace

Value look_up(Session& session, const Scope& scope, const syntax::Token& name, Wish wish) {
  const std::string_view text = session.text(scope.module(), name);
  const Builtin* builtin = find_builtin(text);
  const Scope* where = nullptr;
  if (Definition* definition = scope.find(text, &where, wish == Wish::Curve)) {
    definition->used = true;
    Value value = value_of(session, *definition, *where);
    if (wish != Wish::Function || builtin == nullptr || callable(value)) return value;
  }
  if (builtin != nullptr) return builtin->constant ? *builtin->constant : Value{BuiltinRef{builtin}};
  if (session.report.full()) return Unknown{};
  if (nearest(text, scope.module().not_found)) return Unknown{};  // what was to be imported
  // Of the commands one is told of a name that is not there, as that of a drape that was forgotten.
  if (&scope == scope.module().scope.get() && !scope.module().told.emplace(text).second) return Unknown{};
  std::vector<std::string> known = scope.visible_names();
  const std::vector<std::string> functions = builtin_names();
  known.insert(known.end(), functions.begin(), functions.end());
  if (scope.is_doubled() && !nearest(text, known)) return Unknown{};  // one of the two may have been meant
  std::string message = "there is no `" + std::string(text) + "` here";
  if (const std::string module = importing(scope, text); !module.empty()) {
    session.report.add(
        Problem("E0101", message).at(scope.module().at(name)).help("write `" + module + "." + std::string(text) + "`"));
    return Unknown{};
  }
  if (suggestion(text, known).empty()) {
    for (const std::string& module : session.world.module_names()) {
      if (module != text || scope.find(module) != nullptr) continue;
      session.report.add(Problem("E0101", message).at(scope.module().at(name)).help("import " + module));
      return Unknown{};
    }
  }
  report_unknown(session, scope.module(), name, message, known);
  return Unknown{};
}

Definition* define(Session& session, Scope& scope, const std::optional<syntax::Token>& name,
                   std::function<Value()> compute) {
  return define(session, scope, scope.module(), name, std::move(compute));
}

Definition* define(Session& session, Scope& scope, const Module& module, const std::optional<syntax::Token>& name,
                   std::function<Value()> compute) {
  if (!name) return nullptr;
  const std::string text = session.name_of(module, name);
  const Location at = module.at(*name);
  Definition* made = scope.define(text, at, std::move(compute));
  if (made == nullptr) {
    session.report.add(Problem("E0102", "`" + text + "` is defined twice")
                           .at(at, "defined again here")
                           .also(scope.own(text)->at, "first defined here")
                           .help("choose another name for one of them"));
  }
  return made;
}

}  // namespace toile
