#include "compiler/evaluate/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/trial.hpp"
#include "compiler/solve/least_squares.hpp"
#include "compiler/solve/root.hpp"
#include "compiler/units/format.hpp"

namespace toile {
namespace {

constexpr int places_looked_at = 33;     // in a range whose ends do not tell
constexpr double equal_enough = 1e-7;    // of the size of both sides
constexpr double equal_at_zero = 1e-9;   // [SI]
constexpr double smallest_scale = 1e-2;  // [SI] sides smaller than this are not measured against themselves

/// One place of a range with the two sides there, where they have values.
struct Place {
  double at = 0;
  std::optional<Sides> sides;

  std::optional<double> difference() const { return sides ? std::optional(sides->differences[0]) : std::nullopt; }
};

class Solver {
 public:
  Solver(Session& session, const Scope& scope, const syntax::Solve& written)
      : session_(session), scope_(scope), module_(scope.module()), written_(written) {}

  std::vector<SoughtValue>& sought() { return sought_; }

  /// Solves, and gives the first unknown.
  Value lead() {
    found_.clear();
    if (!read_ranges()) return Unknown{};
    Trial trial(session_, scope_, written_, sought_);
    if (session_.supposing > 0) return trial.suppose() ? forget(sought_[0].low) : Value{};
    if (sought_.size() == 1) {
      solve_for_one(trial);
    } else {
      solve_for_several(trial);
    }
    if (found_.empty()) return Unknown{};
    (void)trial.look_openly(found_);
    return trial.value(0, found_[0]);
  }

  /// Another unknown: the first one brings them all.
  Value follow(std::size_t i) {
    const auto range = sought_[i].written.range();
    if (sought_[0].definition == nullptr || !range) return Unknown{};  // its name was taken, or its range was not read
    if (session_.supposing > 0) return forget(evaluate(session_, scope_, range->low()));
    force(session_, *sought_[0].definition);
    return i < found_.size() ? Trial(session_, scope_, written_, sought_).value(i, found_[i]) : Value{};
  }

 private:
  bool read_ranges() {
    for (SoughtValue& each : sought_) {
      const auto range = each.written.range();
      if (!range || !range->low() || !range->high() || each.definition == nullptr) return false;
      each.low = evaluate(session_, scope_, range->low());
      each.high = evaluate(session_, scope_, range->high());
      if (!check_range(each, *range)) return false;
    }
    for (const syntax::Equation& equation : written_.equations()) {
      if (!equation.left() || !equation.right()) return false;
    }
    return !written_.equations().empty();
  }

  bool check_range(const SoughtValue& each, const syntax::Range& range) {
    if (each.low.unknown() || each.high.unknown()) return false;
    const Location low_at = module_.at(*range.low());
    const Location high_at = module_.at(*range.high());
    if (each.low.as<Quantity>() == nullptr || !alike(each.low, each.high)) {
      session_.report.add(Problem("E0201", fmt::format("a range is from a quantity to one of its dimension, here {} "
                                                       "and {}",
                                                       describe(each.low), describe(each.high)))
                              .at(low_at, describe(each.low))
                              .at(high_at, describe(each.high)));
      return false;
    }
    if (session_.supposing > 0) return true;
    if (!each.low.known() || !each.high.known()) {
      session_.report.add(
          Problem("E0506", "a range cannot depend on a drape's result: patterns are drawn before").at(low_at));
      return false;
    }
    if (each.low.as<Quantity>()->si < each.high.as<Quantity>()->si) return true;
    session_.report.add(Problem("E0112", fmt::format("the range of `{}` is upside down: {} is not less than {}",
                                                     session_.name_of(module_, each.written.name()), format(each.low),
                                                     format(each.high)))
                            .at(module_.at(range)));
    return false;
  }

  // ------------------------------------------------------------------------------------------- one unknown

  void solve_for_one(Trial& trial) {
    const double low = sought_[0].low.as<Quantity>()->si;
    const double high = sought_[0].high.as<Quantity>()->si;
    std::vector<Place> places{look(trial, low), look(trial, high)};
    if (trial.hopeless()) return;
    if (changes_in(places).empty()) {
      for (int i = 1; i < places_looked_at - 1; ++i) {
        places.insert(places.end() - 1, look(trial, low + (high - low) * i / (places_looked_at - 1)));
      }
      if (trial.hopeless()) return;
    }
    const auto tried = std::find_if(places.begin(), places.end(), [](const Place& p) { return p.sides.has_value(); });
    if (tried == places.end()) return trial.report_failure();
    if (written_.equations().size() > 1 || tried->sides->differences.size() > 1) return solve_for_several(trial);
    const std::vector<std::size_t> changes = changes_in(places);
    if (changes.size() != 1) return report_no_root(trial, places, changes);
    close_in(trial, places[changes[0]], places[changes[0] + 1]);
  }

  Place look(Trial& trial, double at) {
    Place place{at, {}};
    if (const auto all = trial.look({at})) place.sides = all->front();
    return place;
  }

  /// Whether the difference gets to zero behind `a` and no later than at `b`.
  static bool changes_sign(const Place& a, const Place& b) {
    const auto left = a.difference();
    const auto right = b.difference();
    return left && right && ((*left < 0 && *right >= 0) || (*left > 0 && *right <= 0));
  }

  /// Where the difference changes its sign or begins with zero: each time the place before.
  static std::vector<std::size_t> changes_in(const std::vector<Place>& places) {
    std::vector<std::size_t> changes;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const bool begins = i == 0 || !places[i - 1].sides;
      const bool begins_with_zero = begins && places[i].difference() == 0.0 && places[i + 1].sides;
      if (begins_with_zero || changes_sign(places[i], places[i + 1])) changes.push_back(i);
    }
    return changes;
  }

  void close_in(Trial& trial, const Place& low, const Place& high) {
    const Function difference = [&](double at) { return look(trial, at).difference(); };
    const auto root = root_within(difference, {low.at, high.at, *low.difference(), *high.difference()});
    if (trial.hopeless()) return;
    const Place there = root ? look(trial, *root) : Place{};
    if (!there.sides) return trial.report_failure();
    if (std::abs(*there.difference()) <= equal_enough * there.sides->size + equal_at_zero) {
      found_ = {*root};
      return;
    }
    session_.report.add(Problem("E0114", fmt::format("the two sides jump past each other at {} and are never equal",
                                                     trial.shown({*root})))
                            .at(module_.at(*there.sides->written.left()), format(there.sides->left) + " there")
                            .at(module_.at(*there.sides->written.right()), format(there.sides->right) + " there"));
  }

  std::string range_shown() const { return format(sought_[0].low) + " .. " + format(sought_[0].high); }

  void report_no_root(Trial& trial, const std::vector<Place>& places, const std::vector<std::size_t>& changes) {
    const Place* low = &places.front();
    const Place* high = &places.back();
    for (const Place& place : places) {
      if (!low->sides && place.sides) low = &place;
      if (place.sides && !places.back().sides) high = &place;
    }
    const syntax::Equation& equation = low->sides->written;
    Problem problem("E0114", changes.empty() ? fmt::format("no `{}` within {} makes the two sides equal", trial.name(0),
                                                           range_shown())
                                             : fmt::format("more than one `{}` within {} makes the two sides equal",
                                                           trial.name(0), range_shown()));
    problem.at(module_.at(*equation.left()), at_both(trial, *low, low->sides->left, *high, high->sides->left))
        .at(module_.at(*equation.right()), at_both(trial, *low, low->sides->right, *high, high->sides->right));
    if (changes.empty()) {
      help_where_nearest(problem, trial, places);
    } else {
      std::string around;
      for (const std::size_t i : changes) {
        around += (around.empty() ? "" : " and ") + format(trial.value(0, (places[i].at + places[i + 1].at) / 2));
      }
      problem.help("they are equal near " + around + ": narrow the range to the one that is meant");
    }
    session_.report.add(problem);
  }

  static std::string at_both(const Trial& trial, const Place& low, const Value& first, const Place& high,
                             const Value& second) {
    const std::string a = format(first);
    const std::string b = format(second);
    return a == b ? a + " at both ends"
                  : fmt::format("{} at {}, {} at {}", a, trial.shown({low.at}), b, trial.shown({high.at}));
  }

  static void help_where_nearest(Problem& problem, const Trial& trial, const std::vector<Place>& places) {
    const Place* nearest = nullptr;
    const Place* farthest = nullptr;
    for (const Place& place : places) {
      if (!place.sides) continue;
      if (farthest == nullptr || std::abs(*place.difference()) > std::abs(*farthest->difference())) farthest = &place;
      if (nearest == nullptr || std::abs(*place.difference()) < std::abs(*nearest->difference())) nearest = &place;
    }
    const double spread = std::abs(*farthest->difference() - *nearest->difference());
    if (places.size() > 1 && spread <= 1e-12 * nearest->sides->size) {
      problem.help(fmt::format("neither side changes with `{}`", trial.name(0)));
      return;
    }
    const auto* side = nearest->sides->left.as<Quantity>();
    const std::string apart = format_quantity(std::abs(*nearest->difference()), side->dimension, side->percent);
    const bool at_an_end = nearest == &places.front() || nearest == &places.back();
    problem.help(fmt::format("they come nearest at {}, {} apart{}", trial.shown({nearest->at}), apart,
                             at_an_end ? ": widen the range there" : ""));
  }

  // ------------------------------------------------------------------------------------------- several

  void solve_for_several(Trial& trial) {
    std::vector<Range> ranges;
    for (const SoughtValue& each : sought_) {
      ranges.push_back({each.low.as<Quantity>()->si, each.high.as<Quantity>()->si});
    }
    std::vector<double> scales;  // of the differences, from the first place that has values
    const Residuals residuals = [&](const std::vector<double>& at) -> std::optional<std::vector<double>> {
      if (session_.exhausted || enough_equations_ == false) return std::nullopt;
      const auto all = trial.look(at);
      if (!all) return std::nullopt;
      std::vector<double> scaled;
      for (const Sides& sides : *all) {
        for (const double difference : sides.differences) {
          if (scales.size() <= scaled.size()) scales.push_back(std::max(sides.size, smallest_scale));
          scaled.push_back(difference / scales[scaled.size()]);
        }
      }
      enough_equations_ = scaled.size() >= sought_.size();
      return scaled;
    };
    const std::optional<Fit> fit = least_squares(residuals, ranges, equal_enough);
    if (trial.hopeless()) return;
    if (enough_equations_ == false) return report_too_few();
    if (!fit) return trial.report_failure();
    const bool solved = std::all_of(fit->residuals.begin(), fit->residuals.end(),
                                    [](double residual) { return std::abs(residual) <= equal_enough; });
    if (solved) {
      found_ = fit->at;
    } else {
      report_no_fit(trial, fit->at);
    }
  }

  void report_too_few() {
    session_.report.add(
        Problem("E0116", fmt::format("{} unknowns need as many equations; a point counts as two", sought_.size()))
            .at(module_.at(written_)));
  }

  void report_no_fit(Trial& trial, const std::vector<double>& at) {
    Problem problem("E0115", sought_.size() == 1
                                 ? fmt::format("no `{}` within {} makes all sides equal", trial.name(0), range_shown())
                                 : "no values within these ranges make all sides equal");
    if (const auto all = trial.look(at)) {
      for (const Sides& sides : *all) {
        problem.at(module_.at(sides.written), fmt::format("at best {} = {}", format(sides.left), format(sides.right)));
      }
    }
    problem.help("they come nearest at " + trial.shown(at));
    session_.report.add(problem);
  }

  Session& session_;
  const Scope& scope_;
  const Module& module_;
  syntax::Solve written_;
  std::vector<SoughtValue> sought_;
  std::vector<double> found_;
  std::optional<bool> enough_equations_;
};

}  // namespace

void define_solve(Session& session, Scope& scope, const syntax::Solve& written) {
  define_solve(session, scope, scope, written);
}

void define_solve(Session& session, Scope& scope, const Scope& read_in, const syntax::Solve& written) {
  const auto solver = std::make_shared<Solver>(session, read_in, written);
  for (const syntax::Sought& sought : written.unknowns()) {
    const std::size_t i = solver->sought().size();
    Definition* made = define(session, scope, read_in.module(), sought.name(),
                              [solver, i] { return i == 0 ? solver->lead() : solver->follow(i); });
    solver->sought().push_back({sought, made, {}, {}});
  }
}

}  // namespace toile
