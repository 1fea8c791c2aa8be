// "Did you mean …": the known name nearest to one that was mistyped.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// Edits (insert, delete, replace, swap neighbours) that turn one word into the other, regardless of case.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `name`, if any is near enough to be meant: within a third of the longer word's letters, at
/// least one edit. The first of equals wins.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates);

/// "did you mean `waist`?", or "known are `a`, `b` and `c`" when nothing is near and the list is short, or "".
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace toile
