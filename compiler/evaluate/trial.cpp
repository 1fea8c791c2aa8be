#include "compiler/evaluate/trial.hpp"

#include <algorithm>
#include <cmath>

#include "compiler/evaluate/expression.hpp"

namespace toile {
namespace {

/// Puts mistakes aside for as long as it lives.
class Aside {
 public:
  Aside(Reporter& report, std::vector<Diagnostic>& place) : report_(report), before_(report.set_aside(&place)) {}
  ~Aside() { report_.set_aside(before_); }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

 private:
  Reporter& report_;
  std::vector<Diagnostic>* before_;
};

/// Lets the unknowns stand for values, and makes all stale that depended on those before.
class Trying {
 public:
  Trying(Session& session, std::vector<SoughtValue>& sought, const std::vector<Value>& values, std::size_t depth)
      : session_(session), sought_(sought) {
    ++session_.tries;
    for (std::size_t i = 0; i < sought.size(); ++i) sought[i].definition->tried = Definition::Tried{values[i], depth};
  }
  ~Trying() {
    ++session_.tries;
    for (SoughtValue& each : sought_) each.definition->tried.reset();
  }
  Trying(const Trying&) = delete;
  Trying& operator=(const Trying&) = delete;

 private:
  Session& session_;
  std::vector<SoughtValue>& sought_;
};

}  // namespace

Trial::Trial(Session& session, const Scope& scope, const syntax::Solve& written, std::vector<SoughtValue>& sought)
    : session_(session), scope_(scope), written_(written), sought_(sought) {}

Value Trial::value(std::size_t i, double si) const {
  Quantity quantity = *sought_[i].low.as<Quantity>();
  quantity.si = si;
  return quantity;
}

std::string Trial::name(std::size_t i) const {
  return session_.name_of(scope_.module(), sought_[i].written.name());
}

std::string Trial::shown(const std::vector<double>& at) const {
  std::string text;
  for (std::size_t i = 0; i < at.size(); ++i) {
    text += (i == 0 ? "" : ", ") + name(i) + " = " + format(value(i, at[i]));
  }
  return text;
}

std::optional<std::vector<Sides>> Trial::look_openly(const std::vector<double>& at) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < at.size(); ++i) values.push_back(value(i, at[i]));
  return evaluate_all(values, session_.running.size() - 1);
}

std::optional<std::vector<Sides>> Trial::look(const std::vector<double>& at) {
  std::vector<Diagnostic> found;
  std::optional<std::vector<Sides>> sides;
  {
    const Aside aside(session_.report, found);
    sides = look_openly(at);
  }
  if (!sides && first_failure_.empty()) {
    first_failure_ = std::move(found);
    failed_at_ = at;
  }
  return sides;
}

bool Trial::suppose() {
  std::vector<Value> values;
  for (const SoughtValue& each : sought_) values.push_back(forget(each.low));
  (void)evaluate_all(values, session_.running.size());
  if (misfit_) session_.report.add(*misfit_);
  return !misfit_;
}

std::optional<std::vector<Sides>> Trial::evaluate_all(const std::vector<Value>& values, std::size_t depth) {
  const Trying trying(session_, sought_, values, depth);
  std::vector<Sides> all;
  bool sound = true;
  for (const syntax::Equation& equation : written_.equations()) {
    Sides sides{
        equation, evaluate(session_, scope_, equation.left()), evaluate(session_, scope_, equation.right()), {}, 0};
    sound = compare(sides) && sound;
    all.push_back(std::move(sides));
  }
  return sound ? std::optional(all) : std::nullopt;
}

bool Trial::compare(Sides& sides) {
  if (sides.left.unknown() || sides.right.unknown()) return false;
  const Location left_at = scope_.module().at(*sides.written.left());
  const Location right_at = scope_.module().at(*sides.written.right());
  const auto* a = sides.left.as<Quantity>();
  const auto* b = sides.right.as<Quantity>();
  const auto* p = sides.left.as<Point>();
  const auto* q = sides.right.as<Point>();
  const bool fits = (a != nullptr && b != nullptr && a->dimension == b->dimension) ||
                    (p != nullptr && q != nullptr && p->dimension == q->dimension);
  if (!fits) {
    misfit_ = Problem("E0201", describe(sides.left) + " and " + describe(sides.right) + " can never be equal")
                  .at(left_at, describe(sides.left))
                  .at(right_at, describe(sides.right));
    return false;
  }
  if (!sides.left.known() || !sides.right.known()) {
    if (session_.supposing > 0) return false;
    misfit_ = Problem("E0506", "an equation cannot depend on a drape's result: patterns are drawn before")
                  .at(sides.left.known() ? right_at : left_at);
    return false;
  }
  if (a != nullptr) {
    sides.differences = {a->si - b->si};
    sides.size = std::max(std::abs(a->si), std::abs(b->si));
  } else {
    sides.differences = {p->at.x - q->at.x, p->at.y - q->at.y};
    sides.size = std::max(norm(p->at), norm(q->at));
  }
  return true;
}

bool Trial::hopeless() {
  if (session_.exhausted) {
    report_failure();
    return true;
  }
  if (!misfit_) return false;
  session_.report.add(*misfit_);
  return true;
}

void Trial::report_failure() {
  for (Diagnostic& diagnostic : first_failure_) {
    // Names and kinds are wrong whatever is tried.
    const bool depends_on_values = diagnostic.code >= "E0206" && diagnostic.code < "E0300";
    if (!failed_at_.empty() && depends_on_values) {
      diagnostic.labels.push_back({scope_.module().at(written_), "while trying " + shown(failed_at_), false});
    }
    session_.report.add(std::move(diagnostic));
  }
  first_failure_.clear();
}

}  // namespace toile
