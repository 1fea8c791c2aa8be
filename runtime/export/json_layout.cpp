#include "runtime/export/json_layout.hpp"

#include <utility>
#include <vector>

namespace toile {

namespace {

constexpr std::size_t kWidth = 100;

class Layout {
 public:
  explicit Layout(std::string_view text) : text_(text), close_(text.size(), 0) { match_brackets(); }

  std::string run() {
    value(0, 0);
    out_ += '\n';
    return std::move(out_);
  }

 private:
  /// The position behind the string that starts at `at`.
  std::size_t behind_string(std::size_t at) const {
    for (++at; at < text_.size() && text_[at] != '"'; ++at) {
      if (text_[at] == '\\') ++at;
    }
    return at + 1;
  }

  void match_brackets() {
    std::vector<std::size_t> open;
    for (std::size_t at = 0; at < text_.size();) {
      const char c = text_[at];
      if (c == '"') {
        at = behind_string(at);
        continue;
      }
      if (c == '{' || c == '[') open.push_back(at);
      if ((c == '}' || c == ']') && !open.empty()) {
        close_[open.back()] = at;
        open.pop_back();
      }
      ++at;
    }
  }

  bool is_nest(std::size_t at) const { return text_[at] == '{' || text_[at] == '['; }

  std::size_t behind_value(std::size_t at) const {
    if (is_nest(at)) return close_[at] + 1;
    if (text_[at] == '"') return behind_string(at);
    const std::size_t end = text_.find_first_of(",]}", at);
    return end == std::string_view::npos ? text_.size() : end;
  }

  void on_one_line(std::size_t at, std::size_t end) {
    while (at < end) {
      const std::size_t next = text_[at] == '"' ? behind_string(at) : at + 1;
      out_ += text_.substr(at, next - at);
      if (text_[at] == ',' || text_[at] == ':') out_ += ' ';
      at = next;
    }
  }

  void new_line(std::size_t indent) {
    out_ += '\n';
    out_.append(indent, ' ');
    line_start_ = out_.size() - indent;
  }

  void value(std::size_t at, std::size_t indent) {
    const std::size_t end = behind_value(at);
    if (!is_nest(at) || indent + end - at <= kWidth) {
      on_one_line(at, end);
    } else {
      nest(at, indent);
    }
  }

  void nest(std::size_t at, std::size_t indent) {
    const char opening = text_[at];
    const std::size_t end = close_[at];
    const bool fill = opening == '[' && !is_nest(at + 1);
    out_ += opening;
    new_line(indent + 2);
    for (++at; at < end;) {
      if (opening == '{') {
        const std::size_t colon = behind_string(at);
        out_ += text_.substr(at, colon - at);
        out_ += ": ";
        at = colon + 1;
      }
      value(at, indent + 2);
      at = behind_value(at);
      if (at == end) break;
      out_ += ',';
      ++at;
      if (fill && out_.size() - line_start_ + behind_value(at) - at + 2 <= kWidth) {
        out_ += ' ';
      } else {
        new_line(indent + 2);
      }
    }
    new_line(indent);
    out_ += text_[end];
  }

  std::string_view text_;
  std::vector<std::size_t> close_;  // [position of an opening bracket]: that of its closing one
  std::string out_;
  std::size_t line_start_ = 0;
};

}  // namespace

std::string laid_out(std::string_view compact) {
  return compact.empty() ? "\n" : Layout(compact).run();
}

}  // namespace toile
