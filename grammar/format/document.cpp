#include "grammar/format/document.hpp"

#include <algorithm>
#include <utility>

namespace toile::syntax {
namespace {

Doc leaf(Doc::Type type, std::string_view words = {}) {
  Doc doc;
  doc.type = type;
  doc.text = words;
  return doc;
}

Doc inner(Doc::Type type, std::vector<Doc> parts) {
  Doc doc;
  doc.type = type;
  doc.parts = std::move(parts);
  doc.breaks = std::ranges::any_of(doc.parts, [](const Doc& part) {
    return part.breaks || part.type == Doc::Type::NewLine || part.type == Doc::Type::Comment;
  });
  return doc;
}

/// A part of the document still to be printed. In a flat one no break is a new line.
struct Pending {
  const Doc* doc;
  int indentation;
  bool flat;
};

class Printer {
 public:
  std::vector<TextLine> print(const Doc& document) {
    pending_.push_back({&document, 0, false});
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      step(next);
    }
    if (line().text.empty() && line().comment.empty()) lines_.pop_back();
    return std::move(lines_);
  }

 private:
  void step(const Pending& at) {
    const Doc& doc = *at.doc;
    switch (doc.type) {
      case Doc::Type::Text:
        return write(doc.text, at.indentation);
      case Doc::Type::Space:
        return write_blank(" ");
      case Doc::Type::Break:
        return at.flat ? write_blank(doc.text) : begin_line(at.indentation);
      case Doc::Type::NewLine:
        return begin_line(at.indentation);
      case Doc::Type::Blank:
        if (lines_.size() > 1) line().blank_before = true;
        return;
      case Doc::Type::Concat:
        return push(doc, at.indentation, at.flat);
      case Doc::Type::Group:
        return push(doc, at.indentation, at.flat || (!doc.breaks && fits(doc)));
      case Doc::Type::Flat:
        return push(doc, at.indentation, true);
      case Doc::Type::Indent:
        return push(doc, at.indentation + doc.amount, at.flat);
      case Doc::Type::Comment:
        line().comment = doc.text;
        return;
      case Doc::Type::RowBegin:
        return begin_row(doc.table);
      case Doc::Type::RowEnd:
        return end_row();
      case Doc::Type::Stop:
        if (!rows_.empty() && rows_.back() == lines_.size()) line().stops.push_back(line().text.size());
        return;
    }
  }

  void push(const Doc& doc, int indentation, bool flat) {
    for (std::size_t i = doc.parts.size(); i-- > 0;) pending_.push_back({&doc.parts[i], indentation, flat});
  }

  TextLine& line() { return lines_.back(); }
  bool at_beginning() { return line().text.empty(); }

  void begin_line(int indentation) {
    while (!at_beginning() && line().text.back() == ' ') line().text.pop_back();
    if (!at_beginning() || !line().comment.empty()) lines_.emplace_back();
    line().indentation = indentation;
  }

  void write(std::string_view words, int indentation) {
    if (!line().comment.empty()) begin_line(indentation);
    line().text += words;
  }

  void write_blank(std::string_view blank) {
    if (!at_beginning() && line().comment.empty()) line().text += blank;
  }

  // A row that does not begin its line is part of another one; 0 stands for it among the numbers of lines.
  void begin_row(Table kind) {
    const bool begins_line = at_beginning() && line().comment.empty();
    rows_.push_back(begins_line ? lines_.size() : 0);
    if (!begins_line) return;
    line().table = kind;
    line().is_row = true;
  }

  void end_row() {
    const std::size_t begun = rows_.back();
    rows_.pop_back();
    if (begun == 0 || begun == lines_.size()) return;
    TextLine& first = lines_[begun - 1];
    first.table = Table::None;
    first.is_row = false;
    first.stops.clear();
  }

  /// Whether a group fits into the rest of the line, with what follows it up to the next place to break.
  bool fits(const Doc& group) const {
    int left = page_width - lines_.back().indentation - width(lines_.back().text);
    std::vector<std::pair<const Doc*, bool>> ahead{{&group, true}};
    std::size_t behind = pending_.size();
    while (left >= 0) {
      if (ahead.empty()) {
        if (behind == 0) return true;
        const Pending& next = pending_[--behind];
        ahead.emplace_back(next.doc, next.flat);
      }
      const auto [doc, flat] = ahead.back();
      ahead.pop_back();
      if (ends_line(*doc, flat)) return true;
      if (doc->type == Doc::Type::Space) --left;
      left -= width(doc->text);
      const bool flat_inside = flat || doc->type == Doc::Type::Flat;
      for (std::size_t i = doc->parts.size(); i-- > 0;) ahead.emplace_back(&doc->parts[i], flat_inside);
    }
    return false;
  }

  static bool ends_line(const Doc& doc, bool flat) {
    return doc.type == Doc::Type::NewLine || doc.type == Doc::Type::Comment || (doc.type == Doc::Type::Break && !flat);
  }

  std::vector<TextLine> lines_{TextLine{}};
  std::vector<Pending> pending_;
  std::vector<std::size_t> rows_;  // the numbers, from 1, of the lines where the rows around have begun
};

}  // namespace

Doc text(std::string_view words) {
  return leaf(Doc::Type::Text, words);
}
Doc space() {
  return leaf(Doc::Type::Space);
}
Doc blank_or_break() {
  return leaf(Doc::Type::Break, " ");
}
Doc nothing_or_break() {
  return leaf(Doc::Type::Break);
}
Doc new_line() {
  return leaf(Doc::Type::NewLine);
}
Doc blank_line() {
  return leaf(Doc::Type::Blank);
}
Doc comment(std::string_view words) {
  return leaf(Doc::Type::Comment, words);
}
Doc stop() {
  return leaf(Doc::Type::Stop);
}
Doc concat(std::vector<Doc> parts) {
  return inner(Doc::Type::Concat, std::move(parts));
}
Doc group(std::vector<Doc> parts) {
  return inner(Doc::Type::Group, std::move(parts));
}
Doc flat(std::vector<Doc> parts) {
  return inner(Doc::Type::Flat, std::move(parts));
}
Doc indent(int amount, std::vector<Doc> parts) {
  Doc doc = inner(Doc::Type::Indent, std::move(parts));
  doc.amount = amount;
  return doc;
}
Doc row(Table kind, std::vector<Doc> parts) {
  Doc begin = leaf(Doc::Type::RowBegin);
  begin.table = kind;
  parts.insert(parts.begin(), std::move(begin));
  parts.push_back(leaf(Doc::Type::RowEnd));
  return concat(std::move(parts));
}

std::vector<TextLine> print(const Doc& document) {
  return Printer().print(document);
}

int width(std::string_view text) {
  return static_cast<int>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace toile::syntax
