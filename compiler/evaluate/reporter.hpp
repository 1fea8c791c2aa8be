// Where the evaluator's diagnostics gather: each mistake once, in the order of the text.
#pragma once

#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/diag/diagnostic.hpp"

namespace toile {

/// A diagnostic as it is put together: Problem("E0201", "…").at(left, "a length").also(right, "an angle").
class Problem {
 public:
  Problem(std::string code, std::string message) {
    made_.severity = code.starts_with('W') ? Severity::Warning : Severity::Error;
    made_.code = std::move(code);
    made_.message = std::move(message);
  }
  Problem& at(Location where, std::string words = "") {
    made_.labels.push_back({where, std::move(words), true});
    return *this;
  }
  Problem& also(Location where, std::string words = "") {
    made_.labels.push_back({where, std::move(words), false});
    return *this;
  }
  Problem& help(std::string words) {
    made_.help = std::move(words);
    return *this;
  }
  const Diagnostic& diagnostic() const { return made_; }

 private:
  Diagnostic made_;
};

class Reporter {
 public:
  void add(const Problem& problem) { add(problem.diagnostic()); }
  /// The same code at the same place is reported once: bodies of functions are evaluated at every call. What touches
  /// text that was not understood is no mistake of its own: `2,5cm` is no plain number.
  void add(Diagnostic diagnostic);

  /// Warnings of this code within this stretch of text are meant to be.
  void allow(std::string code, Location stretch) { allowed_.emplace_back(std::move(code), stretch); }
  bool allows(const Diagnostic& diagnostic) const;

  /// Takes back what the parser said about this stretch of text, where more is known about it.
  void withdraw_syntax(Location stretch);

  /// While `place` is not null mistakes are put there instead: what goes wrong with a value that is only tried is no
  /// mistake of the script. Gives the place before.
  std::vector<Diagnostic>* set_aside(std::vector<Diagnostic>* place) { return std::exchange(aside_, place); }
  /// How many were put aside; and those from the `first` on reported after all.
  std::size_t put_aside() const { return aside_ == nullptr ? 0 : aside_->size(); }
  void release(std::size_t first);

  /// While a function's body is evaluated, mistakes in it show the call, too.
  void enter_call(Location call) { calls_.push_back(call); }
  void leave_call() { calls_.pop_back(); }

  /// Whether more would be left out: a text with so many mistakes is no script.
  bool full() const;
  bool has_errors() const { return errors_ > 0; }
  int errors() const { return errors_; }
  /// Sorted by file and place.
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  bool touches_a_slip(const Diagnostic& diagnostic) const;

  std::vector<Diagnostic> all_;
  std::set<std::tuple<std::string, FileId, std::uint32_t, std::uint32_t>> seen_;
  std::vector<std::pair<std::string, Location>> allowed_;
  std::vector<Location> calls_;
  std::vector<Diagnostic>* aside_ = nullptr;
  int errors_ = 0;
};

}  // namespace toile
