// The equations of a `solve` at values that are only tried.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/evaluate/session.hpp"

namespace toile {

struct SoughtValue {
  syntax::Sought written;
  Definition* definition = nullptr;  // null when the name was taken
  Value low, high;                   // its range, once that is read
};

/// An equation with what its sides came to.
struct Sides {
  syntax::Equation written;
  Value left, right;
  std::vector<double> differences;  // left - right: one number, or two for points [SI]
  double size = 0;                  // the larger of both sides
};

class Trial {
 public:
  Trial(Session& session, const Scope& scope, const syntax::Solve& written, std::vector<SoughtValue>& sought);

  /// Both sides of all equations; nothing when one has no value. Mistakes on the way are put aside.
  std::optional<std::vector<Sides>> look(const std::vector<double>& at);
  /// The same, with its mistakes reported.
  std::optional<std::vector<Sides>> look_openly(const std::vector<double>& at);
  /// What the equations are about, checked without magnitudes; false after an error.
  bool suppose();

  /// Whether going on is of no use; the reason is reported.
  bool hopeless();
  /// When no value could be tried: reports what was wrong with the first.
  void report_failure();

  /// An unknown's value, as it is shown and used.
  Value value(std::size_t i, double si) const;
  std::string name(std::size_t i) const;
  /// "h = 8 cm, w = 3 cm"
  std::string shown(const std::vector<double>& at) const;

 private:
  std::optional<std::vector<Sides>> evaluate_all(const std::vector<Value>& values, std::size_t depth);
  bool compare(Sides& sides);

  Session& session_;
  const Scope& scope_;
  const syntax::Solve& written_;
  std::vector<SoughtValue>& sought_;
  std::vector<Diagnostic> first_failure_;
  std::vector<double> failed_at_;
  std::optional<Problem> misfit_;  // the sides can never be equal
};

}  // namespace toile
