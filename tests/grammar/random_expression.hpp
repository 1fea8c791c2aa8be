// Expressions at random, with blanks, line ends and comments wherever they may stand. Words come from one source of
// chance and layout from another, so that one text can be had in many layouts.
#pragma once

#include <array>
#include <random>
#include <string>
#include <string_view>
#include <utility>

namespace toile::syntax {

class RandomExpression {
 public:
  RandomExpression(unsigned words, unsigned layout, bool comments)
      : words_(words), layout_(layout), comments_(comments) {}

 protected:
  // ---------------------------------------------------------------------------------------------------- layout

  int below(int n) { return static_cast<int>(words_() % static_cast<unsigned>(n)); }
  int layout_below(int n) { return static_cast<int>(layout_() % static_cast<unsigned>(n)); }

  void put(std::string_view token) { text_ += token; }
  /// Blanks, at least one where words would run together.
  void gap(int least = 1) {
    text_.append(
        static_cast<std::size_t>(least) + (layout_below(4) == 0 ? static_cast<std::size_t>(layout_below(3)) : 0), ' ');
  }
  void may_gap() { gap(brackets_ > 0 && layout_below(8) == 0 ? (line_end(), 0) : 0); }
  void line_end() {
    if (comments_ && layout_below(4) == 0) put(layout_below(2) == 0 ? "   // why " : " /// what\t");
    put(layout_below(20) == 0 ? "\r\n" : "\n");
    while (comments_ && layout_below(4) == 0) put(layout_below(3) == 0 ? "\n" : "  // a remark\n");
    gap(0);
  }
  /// Where a line may end within a statement.
  void more() {
    if (layout_below(6) == 0) {
      line_end();
    } else {
      gap(0);
    }
  }
  void word(std::string_view token) {
    put(token);
    gap();
  }
  void comma() {
    may_gap();
    put(",");
    more();
  }
  void open(char bracket) {
    put({&bracket, 1});
    ++brackets_;
    may_gap();
  }
  void close(char bracket) {
    may_gap();
    --brackets_;
    put({&bracket, 1});
  }
  template <typename Item>
  void block(int least, Item item) {
    put("{");
    line_end();
    const int outer = std::exchange(brackets_, 0);
    for (int n = least + below(4); n > 0; --n) {
      item();
      line_end();
    }
    brackets_ = outer;
    put("}");
  }

  // ----------------------------------------------------------------------------------------------- expressions

  void name() {
    static constexpr std::array<std::string_view, 14> names{"w",     "waist",        "length", "cut",   "label",
                                                            "fold",  "print",        "ease",   "start", "line",
                                                            "hem_2", "centre_front", "m",      "radius"};
    put(names[static_cast<std::size_t>(below(static_cast<int>(names.size())))]);
  }
  void number() {
    static constexpr std::array<std::string_view, 10> digits{"0",     "1",   "2.5", "60",    "1e-6",
                                                             "0.065", "300", "7",   "12.25", "3"};
    put(digits[static_cast<std::size_t>(below(10))]);
    static constexpr std::array<std::string_view, 8> units{"", "", "cm", "mm", "deg", "%", "gf*cm^2/cm", "N/m^3"};
    const std::string_view unit = units[static_cast<std::size_t>(below(8))];
    if (unit.empty()) return;
    gap(0);
    put(unit);
  }
  void list_of(int least, int most) {
    const int n = least + below(most - least + 1);
    for (int i = 0; i < n; ++i) {
      if (i > 0) comma();
      expression();
    }
  }
  void list() {
    open('[');
    expression();
    if (below(3) == 0) {
      put(" ");
      word("for");
      word("i");
      word("in");
      expression();
      may_gap();
      put("..");
      may_gap();
      expression();
      if (below(3) == 0) {
        put(" ");
        word("if");
        expression();
      }
    } else if (below(2) == 0) {
      comma();
      list_of(1, 4);
    }
    close(']');
  }
  void record() {
    open('(');
    for (int n = 1 + below(3); n > 0; --n) {
      name();
      put(":");
      more();
      expression();
      if (n > 1 || below(4) == 0) comma();
    }
    close(')');
  }
  void text() {
    put(R"("a text, \" and // no comment)");
    for (int n = below(3); n > 0; --n) {
      put(" {");
      gap(0);
      expression();
      if (below(2) == 0) put(" in mm");
      gap(0);
      put("}");
    }
    put("\"");
  }
  void primary() {
    switch (below(10)) {
      case 0:
      case 1:
        return number();
      case 2:
        open('(');
        list_of(1, 3);
        return close(')');
      case 3:
        return list();
      case 4:
        return put("#1f3a5f");
      case 5:
        return text();
      case 6:
        return record();
      default:
        return name();
    }
  }
  void postfix() {
    primary();
    for (int n = below(4) == 0 ? 1 + below(2) : 0; n > 0; --n) {
      gap(0);
      const int kind = below(3);
      if (kind == 0) {
        put(".");
        may_gap();
        name();
      } else if (kind == 1) {
        open('(');
        if (below(4) > 0) {
          if (below(2) == 0) {
            name();
            put(":");
            more();
          }
          list_of(1, 3);
          if (below(6) == 0) comma();
        }
        close(')');
      } else {
        open('[');
        expression();
        close(']');
      }
    }
  }
  void expression() {
    if (++depth_ > 4) {
      number();
    } else if (below(12) == 0) {
      word("if");
      expression();
      more();
      put(" ");
      word("then");
      more();
      expression();
      more();
      put(" ");
      word("else");
      more();
      expression();
    } else {
      chain();
    }
    --depth_;
  }
  void chain() {
    static constexpr std::array<std::string_view, 7> operators{"+", "-", "*", "/", "^", "+", "*"};
    if (below(8) == 0) put("-");
    postfix();
    for (int n = below(3) == 0 ? 1 + below(5) : 0; n > 0; --n) {
      put(" ");
      put(operators[static_cast<std::size_t>(below(7))]);
      put(" ");
      more();
      postfix();
    }
  }

  std::string text_;
  int brackets_ = 0;

 private:
  std::mt19937 words_, layout_;
  bool comments_;
  int depth_ = 0;
};

}  // namespace toile::syntax
