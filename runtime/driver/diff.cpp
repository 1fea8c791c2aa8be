#include "runtime/driver/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace toile {
namespace {

using Lines = std::vector<std::string_view>;

Lines split(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      lines.push_back(text);
      break;
    }
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

struct Step {
  char mark;  // ' ', '-' or '+'
  std::string_view line;
  std::size_t expected_line;  // from 0: where it stands, or would stand, in the expected text
};

/// A longest common subsequence by dynamic programming; the table is bounded by `most_cells`, beyond which everything
/// between the common ends counts as replaced.
std::vector<Step> middle_steps(const Lines& expected, const Lines& found, std::size_t offset) {
  constexpr std::size_t most_cells = 16'000'000;
  const std::size_t rows = expected.size();
  const std::size_t columns = found.size();
  std::vector<Step> steps;
  if ((rows + 1) * (columns + 1) > most_cells) {
    for (std::size_t i = 0; i < rows; ++i) steps.push_back({'-', expected[i], offset + i});
    for (const std::string_view line : found) steps.push_back({'+', line, offset + rows});
    return steps;
  }
  const std::size_t stride = columns + 1;
  std::vector<std::uint32_t> common((rows + 1) * stride, 0);  // [i][j]: of expected from i and found from j
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;) {
      common[i * stride + j] = expected[i] == found[j]
                                   ? common[(i + 1) * stride + j + 1] + 1
                                   : std::max(common[(i + 1) * stride + j], common[i * stride + j + 1]);
    }
  }
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < rows || j < columns) {
    if (i < rows && j < columns && expected[i] == found[j]) {
      steps.push_back({' ', expected[i], offset + i});
      ++i, ++j;
    } else if (j == columns || (i < rows && common[(i + 1) * stride + j] >= common[i * stride + j + 1])) {
      steps.push_back({'-', expected[i], offset + i});
      ++i;
    } else {
      steps.push_back({'+', found[j++], offset + i});
    }
  }
  return steps;
}

std::vector<Step> all_steps(const Lines& expected, const Lines& found) {
  const std::size_t shorter = std::min(expected.size(), found.size());
  std::size_t head = 0;
  while (head < shorter && expected[head] == found[head]) ++head;
  std::size_t tail = 0;
  while (tail < shorter - head && expected[expected.size() - 1 - tail] == found[found.size() - 1 - tail]) ++tail;
  std::vector<Step> steps;
  for (std::size_t i = 0; i < head; ++i) steps.push_back({' ', expected[i], i});
  const auto middle = [head, tail](const Lines& lines) {
    return Lines(lines.begin() + static_cast<std::ptrdiff_t>(head), lines.end() - static_cast<std::ptrdiff_t>(tail));
  };
  for (const Step& step : middle_steps(middle(expected), middle(found), head)) steps.push_back(step);
  for (std::size_t i = expected.size() - tail; i < expected.size(); ++i) steps.push_back({' ', expected[i], i});
  return steps;
}

}  // namespace

std::string line_diff(std::string_view expected, std::string_view found) {
  if (expected == found) return "";
  constexpr std::size_t context = 3;
  constexpr int most_shown = 60;
  const std::vector<Step> steps = all_steps(split(expected), split(found));
  std::string text;
  int shown = 0;
  std::size_t done = 0;  // steps before this one were shown or passed over
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].mark == ' ') continue;
    const std::size_t begin = std::max(done, i - std::min(i, context));
    if (begin > done || done == 0) text += fmt::format("@@ {} @@\n", steps[begin].expected_line + 1);
    std::size_t end = i + 1;
    for (std::size_t quiet = 0; end < steps.size() && quiet < context; ++end) {
      quiet = steps[end].mark == ' ' ? quiet + 1 : 0;
    }
    for (std::size_t k = begin; k < end; ++k) {
      if (++shown > most_shown) return text + "… and more\n";
      text += fmt::format("{}{}\n", steps[k].mark, steps[k].line);
    }
    done = end;
    i = end - 1;
  }
  return text.empty() ? "only the ends of the last lines differ\n" : text;
}

}  // namespace toile
