// Scripts that parse, at random, with every construct of the language.
#pragma once

#include <string>
#include <utility>

#include "tests/grammar/random_expression.hpp"

namespace toile::syntax {

class RandomScript : private RandomExpression {
 public:
  using RandomExpression::RandomExpression;

  std::string make() {
    line_end();
    for (int n = 1 + below(6); n > 0; --n) file_item();
    return std::move(text_);
  }

 private:
  void assign() {
    gap(0);
    put("=");
    more();
  }
  void let() {
    word("let");
    name();
    assign();
    expression();
  }
  void properties() {
    put("{");
    gap(0);
    for (int n = below(4); n > 0; --n) {
      word(below(2) == 0 ? "girth" : "depth");
      expression();
      if (below(2) == 0) {
        gap(0);
        put(",");
        more();
      } else {
        line_end();
      }
    }
    put(" }");
  }
  void edge() {
    name();
    assign();
    switch (below(5)) {
      case 0:
        word("line");
        word("to");
        return put("start");
      case 1:
        word("curve");
        word("to");
        expression();
        put(" ");
        word("leaving");
        expression();
        return;
      case 2:
        word("arc");
        word("to");
        expression();
        put(" ");
        word("radius");
        expression();
        return put(" large");
      case 3:
        word("bezier");
        word("to");
        expression();
        put(" ");
        word("via");
        expression();
        comma();
        return expression();
      default:
        word("along");
        return expression();
    }
  }
  void position() {
    word("at");
    expression();
    put(" ");
    word("of");
    name();
  }
  void repeat() {
    word("for");
    name();
    put(" in 1..");
    expression();
    if (below(2) == 0) {
      put(" if ");
      expression();
    }
    put(" ");
    block(0, [this] {
      word("notch");
      position();
    });
  }
  void words_and_properties() {
    put("{ ");
    constexpr const char* lone[] = {"trued", "tried", "pressed left", "box", "inverted", "pressed open", "knife"};
    put(lone[below(6)]);
    comma();
    put("depth ");
    expression();
    put(" }");
  }
  void fullness() {
    switch (below(5)) {
      case 0:
        word("pivot");
        if (below(2) == 0) put("50% of ");
        put("bust to 40% of side");
        return put(below(2) == 0 ? " as side_dart" : "");
      case 1:
        word("spread");
        expression();
        put(" ");
        position();
        if (below(2) == 0) return put(" to 40% of waist");
        comma();
        return put("1cm at 40% of eye.rim");
      case 2:
        word("pleat");
        if (below(2) == 0) word("tuck");
        position();
        if (below(2) == 0) put(" to 40% of hem");
        put(" ");
        return words_and_properties();
      case 3:
        put("dart waist from (1cm, 2cm) to ");
        expression();
        put(" ");
        return words_and_properties();
      default:
        word(below(2) == 0 ? "mark" : "drill at");
        return expression();
    }
  }
  void detail() {
    if (below(4) == 0) return fullness();
    switch (below(9)) {
      case 0:
        word(below(3) > 0 ? "outline" : below(2) == 0 ? "hole eye" : "line place");
        word("from");
        expression();
        put(" ");
        return block(1, [this] { edge(); });
      case 1:
        word("fold");
        return name();
      case 2:
        word("dart");
        position();
        put(" ");
        return properties();
      case 3:
        word("notch");
        if (below(3) == 0) word("half");
        return position();
      case 4:
        word("allowance");
        expression();
        if (below(2) == 0) put(" square");
        comma();
        put("hem ");
        expression();
        return put(below(2) == 0 ? " mirrored" : "");
      case 5:
        return put("...");
      case 6:
        return put("grain down");
      case 7:
        return repeat();
      default:
        return let();
    }
  }
  void chain_of_edges() {
    for (int n = 1 + below(6);; --n) {
      name();
      if (below(4) == 0) put("[i + 1]");
      put(".");
      name();
      if (below(4) == 0) put("[2]");
      if (below(4) == 0) put(" in 0cm..18cm");
      if (n == 1) return;
      put(" +");
      more();
    }
  }
  void garment_item() {
    switch (below(6)) {
      case 4:
        put("for i in 1..4 if i > 2 ");
        return block(0, [this] { garment_item(); });
      case 5:
        return put(below(2) == 0 ? "allow W0337" : "allow W0337, W0338");
      case 0:
        word("sew");
        chain_of_edges();
        put(" ");
        word("to");
        chain_of_edges();
        if (below(4) == 0) put(" to flap.edge");
        if (below(4) == 0) put(" notch at 1cm, 50%");
        if (below(4) == 0) put(" gather 2cm in 1cm..9cm");
        if (below(4) == 0) put(" zipped open step 3");
        if (below(4) == 0) put(" folded -90deg");
        return put(below(2) == 0 ? " reversed" : " ease 3mm");
      case 1:
        word("wear");
        chain_of_edges();
        put(" ");
        word("at");
        expression();
        return;
      case 2:
        word("piece");
        name();
        put(below(2) == 0 ? " = front with " : " ");
        return block(0, [this] { detail(); });
      default:
        return let();
    }
  }
  void row() {
    word(below(2) == 0 ? "2HG5" : "source");
    expression();
    for (int n = below(12); n > 0; --n) {
      comma();
      expression();
    }
  }
  void sizes() {
    word("sizes");
    name();
    parameters();
    put(below(2) == 0 ? " " : " at 38 ");
    block(0, [this] {
      word(below(2) == 0 ? "38" : "M");
      list_of(1, 6);
    });
  }
  void body_part() {
    word(below(2) == 0 ? "section" : "limb");
    if (below(2) == 0) word("waist");
    if (below(2) == 0) {
      word("at");
      expression();
      put(" ");
    }
    properties();
  }
  void parameters() {
    open('(');
    for (int n = below(5); n > 0; --n) {
      name();
      if (below(2) == 0) {
        assign();
        expression();
      }
      if (n > 1 || below(4) == 0) comma();
    }
    close(')');
  }
  void solve() {
    word("solve");
    name();
    put(" in 1cm..2cm");
    if (below(2) == 0) {
      comma();
      put("other in 1cm..");
      expression();
    }
    if (layout_below(4) == 0) line_end();
    put(" ");
    word("so");
    more();
    expression();
    assign();
    expression();
  }
  void file_item() {
    switch (below(12)) {
      case 0:
        put("import bodies as b");
        break;
      case 1:
        word("param");
        name();
        assign();
        number();
        put(" in ");
        number();
        put("..");
        number();
        break;
      case 2:
        word("fn");
        name();
        parameters();
        assign();
        expression();
        break;
      case 3:
        word("fabric");
        word("serge");
        block(1, [this] { row(); });
        break;
      case 4:
        word("body");
        put("form");
        parameters();
        put(" ");
        block(0, [this] { body_part(); });
        break;
      case 5:
      case 6:
        word("garment");
        put("skirt");
        if (below(2) == 0) parameters();
        put(" ");
        block(0, [this] { garment_item(); });
        break;
      case 9:
        solve();
        break;
      case 10:
        sizes();
        break;
      case 7:
        put("drape skirt on form as worn");
        break;
      case 8:
        word("print");
        list_of(1, 8);
        break;
      default:
        let();
        break;
    }
    line_end();
  }
};

}  // namespace toile::syntax
