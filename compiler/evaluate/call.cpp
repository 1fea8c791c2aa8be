#include "compiler/evaluate/call.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/builtins.hpp"
#include "compiler/evaluate/definitions.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/free_pieces.hpp"
#include "compiler/evaluate/garments.hpp"
#include "compiler/evaluate/measurements.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/solve.hpp"

namespace toile {
namespace {

constexpr int deepest_call = 150;

using Arguments = std::vector<std::optional<Given>>;

/// "it is called as band(around, depth: …)": what may be left out is marked.
std::string written_call(const std::string& callee, const std::vector<Formal>& formals) {
  std::string name = callee;
  std::erase(name, '`');
  std::vector<std::string> shown;
  for (const Formal& formal : formals) shown.push_back(formal.optional ? formal.name + ": ..." : formal.name);
  return fmt::format("it is called as {}({})", name, fmt::join(shown, ", "));
}

/// Finds the parameter of one written argument; -1 after an error.
class Binder {
 public:
  Binder(Session& session, const Module& module, const std::string& callee, const std::vector<Formal>& formals,
         bool variadic)
      : session_(session), module_(module), callee_(callee), formals_(formals), variadic_(variadic) {}

  int place_of(const syntax::Argument& argument, const Arguments& taken) {
    const auto name = argument.name();
    if (!name) return next_place(argument, taken);
    const std::string text = session_.name_of(module_, name);
    if (const int i = formal_called(text); i >= 0) {
      if (!taken[static_cast<std::size_t>(i)]) return i;
      session_.report.add(Problem("E0109", fmt::format("`{}` is given twice", text))
                              .at(module_.at(argument), "given again here")
                              .also(taken[static_cast<std::size_t>(i)]->at, "already given here"));
      return -1;
    }
    const std::string message = fmt::format("{} takes no `{}`", callee_, text);
    if (const std::string advice = advice_on_measurement(text); !advice.empty()) {
      session_.report.add(Problem("E0107", message).at(module_.at(*name)).help(advice));
      return -1;
    }
    std::vector<std::string> names;
    for (const Formal& formal : formals_) names.push_back(formal.name);
    report_unknown(session_, module_, *name, message, names, "E0107");
    return -1;
  }

  /// Gives each parameter that is still without a value the record's field of its name. False after an error.
  bool spread(const Given& record, Arguments& taken) {
    const auto* fields = record.value.as<RecordValue>();
    if (fields == nullptr) {
      session_.report.add(
          Problem("E0202", "only a record's values are given by `...`, and this is " + describe(record.value))
              .at(record.at, describe(record.value)));
      return false;
    }
    bool used = false;
    for (const RecordValue::Field& field : *fields->fields) {
      const int i = formal_called(field.name);
      used = used || i >= 0;
      if (i >= 0 && !taken[static_cast<std::size_t>(i)]) taken[static_cast<std::size_t>(i)] = {field.value, record.at};
    }
    if (used) return true;
    std::vector<std::string> names;
    for (const Formal& formal : formals_) names.push_back(formal.name);
    session_.report.add(Problem("E0107", fmt::format("{} takes nothing of this record", callee_))
                            .at(record.at, format(record.value))
                            .help(fmt::format("it takes {}", fmt::join(names, ", "))));
    return false;
  }

 private:
  /// By its name, or by another name of that measurement; -1 for none.
  int formal_called(std::string_view name) const {
    auto found = std::ranges::find(formals_, name, &Formal::name);
    if (found == formals_.end()) {
      found =
          std::ranges::find_if(formals_, [name](const Formal& formal) { return same_measurement(formal.name, name); });
    }
    return found == formals_.end() ? -1 : static_cast<int>(found - formals_.begin());
  }

  int next_place(const syntax::Argument& argument, const Arguments& taken) {
    const int place = positional_++;
    if (place < static_cast<int>(formals_.size())) {
      if (!taken[static_cast<std::size_t>(place)]) return place;
      session_.report.add(
          Problem("E0109", fmt::format("`{}` is given twice", formals_[static_cast<std::size_t>(place)].name))
              .at(module_.at(argument), "given again here, by its place")
              .also(taken[static_cast<std::size_t>(place)]->at, "already given here"));
      return -1;
    }
    if (variadic_) return place;
    session_.report.add(
        Problem("E0107", fmt::format("{} takes {}", callee_,
                                     formals_.empty()       ? "no arguments"
                                     : formals_.size() == 1 ? "one argument"
                                                            : fmt::format("at most {} arguments", formals_.size())))
            .at(module_.at(argument), "this is one too many")
            .help(formals_.empty() ? "" : written_call(callee_, formals_)));
    return -1;
  }

  Session& session_;
  const Module& module_;
  const std::string& callee_;
  const std::vector<Formal>& formals_;
  bool variadic_;
  int positional_ = 0;
};

std::string signature_of(const std::vector<std::optional<Given>>& arguments) {
  std::string text;
  for (const auto& argument : arguments) text += (argument ? signature(argument->value) : "-") + ";";
  return text;
}

Value body_of_function(Session& session, const UserFunction& function, const Arguments& arguments) {
  Scope inside(function.scope->module(), function.scope, true, signature_of(arguments));
  if (const auto parameters = function.written.parameters()) {
    define_parameters(session, inside, *parameters, arguments);
  }
  if (const auto block = function.written.block()) {
    for (const syntax::View item : syntax::items(*block)) {
      if (const auto let = syntax::as<syntax::Let>(item)) define_let(session, inside, *let);
      if (const auto solve = syntax::as<syntax::Solve>(item)) define_solve(session, inside, *solve);
    }
  }
  Value result = evaluate(session, inside, function.written.result());
  if (session.supposing > 0) {
    // What the result does not use is checked all the same.
    for (const auto& definition : inside.definitions()) {
      if (definition->state == Definition::State::Fresh && !definition->supposed) definition->compute();
    }
  }
  return result;
}

/// Whether calls are nested beyond all reason; reported.
bool too_deep(Session& session, const std::string& name, Location at) {
  if (session.call_depth < deepest_call) return false;
  session.report.add(Problem("E0113", fmt::format("calls of {} are nested more than {} deep", name, deepest_call))
                         .at(at, "in this call")
                         .help("what calls itself needs a case in which it does not: if n <= 1 then ..."));
  session.exhausted = true;
  return true;
}

Value call_function(Session& session, const UserFunction& function, const Arguments& arguments, Location at) {
  session.report.enter_call(at);
  Value result;
  if (session.supposing == 0) {
    result = body_of_function(session, function, arguments);
  } else {
    const auto key = std::pair(&function, signature_of(arguments));
    const auto [found, is_new] = session.supposed_calls.try_emplace(key);
    if (is_new) {
      result = forget(body_of_function(session, function, arguments));
      session.supposed_calls[key] = result;
    } else {
      result = found->second;
    }
  }
  session.report.leave_call();
  return result;
}

std::string name_of_callee(const Session& session, const Module& module, const syntax::Expr& callee) {
  return "`" + std::string(session.text(module, callee)) + "`";
}

}  // namespace

std::optional<std::vector<std::optional<Given>>> bind_arguments(Session& session, const Scope& scope,
                                                                const syntax::Call& written, const std::string& callee,
                                                                const std::vector<Formal>& formals, bool variadic) {
  const Module& module = scope.module();
  Arguments taken(formals.size());
  Binder binder(session, module, callee, formals, variadic);
  bool sound = true;
  std::vector<Given> records;
  for (const syntax::Argument& argument : written.arguments()) {
    if (argument.spread()) {
      records.push_back({evaluate(session, scope, argument.value()), module.at(argument)});
      continue;
    }
    const int place = binder.place_of(argument, taken);
    const bool curve = place >= 0 && formals[std::min<std::size_t>(place, formals.size() - 1)].curve;
    const Value value =
        curve ? evaluate_curve(session, scope, argument.value()) : evaluate(session, scope, argument.value());
    if (place < 0) {
      sound = false;
      continue;
    }
    if (place >= static_cast<int>(taken.size())) taken.resize(static_cast<std::size_t>(place) + 1);
    const auto expr = argument.value();
    taken[static_cast<std::size_t>(place)] = Given{value, expr ? module.at(*expr) : module.at(argument)};
  }
  // What is given by itself comes before what a record has.
  for (const Given& record : records) {
    if (record.value.unknown()) return std::nullopt;
    sound = binder.spread(record, taken) && sound;
  }
  if (!sound) return std::nullopt;
  for (std::size_t i = 0; i < formals.size(); ++i) {
    if (taken[i] || formals[i].optional) continue;
    sound = false;
    if (module.broken(written.span())) continue;
    session.report.add(Problem("E0108", fmt::format("{} needs `{}`", callee, formals[i].name))
                           .at(module.at(written), "not given here")
                           .help(written_call(callee, formals)));
  }
  if (!sound) return std::nullopt;
  return taken;
}

std::vector<Formal> formals_of(const Session& session, const Module& module,
                               const std::optional<syntax::Parameters>& parameters) {
  std::vector<Formal> formals;
  if (!parameters) return formals;
  for (const syntax::Parameter& parameter : parameters->list()) {
    const std::string name = session.name_of(module, parameter.name());
    const bool again =
        std::any_of(formals.begin(), formals.end(), [&](const Formal& each) { return each.name == name; });
    formals.push_back({name, parameter.fallback().has_value() || again});
  }
  return formals;
}

void define_parameters(Session& session, Scope& inside, const syntax::Parameters& parameters,
                       const std::vector<std::optional<Given>>& arguments) {
  const std::vector<syntax::Parameter> list = parameters.list();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto fallback = list[i].fallback();
    const std::optional<Given> given = i < arguments.size() ? arguments[i] : std::nullopt;
    const std::optional<std::size_t> depth = depth_of_try(session);
    define(session, inside, list[i].name(), [&session, &inside, given, fallback, depth]() -> Value {
      if (depth) note_try(session, *depth);
      if (!given) return evaluate(session, inside, fallback);
      if (!fallback) return given->value;
      // The default tells the kind that is wanted.
      const Value wanted = suppose(session, inside, fallback);
      if (alike(wanted, given->value)) return given->value;
      session.report.add(Problem("E0203", "this parameter is " + describe(wanted) + ", not " + describe(given->value))
                             .at(given->at, describe(given->value))
                             .also(inside.module().at(*fallback), "the default is " + describe(wanted)));
      return Unknown{};
    });
  }
}

Value call(Session& session, const Scope& scope, const syntax::Call& written) {
  const auto callee_expr = written.callee();
  if (!callee_expr) return Unknown{};
  Value callee;
  if (const auto ref = syntax::as<syntax::NameRef>(*callee_expr); ref && ref->name()) {
    callee = look_up(session, scope, *ref->name(), Wish::Function);
  } else {
    callee = evaluate(session, scope, *callee_expr);
  }
  const Module& module = scope.module();
  const Location at = module.at(written);
  const std::string name = name_of_callee(session, module, *callee_expr);
  if (const auto* builtin = callee.as<BuiltinRef>()) return call_builtin(session, scope, written, **builtin);
  if (!callee.unknown() && too_deep(session, name, at)) return Unknown{};
  const Holding<int> deeper(session.call_depth, session.call_depth + 1);
  if (const auto* function = callee.as<FunctionRef>()) {
    const auto formals = formals_of(session, (*function)->scope->module(), (*function)->written.parameters());
    const auto arguments = bind_arguments(session, scope, written, name, formals);
    return arguments ? call_function(session, **function, *arguments, at) : Value{};
  }
  if (const auto* body = callee.as<BodyTemplateRef>()) {
    const auto formals = formals_of(session, (*body)->scope->module(), (*body)->written.parameters());
    const auto arguments = bind_arguments(session, scope, written, name, formals);
    return arguments ? instantiate(session, **body, *arguments) : Value{};
  }
  if (const auto* garment = callee.as<GarmentTemplateRef>()) {
    const auto formals = formals_of(session, (*garment)->scope->module(), (*garment)->written.parameters());
    const auto arguments = bind_arguments(session, scope, written, name, formals);
    return arguments ? instantiate(session, **garment, *arguments) : Value{};
  }
  if (const auto* piece = callee.as<PieceTemplateRef>()) {
    const auto formals = formals_of(session, (*piece)->scope->module(), (*piece)->written.parameters());
    const auto arguments = bind_arguments(session, scope, written, name, formals);
    return arguments ? instantiate(session, **piece, *arguments) : Value{};
  }
  for (const syntax::Argument& argument : written.arguments()) evaluate(session, scope, argument.value());
  if (callee.unknown()) return Unknown{};
  session.report.add(Problem("E0210", fmt::format("{} is {} and takes no arguments", name, describe(callee)))
                         .at(module.at(*callee_expr), describe(callee)));
  return Unknown{};
}

void check_function(Session& session, const UserFunction& function) {
  const Holding<int> supposing(session.supposing, session.supposing + 1);
  Arguments unknown;
  if (const auto parameters = function.written.parameters()) {
    for (const syntax::Parameter& parameter : parameters->list()) {
      if (parameter.fallback()) {
        unknown.emplace_back();
      } else {
        unknown.emplace_back(Given{Unknown{}, function.scope->module().at(parameter)});
      }
    }
  }
  body_of_function(session, function, unknown);
}

}  // namespace toile
