#include "grammar/format/columns.hpp"

#include <algorithm>
#include <span>

namespace toile::syntax {
namespace {

constexpr int comment_gap = 4;
// Columns that would tear a line apart further than this are left alone.
constexpr int widest_gap = 16;
constexpr int widest_comment_gap = 48;

bool is_remark(const TextLine& line) {
  return line.text.empty();
}

/// Calls `found` for each longest run of lines, at least two of them, in which each continues the one before. Comments
/// in lines of their own are passed over.
template <typename Continues, typename Found>
void for_each_run(std::vector<TextLine>& lines, Continues continues, Found found) {
  std::vector<TextLine*> run;
  const auto close = [&] {
    if (run.size() > 1) found(std::span<TextLine*>(run));
    run.clear();
  };
  for (TextLine& line : lines) {
    if (is_remark(line) && !line.blank_before && !run.empty() && run.back()->indentation == line.indentation) continue;
    if (run.empty() || line.blank_before || !continues(*run.back(), line)) close();
    if (!is_remark(line)) run.push_back(&line);
  }
  close();
}

/// Where the text before a column ends, without the blanks.
int used(const TextLine& line, std::size_t column) {
  const std::string_view before = std::string_view(line.text).substr(0, line.stops[column]);
  return width(before.substr(0, before.find_last_not_of(' ') + 1));
}

void set_column(std::span<TextLine*> run, std::size_t column) {
  const auto at = [column](const TextLine* line) { return width(line->text.substr(0, line->stops[column])); };
  int widest = 0, narrowest = page_width;
  for (const TextLine* line : run) {
    widest = std::max(widest, used(*line, column) + 1);
    narrowest = std::min(narrowest, used(*line, column) + 1);
  }
  const bool fits = std::ranges::all_of(run, [&](const TextLine* line) {
    return line->indentation + width(line->text) + widest - at(line) <= page_width;
  });
  if (!fits || widest - narrowest > widest_gap) return;
  for (TextLine* line : run) {
    const auto blanks = static_cast<std::size_t>(widest - at(line));
    line->text.insert(line->stops[column], blanks, ' ');
    for (std::size_t i = column; i < line->stops.size(); ++i) line->stops[i] += blanks;
  }
}

void set_columns(std::vector<TextLine>& lines) {
  std::size_t most = 0;
  for (const TextLine& line : lines) most = std::max(most, line.stops.size());
  for (std::size_t column = 0; column < most; ++column) {
    const auto has_column = [column](const TextLine& line) { return line.stops.size() > column; };
    for_each_run(
        lines,
        [&](const TextLine& above, const TextLine& line) {
          return above.table == line.table && above.indentation == line.indentation && has_column(above) &&
                 has_column(line);
        },
        [&](std::span<TextLine*> run) { set_column(run, column); });
  }
}

void set_comments(std::vector<TextLine>& lines) {
  for_each_run(
      lines, [](const TextLine& above, const TextLine& line) { return above.indentation == line.indentation; },
      [](std::span<TextLine*> run) {
        int widest = 0, narrowest = 0;
        for (const TextLine* line : run) {
          if (line->comment.empty()) continue;
          widest = std::max(widest, width(line->text));
          narrowest = narrowest == 0 ? width(line->text) : std::min(narrowest, width(line->text));
        }
        if (widest - narrowest > widest_comment_gap) return;
        for (TextLine* line : run) {
          if (line->comment.empty()) continue;
          line->text.append(static_cast<std::size_t>(widest - width(line->text)), ' ');
        }
      });
}

}  // namespace

std::string set_in_columns(std::vector<TextLine> lines) {
  set_columns(lines);
  set_comments(lines);
  std::string text;
  for (const TextLine& line : lines) {
    if (line.blank_before) text += '\n';
    text.append(static_cast<std::size_t>(line.indentation), ' ');
    text += line.text;
    if (!line.text.empty() && !line.comment.empty()) text.append(comment_gap, ' ');
    text += line.comment;
    text += '\n';
  }
  return text;
}

}  // namespace toile::syntax
