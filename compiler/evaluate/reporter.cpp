#include "compiler/evaluate/reporter.hpp"

#include <algorithm>

namespace toile {
namespace {

constexpr std::size_t most_diagnostics = 200;

Location place(const Diagnostic& diagnostic) {
  for (const Label& label : diagnostic.labels) {
    if (label.primary) return label.at;
  }
  return diagnostic.labels.empty() ? Location{} : diagnostic.labels.front().at;
}

bool before(const Diagnostic& a, const Diagnostic& b) {
  const Location left = place(a);
  const Location right = place(b);
  return std::tie(left.file, left.span.begin, left.span.end, a.code) <
         std::tie(right.file, right.span.begin, right.span.end, b.code);
}

}  // namespace

bool Reporter::full() const {
  return all_.size() >= most_diagnostics;
}

bool Reporter::allows(const Diagnostic& diagnostic) const {
  const Location at = place(diagnostic);
  return std::ranges::any_of(allowed_, [&](const auto& each) {
    const auto& [code, stretch] = each;
    return code == diagnostic.code && stretch.file == at.file && stretch.span.begin <= at.span.begin &&
           at.span.end <= stretch.span.end;
  });
}

void Reporter::release(std::size_t first) {
  if (aside_ == nullptr) return;
  std::vector<Diagnostic> released(aside_->begin() + static_cast<std::ptrdiff_t>(first), aside_->end());
  aside_->resize(first);
  std::vector<Diagnostic>* const place = set_aside(nullptr);
  for (Diagnostic& diagnostic : released) add(std::move(diagnostic));
  set_aside(place);
}

void Reporter::withdraw_syntax(Location stretch) {
  const auto withdrawn = [&](const Diagnostic& each) {
    const Location at = place(each);
    return each.code == "E0001" && at.file == stretch.file && at.span.begin >= stretch.span.begin &&
           at.span.begin <= stretch.span.end;
  };
  errors_ -= static_cast<int>(std::erase_if(all_, withdrawn));
}

bool Reporter::touches_a_slip(const Diagnostic& diagnostic) const {
  constexpr std::uint32_t beside = 1;  // a comma between the two
  const auto is_slip = [](const Diagnostic& each) { return each.code.starts_with("E00"); };
  if (is_slip(diagnostic)) return false;
  // Either side of a sum may be what was not understood.
  return std::ranges::any_of(diagnostic.labels, [&](const Label& label) {
    const Location own = label.at;
    return label.primary && std::ranges::any_of(all_, [&](const Diagnostic& each) {
             const Location at = place(each);
             return is_slip(each) && at.file == own.file && at.span.begin <= own.span.end + beside &&
                    own.span.begin <= at.span.end && own.span.end <= at.span.begin + beside;
           });
  });
}

void Reporter::add(Diagnostic diagnostic) {
  if (aside_ != nullptr) {
    aside_->push_back(std::move(diagnostic));
    return;
  }
  if (diagnostic.severity == Severity::Warning && allows(diagnostic)) return;
  const Location where = place(diagnostic);
  const bool is_new = seen_.emplace(diagnostic.code, where.file, where.span.begin, where.span.end).second;
  if (!is_new || full() || touches_a_slip(diagnostic)) return;
  if (!calls_.empty() && !(calls_.front() == where))
    diagnostic.labels.push_back({calls_.front(), "in this call", false});
  if (diagnostic.severity == Severity::Error) ++errors_;
  all_.insert(std::upper_bound(all_.begin(), all_.end(), diagnostic, before), std::move(diagnostic));
}

}  // namespace toile
