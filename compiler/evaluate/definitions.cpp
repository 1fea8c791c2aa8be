#include "compiler/evaluate/definitions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/arithmetic.hpp"
#include "compiler/evaluate/bodies.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/fabrics.hpp"
#include "compiler/evaluate/free_pieces.hpp"
#include "compiler/evaluate/garments.hpp"
#include "compiler/evaluate/modules.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/sizes.hpp"
#include "compiler/evaluate/solve.hpp"

namespace toile {
namespace {

/// A param's value: its default, or what a setting says; either must lie in the range.
class ParamReader {
 public:
  ParamReader(Session& session, const Scope& scope, const syntax::Param& written, const std::string& full_name)
      : session_(session), scope_(scope), module_(scope.module()), written_(written), full_name_(full_name) {}

  Value read() {
    const auto value_expr = written_.value();
    Value fallback = evaluate(session_, scope_, value_expr);
    const bool has_range = read_range(fallback);
    if (misfits_) return Unknown{};
    if (has_range && !inside(fallback, module_.at(*value_expr), "the default")) return Unknown{};
    if (value_expr && !chosen(fallback, module_.at(*value_expr), "the default")) return Unknown{};
    for (Session::GivenSetting& setting : session_.settings) {
      if (setting.name != full_name_) continue;
      setting.taken = true;
      return from_setting(setting, fallback, has_range);
    }
    return fallback;
  }

 private:
  Value from_setting(const Session::GivenSetting& setting, const Value& fallback, bool has_range) {
    const auto given = setting_value(*setting.module);
    if (!given) return Unknown{};
    const Scope inside_setting(*setting.module, session_.modules.front()->scope.get());
    Value value = evaluate(session_, inside_setting, *given);
    if (value.unknown() || fallback.unknown()) return Unknown{};
    const Location at = setting.module->at(*given);
    if (!alike(value, fallback)) {
      session_.report.add(Problem("E0201", fmt::format("param `{}` is {}, and the setting is {}", full_name_,
                                                       describe(fallback), describe(value)))
                              .at(at, describe(value))
                              .also(module_.at(*written_.value()), "the default is " + describe(fallback)));
      return Unknown{};
    }
    if (has_range && !inside(value, at, "this value")) return Unknown{};
    return chosen(value, at, "this value") ? value : Value{};
  }

  bool read_range(const Value& fallback) {
    const auto range = written_.range();
    if (!range) return false;
    const auto low_expr = range->low();
    const auto high_expr = range->high();
    low_ = evaluate(session_, scope_, low_expr);
    high_ = evaluate(session_, scope_, high_expr);
    if (fallback.unknown() || low_.unknown() || high_.unknown()) return false;
    for (const auto& [end, expr] : {std::pair(low_, low_expr), std::pair(high_, high_expr)}) {
      if (alike(end, fallback) && end.as<Quantity>() != nullptr) continue;
      const auto* given = fallback.as<Quantity>();
      const auto* limit = end.as<Quantity>();
      const bool no_unit =
          given != nullptr && limit != nullptr && given->dimension.plain() && limit->dimension == dimension::length;
      session_.report.add(Problem("E0201", fmt::format("the range of `{}` is {}, and its default is {}", full_name_,
                                                       describe(end), describe(fallback)))
                              .at(module_.at(*expr), describe(end))
                              .at(module_.at(*written_.value()), describe(fallback))
                              .help(no_unit ? "every length has its unit: `2cm`, not `2`" : ""));
      misfits_ = true;
      return false;
    }
    if (!low_.known() || !high_.known() || !fallback.known()) return false;
    if (low_.as<Quantity>()->si <= high_.as<Quantity>()->si) return true;
    session_.report.add(
        Problem("E0112", fmt::format("the range of `{}` is upside down: {} is more than {}", full_name_, format(low_),
                                     format(high_)))
            .at(module_.at(*range))
            .help(fmt::format("in {} .. {}", session_.text(module_, *high_expr), session_.text(module_, *low_expr))));
    return false;
  }

  bool inside(const Value& value, Location at, const std::string& whose) {
    const double si = value.as<Quantity>()->si;
    const double low = low_.as<Quantity>()->si;
    const double high = high_.as<Quantity>()->si;
    const double slack = 1e-12 * (std::abs(low) + std::abs(high));  // 0.3m is not quite 30cm in binary
    if (si >= low - slack && si <= high + slack) return true;
    session_.report.add(Problem("E0111", fmt::format("{} of `{}` is out of range: {} is not within {} .. {}", whose,
                                                     full_name_, format(value), format(low_), format(high_)))
                            .at(at, "this is " + format(value))
                            .also(module_.at(*written_.range()), "the range"));
    return false;
  }

  /// Whether the value is among the choices, where the param has any.
  bool chosen(const Value& value, Location at, const std::string& whose) {
    const auto choices = written_.choices();
    if (!choices || !choices->list()) return true;
    const Value list = evaluate(session_, scope_, choices->list());
    const auto* offered = list.as<ListValue>();
    if (offered == nullptr || !list.known() || !value.known()) return true;
    std::vector<std::string> shown;
    const Location there = module_.at(*choices->list());
    for (const Value& each : *offered->items) {
      if (!alike(value, each)) {
        session_.report.add(Problem("E0202", fmt::format("{} of `{}` is {}, and its choices are of another kind: {}",
                                                         whose, full_name_, describe(value), describe(each)))
                                .at(at, describe(value))
                                .also(there, describe(each)));
        return false;
      }
      const Value same = apply_binary(session_, syntax::Kind::Equal, {value, at}, {each, there}, at);
      const auto* truth = same.as<Truth>();
      if (truth == nullptr || !same.known()) return false;
      if (truth->value) return true;
      shown.push_back(format(each));
    }
    if (shown.empty()) {
      session_.report.add(Problem("E0117", fmt::format("`{}` has no choices", full_name_)).at(there));
      return false;
    }
    session_.report.add(Problem("E0117", fmt::format("{} of `{}`, {}, is not among its choices: {}", whose, full_name_,
                                                     format(value), fmt::join(shown, ", ")))
                            .at(at, "this is " + format(value))
                            .also(module_.at(*choices), "the choices")
                            .help(suggestion(format(value), shown)));
    return false;
  }

  Session& session_;
  const Scope& scope_;
  const Module& module_;
  const syntax::Param& written_;
  const std::string& full_name_;
  Value low_;
  Value high_;
  bool misfits_ = false;  // the range is of another dimension: either may be meant
};

/// How settings call the params of a module: those of the script by their own names.
std::string prefix_of(const Session& session, const Module& module) {
  return &module == session.modules.front().get() ? "" : module_stem(module.name) + ".";
}

}  // namespace

void define_let(Session& session, Scope& scope, const syntax::Let& written) {
  define(session, scope, written.name(),
         [&session, &scope, expr = written.value()] { return evaluate(session, scope, expr); });
}

void define_function(Session& session, Scope& scope, const syntax::Fn& written) {
  session.functions.push_back({written, &scope});
  const FunctionRef function = &session.functions.back();
  define(session, scope, written.name(), [function]() -> Value { return function; });
}

void define_param(Session& session, Scope& scope, const syntax::Param& written, const std::string& prefix) {
  const std::string full_name = prefix + session.name_of(scope.module(), written.name());
  session.param_names.push_back(full_name);
  define(session, scope, written.name(),
         [&session, &scope, written, full_name] { return ParamReader(session, scope, written, full_name).read(); });
}

void define_module(Session& session, Module& module) {
  Scope& scope = *module.scope;
  const std::string prefix = prefix_of(session, module);
  for (const syntax::View item : syntax::items(syntax::root(module.parsed.tree))) {
    if (const auto import = syntax::as<syntax::Import>(item)) {
      define_import(session, module, *import);
    } else if (const auto param = syntax::as<syntax::Param>(item)) {
      define_param(session, scope, *param, prefix);
    } else if (const auto let = syntax::as<syntax::Let>(item)) {
      define_let(session, scope, *let);
    } else if (const auto solve = syntax::as<syntax::Solve>(item)) {
      define_solve(session, scope, *solve);
    } else if (const auto fn = syntax::as<syntax::Fn>(item)) {
      define_function(session, scope, *fn);
    } else if (const auto body = syntax::as<syntax::Body>(item)) {
      define_body(session, scope, *body);
    } else if (const auto fabric = syntax::as<syntax::Fabric>(item)) {
      define_fabric(session, scope, *fabric);
    } else if (const auto textile = syntax::as<syntax::Textile>(item)) {
      define_textile(session, scope, *textile);
    } else if (const auto sizes = syntax::as<syntax::Sizes>(item)) {
      define_sizes(session, scope, *sizes);
    } else if (const auto garment = syntax::as<syntax::Garment>(item)) {
      define_garment(session, scope, *garment);
    } else if (const auto piece = syntax::as<syntax::Piece>(item)) {
      define_free_piece(session, scope, *piece);
    } else {
      module.commands.push_back(item);
    }
  }
}

void check_module(Session& session, Module& module) {
  for (const auto& definition : module.scope->definitions()) force(session, *definition);
}

void check_functions(Session& session) {
  for (const UserFunction& function : session.functions) {
    if (!function.scope->module().from_stdlib) check_function(session, function);
  }
}

void report_unused_settings(Session& session) {
  for (const Session::GivenSetting& setting : session.settings) {
    if (setting.taken) continue;
    session.report.add(Problem("E0110", fmt::format("this script has no param `{}`", setting.name))
                           .at({setting.module->file, {0, 0}})
                           .help(suggestion(setting.name, session.param_names)));
  }
}

}  // namespace toile
