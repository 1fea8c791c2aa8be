// Diagnostics as text for people: the first line says where and what, the excerpt points at every place concerned.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "compiler/diag/diagnostic.hpp"

namespace toile {
namespace {

constexpr std::string_view red = "\x1b[1;31m";
constexpr std::string_view yellow = "\x1b[1;33m";
constexpr std::string_view blue = "\x1b[1;34m";
constexpr std::string_view bold = "\x1b[1m";
constexpr std::string_view plain = "\x1b[0m";
constexpr int tab_width = 4;

class Paint {
 public:
  explicit Paint(bool on) : on_(on) {}
  std::string operator()(std::string_view colour, std::string_view text) const {
    if (!on_ || text.empty()) return std::string(text);
    return std::string(colour) + std::string(text) + std::string(plain);
  }

 private:
  bool on_;
};

bool starts_code_point(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

/// Where the byte `offset` of a line stands on the screen once tabs are widened.
int screen_column(std::string_view line, std::size_t offset) {
  int column = 0;
  for (std::size_t i = 0; i < std::min(offset, line.size()); ++i) {
    if (line[i] == '\t') {
      column += tab_width;
    } else if (starts_code_point(line[i])) {
      ++column;
    }
  }
  return column;
}

std::string widen_tabs(std::string_view line) {
  std::string text;
  for (const char c : line) {
    if (c == '\t') {
      text.append(tab_width, ' ');
    } else if (static_cast<unsigned char>(c) >= 0x20) {
      text += c;
    } else {
      text += ' ';
    }
  }
  return text;
}

/// A label's underline within one line of the text.
struct Underline {
  int begin = 0;  // screen columns from 0, half open
  int end = 0;
  bool primary = false;
  std::string_view text;
};

/// The lines of one file that carry labels.
using Excerpt = std::map<int, std::vector<Underline>>;

void add_underline(Excerpt& excerpt, const Source& source, const Label& label) {
  const auto size = static_cast<std::uint32_t>(source.text().size());
  const std::uint32_t begin = std::min(label.at.span.begin, size);
  const std::uint32_t end = std::clamp(label.at.span.end, begin, size);
  const int number = source.position(begin).line;
  const std::string_view line = source.line(number);
  const auto line_begin = static_cast<std::uint32_t>(line.data() - source.text().data());
  // A span over several lines is shown by its first one.
  const int from = screen_column(line, begin - line_begin);
  const int to = screen_column(line, std::min<std::size_t>(end - line_begin, line.size()));
  excerpt[number].push_back({from, std::max(to, from + 1), label.primary, label.text});
}

class ExcerptPrinter {
 public:
  ExcerptPrinter(std::string& out, int gutter, Paint paint, std::string_view main_colour)
      : out_(out), gutter_(gutter), paint_(paint), main_colour_(main_colour) {}

  void print(const Source& source, const Excerpt& excerpt) {
    int previous = 0;
    for (const auto& [number, underlines] : excerpt) {
      if (previous != 0 && number > previous + 1) out_ += paint_(blue, "...") + "\n";
      line(std::to_string(number), widen_tabs(source.line(number)));
      print_underlines(underlines);
      previous = number;
    }
  }

  void blank() { line("", ""); }

 private:
  void line(const std::string& number, const std::string& text) {
    const auto width = static_cast<std::size_t>(gutter_);
    out_ += paint_(blue, std::string(width - number.size(), ' ') + number + " |");
    if (!text.empty()) out_ += " " + text;
    out_ += "\n";
  }

  std::string_view colour_of(const Underline& underline) const { return underline.primary ? main_colour_ : blue; }

  /// The row of carets with the words of the rightmost label behind it; below, one row for the words of each other
  /// label, right to left, hung on bars under their carets.
  void print_underlines(std::vector<Underline> all) {
    std::stable_sort(all.begin(), all.end(), [](const Underline& a, const Underline& b) {
      return std::tuple(a.begin, -a.end) < std::tuple(b.begin, -b.end);
    });
    const std::vector<const Underline*> columns = painted(all);
    const Underline& last = all.back();
    const bool beside = static_cast<int>(columns.size()) == last.end && !last.text.empty();
    line("", row_of_carets(columns) + (beside ? " " + paint_(colour_of(last), last.text) : ""));
    if (beside) all.pop_back();
    std::erase_if(all, [](const Underline& underline) { return underline.text.empty(); });
    while (!all.empty()) {
      line("", hanging(all, ""));
      line("", hanging({all.begin(), all.end() - 1}, all.back().text, &all.back()));
      all.pop_back();
    }
  }

  /// Which underline is seen in each column: where they overlap the shorter one lies above, of equals
  /// the primary one.
  static std::vector<const Underline*> painted(const std::vector<Underline>& all) {
    std::vector<const Underline*> columns;
    for (const Underline& underline : all) {
      if (static_cast<int>(columns.size()) < underline.end) columns.resize(static_cast<std::size_t>(underline.end));
      for (int column = underline.begin; column < underline.end; ++column) {
        const Underline*& seen = columns[static_cast<std::size_t>(column)];
        const auto rank = [](const Underline& u) { return std::tuple(u.end - u.begin, u.primary ? 0 : 1); };
        if (seen == nullptr || rank(underline) < rank(*seen)) seen = &underline;
      }
    }
    return columns;
  }

  std::string row_of_carets(const std::vector<const Underline*>& columns) const {
    std::string row;
    for (std::size_t begin = 0; begin < columns.size();) {
      std::size_t end = begin;
      while (end < columns.size() && columns[end] == columns[begin]) ++end;
      const Underline* underline = columns[begin];
      const char mark = underline == nullptr ? ' ' : underline->primary ? '^' : '-';
      const std::string marks(end - begin, mark);
      row += underline == nullptr ? marks : paint_(colour_of(*underline), marks);
      begin = end;
    }
    return row;
  }

  std::string hanging(const std::vector<Underline>& bars, std::string_view words, const Underline* owner = nullptr) {
    std::string row;
    int column = 0;
    for (const Underline& bar : bars) {
      if (bar.begin < column) continue;
      row += std::string(static_cast<std::size_t>(bar.begin - column), ' ') + paint_(colour_of(bar), "|");
      column = bar.begin + 1;
    }
    if (owner == nullptr) return row;
    row += std::string(static_cast<std::size_t>(std::max(0, owner->begin - column)), ' ');
    return row + paint_(colour_of(*owner), words);
  }

  std::string& out_;
  int gutter_;
  Paint paint_;
  std::string_view main_colour_;
};

const Label* main_label(const Diagnostic& diagnostic) {
  for (const Label& label : diagnostic.labels) {
    if (label.primary) return &label;
  }
  return diagnostic.labels.empty() ? nullptr : &diagnostic.labels.front();
}

std::string place(const Sources& sources, Location at) {
  const Source& source = sources[at.file];
  const LineColumn where = source.position(std::min(at.span.begin, static_cast<std::uint32_t>(source.text().size())));
  return source.name() + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

std::string_view word(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      break;
  }
  return "note";
}

}  // namespace

std::string render(const Diagnostic& diagnostic, const Sources& sources, bool colour) {
  const Paint paint(colour);
  const std::string_view main_colour = diagnostic.severity == Severity::Error     ? red
                                       : diagnostic.severity == Severity::Warning ? yellow
                                                                                  : blue;
  const Label* main = main_label(diagnostic);
  std::string out;
  if (main != nullptr) out += paint(bold, place(sources, main->at) + ":") + " ";
  std::string kind(word(diagnostic.severity));
  if (!diagnostic.code.empty()) kind += "[" + diagnostic.code + "]";
  out += paint(main_colour, kind) + ": " + paint(bold, diagnostic.message) + "\n";

  if (main != nullptr) {
    std::map<FileId, Excerpt> excerpts;
    std::size_t widest = 1;
    for (const Label& label : diagnostic.labels) {
      add_underline(excerpts[label.at.file], sources[label.at.file], label);
      widest = std::max(widest, std::to_string(excerpts[label.at.file].rbegin()->first).size());
    }
    ExcerptPrinter printer(out, static_cast<int>(widest), paint, main_colour);
    printer.blank();
    printer.print(sources[main->at.file], excerpts[main->at.file]);
    for (const auto& [file, excerpt] : excerpts) {
      if (file == main->at.file) continue;
      out += paint(blue, std::string(widest, ' ') + "--> ") + sources[file].name() + ":" +
             std::to_string(excerpt.begin()->first) + "\n";
      printer.print(sources[file], excerpt);
    }
  }
  if (!diagnostic.help.empty()) out += paint(bold, "help") + ": " + diagnostic.help + "\n";
  return out;
}

}  // namespace toile
