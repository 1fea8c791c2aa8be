#include "grammar/reference/reference.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"

namespace toile::syntax {
namespace {

struct Heading {
  Kind kind;
  std::string_view title;
};
constexpr std::array headings{
    Heading{Kind::Garment, "Garments"}, Heading{Kind::Piece, "Pieces"},     Heading{Kind::Body, "Bodies"},
    Heading{Kind::Fabric, "Fabrics"},   Heading{Kind::Textile, "Textiles"}, Heading{Kind::Sizes, "Size tables"},
    Heading{Kind::Fn, "Functions"},     Heading{Kind::Param, "Params"},     Heading{Kind::Let, "Values"},
};

/// Blanks, line ends and comments between words as one blank.
std::string in_one_line(View view, const Source& source) {
  std::string text;
  bool gap = false, behind_bracket = false;
  for (NodeId id = view.id; id < view.tree->size() && (*view.tree)[id].span.begin < view.span().end; ++id) {
    const Node& leaf = (*view.tree)[id];
    if (!is_token(leaf.kind)) continue;
    if (is_trivia(leaf.kind)) {
      gap = true;
      continue;
    }
    const std::string_view word = source.slice(leaf.span);
    const bool closes = leaf.kind == Kind::RightParen || leaf.kind == Kind::RightBracket;
    if (gap && !behind_bracket && !closes && !text.empty()) text += ' ';
    if (closes && text.ends_with(',')) text.pop_back();
    text += word;
    behind_bracket = leaf.kind == Kind::LeftParen || leaf.kind == Kind::LeftBracket;
    gap = false;
  }
  return text;
}

class Reference {
 public:
  Reference(const Parsed& parsed, const Source& source) : file_(root(parsed.tree)), source_(source) {}

  std::string write(const std::string& module) {
    text_ = "# " + module + "\n";
    const std::vector<View> all = items(file_);
    // A comment above the imports is about the module.
    const std::string about = all.empty() || !as<Import>(all.front()) ? doc_alone() : doc(all.front(), source_);
    paragraph(about);
    for (const Heading& heading : headings) {
      bool first = true;
      for (const View item : all) {
        if (item.kind() != heading.kind || (heading.kind == Kind::Let && doc(item, source_).empty())) continue;
        if (first) text_ += "\n## " + std::string(heading.title) + "\n";
        first = false;
        entry(item);
      }
    }
    return text_;
  }

 private:
  /// The comment at the file's head that belongs to no statement.
  std::string doc_alone() const {
    std::string joined;
    int newlines = 0;
    for (NodeId id = 0; id < file_.tree->size(); ++id) {
      const Node& leaf = (*file_.tree)[id];
      if (!is_token(leaf.kind)) continue;
      if (!is_trivia(leaf.kind)) return "";  // the comment stands right above this statement
      if (leaf.kind == Kind::Newline && ++newlines > 1 && !joined.empty()) return joined;
      if (leaf.kind != Kind::DocComment) continue;
      newlines = 0;
      std::string_view line = source_.slice(leaf.span).substr(3);
      if (line.starts_with(' ')) line.remove_prefix(1);
      joined += (joined.empty() ? "" : "\n") + std::string(line);
    }
    return joined;
  }

  void paragraph(const std::string& text) {
    if (!text.empty()) text_ += "\n" + text + "\n";
  }

  void entry(View item) {
    text_ += "\n### `" + called(item) + "`\n";
    paragraph(doc(item, source_));
    for (const View inner : items(item)) {
      if (const auto param = as<Param>(inner)) settable(*param);
      if (as<Let>(inner) && !doc(inner, source_).empty()) {
        text_ += "\n- `" + called(inner) + "`: " + doc(inner, source_) + "\n";
      }
    }
    if (item.kind() == Kind::Piece) {
      if (const std::string drawn = edges(item); !drawn.empty()) text_ += "\nEdges: " + drawn + ".\n";
    }
    if (item.kind() == Kind::Garment) list_pieces(item);
    if (const auto sizes = as<Sizes>(item)) list_sizes(*sizes);
    if (const auto fabric = as<Fabric>(item)) name_source(*fabric);
  }

  /// As it stands in a script that uses it: `band(around, depth = 4cm)`.
  std::string called(View item) const {
    if (item.kind() == Kind::Param || item.kind() == Kind::Let) {
      return in_one_line(item, source_).substr(item.kind() == Kind::Let ? 4 : 6);
    }
    std::string text(source_.slice(token(item, Kind::Name)->span()));
    if (const auto parameters = child<Parameters>(item)) text += in_one_line(*parameters, source_);
    return text;
  }

  void settable(const Param& param) {
    const std::string about = doc(param, source_);
    text_ += "\n- `" + in_one_line(param, source_) + "`" + (about.empty() ? "" : ": " + about) + "\n";
  }

  /// What others sew to: the pieces, and of each the names along its outline.
  void list_pieces(View garment) {
    bool first = true;
    for (const View item : items(garment)) {
      const auto piece = as<Piece>(item);
      if (!piece || !piece->name()) continue;
      if (first) text_ += "\n";
      first = false;
      text_ += "- " + quoted(*piece->name());
      if (const auto taken = piece->taken())
        text_ += " = `" + in_one_line(*taken, source_) + "`";
      else if (const auto base = piece->base())
        text_ += " = " + quoted(*base) + " varied";
      if (const std::string drawn = edges(item); !drawn.empty()) text_ += ": " + drawn;
      text_ += "\n";
    }
  }

  /// The edges of the outline in their order, then those of its holes and inner lines.
  std::string edges(View piece) const {
    std::string names, fold;
    for (const View item : items(piece)) {
      if (const auto folded = as<Fold>(item); folded && folded->edge()) fold = source_.slice(folded->edge()->span());
    }
    for (const View item : items(piece)) {
      const auto inner = as<Inner>(item);
      if (!inner && !as<Outline>(item)) continue;
      const std::string path = inner && inner->name() ? std::string(source_.slice(inner->name()->span())) + "." : "";
      for (const View walked : items(item)) {
        const auto edge = as<Edge>(walked);
        if (!edge || !edge->name()) continue;
        const std::string name(source_.slice(edge->name()->span()));
        if (!names.empty()) names += ", ";
        names.append("`").append(path).append(name).append("`");
        if (!inner && name == fold) names += " (fold)";
      }
    }
    return names;
  }

  std::string quoted(const Token& name) const { return "`" + std::string(source_.slice(name.span())) + "`"; }

  void list_sizes(const Sizes& sizes) {
    std::string names;
    for (const View row : items(sizes)) {
      const auto size = as<SizeRow>(row);
      if (!size || !size->name()) continue;
      names += (names.empty() ? "" : ", ") + std::string(source_.slice(size->name()->span()));
    }
    if (!names.empty()) text_ += "\nSizes: " + names + ".\n";
  }

  void name_source(const Fabric& fabric) {
    for (const View item : items(fabric)) {
      const auto row = as<Row>(item);
      if (!row || !row->name() || source_.slice(row->name()->span()) != "source" || row->values().empty()) continue;
      const auto text = as<String>(row->values().front());
      if (text && text->inserted().empty()) text_ += "\nSource: " + string_value(*text, source_) + ".\n";
    }
  }

  View file_;
  const Source& source_;
  std::string text_;
};

}  // namespace

std::string reference(const Parsed& parsed, const Source& source, const std::string& module) {
  return Reference(parsed, source).write(module);
}

}  // namespace toile::syntax
