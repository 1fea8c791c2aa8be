// A text that knows where its lines may be broken, and the printer that breaks them: as few as the page's width allows,
// the outermost groups first (Wadler's pretty printer).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toile::syntax {

/// No line of code is longer, unless there is no place to break it; comments are not counted.
inline constexpr int page_width = 100;

/// Lines that follow each other with the same one of these are set in columns.
enum class Table { None, Let, Param, Edge, Parameter, Command, Seam, Detail, Part, Measure, Size };

/// Part of a document. Texts are views into the source or literals.
struct Doc {
  enum class Type {
    Text,     // of one line
    Space,    // one blank; nothing at the beginning of a line
    Break,    // `text` (a blank or nothing), or a new line where its group is broken
    NewLine,  // always
    Blank,    // an empty line before the next line
    Concat,
    Group,     // in one line if it fits, else with all its own breaks
    Flat,      // in one line whether it fits or not
    Indent,    // `amount` deeper
    Comment,   // to the end of the line: the next text begins a new one
    RowBegin,  // of something that may stand in one line
    RowEnd,
    Stop,  // a column begins behind the blanks here
  };
  Type type = Type::Concat;
  std::string_view text;
  int amount = 0;
  Table table = Table::None;
  bool breaks = false;  // a group that cannot stand in one line
  std::vector<Doc> parts;
};

Doc text(std::string_view words);
Doc space();
/// A blank, or a new line.
Doc blank_or_break();
/// Nothing, or a new line.
Doc nothing_or_break();
Doc new_line();
Doc blank_line();
Doc comment(std::string_view words);
Doc stop();
Doc concat(std::vector<Doc> parts);
Doc group(std::vector<Doc> parts);
Doc flat(std::vector<Doc> parts);
Doc indent(int amount, std::vector<Doc> parts);
/// A statement or the like; if it comes to stand in a line of its own, its stops are columns.
Doc row(Table kind, std::vector<Doc> parts);

/// A line as printed.
struct TextLine {
  int indentation = 0;
  std::string text;
  std::string comment;
  std::vector<std::size_t> stops;  // offsets into `text`
  Table table = Table::None;
  bool is_row = false;        // a whole statement
  bool blank_before = false;  // an empty line stands before it
};

std::vector<TextLine> print(const Doc& document);

/// How many columns a text takes.
int width(std::string_view text);

}  // namespace toile::syntax
