// The things of a script that live as long as it: modules, functions, bodies, garments with their pieces, drapes.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/evaluate/program.hpp"
#include "compiler/evaluate/scope.hpp"
#include "compiler/evaluate/value.hpp"
#include "compiler/pattern/draft.hpp"
#include "grammar/ast.hpp"
#include "grammar/parse.hpp"

namespace toile {

struct Module {
  std::string name;  // "bodies", "parts/cuffs.toile"
  FileId file = 0;
  bool from_stdlib = false;
  bool loading = false;
  syntax::Parsed parsed{syntax::Tree({}), {}};
  std::unique_ptr<Scope> scope;
  std::vector<syntax::View> commands;
  std::vector<std::pair<std::string, Module*>> imports;  // by the names that they have here
  std::vector<std::string> not_found;                    // modules that it would import
  std::set<std::string> told;                            // names that its top has not

  Location at(Span span) const { return {file, span}; }
  Location at(const syntax::View& view) const { return {file, view.span()}; }
  /// Whether the parser stumbled over something in this stretch of text.
  bool broken(Span span) const;
};

struct UserFunction {
  syntax::Fn written;
  const Scope* scope = nullptr;
};

struct BodyTemplate {
  syntax::Body written;
  const Scope* scope = nullptr;
  std::string name;
};

struct GarmentTemplate {
  syntax::Garment written;
  const Scope* scope = nullptr;
  std::string name;
};

struct PieceTemplate {
  syntax::Piece written;
  const Scope* scope = nullptr;
  std::string name;
};

struct BodyInstance {
  BodySpec spec;
  int index = -1;  // among Program::bodies()
  bool sound = true;
  std::optional<std::vector<BodyLineFacts>> lines;  // once measured
};

struct PlannedEdge {
  std::string name;
  syntax::Edge written;
  std::optional<syntax::Repeat> each{};  // all the edges of a `for`, in a plan
  const Scope* scope = nullptr;          // of the turn of a `for`
};

/// A statement of a piece that may stand under a `for`.
struct Repeated {
  syntax::View written;
  std::optional<syntax::For> each;
};

/// Statements of a plan are read as where they were written: those of a piece that was taken from elsewhere and varied
/// with that piece's garment and module around them.
struct PieceSource {
  syntax::Piece written;
  const PieceInstance* model = nullptr;  // in whose surroundings they are read
};

/// A piece's statements after its variations were applied: `piece back = front with { … }` starts from front's.
struct PiecePlan {
  std::vector<PieceSource> sources;
  std::optional<syntax::Expr> on;  // the body, or a chart of it
  std::vector<syntax::Let> lets;
  std::vector<syntax::Solve> solves;
  std::optional<syntax::Outline> outline;  // the one that says where the pen starts
  std::vector<PlannedEdge> edges;
  std::vector<syntax::Inner> inner;  // holes and lines
  std::optional<syntax::Fold> fold;
  std::optional<syntax::Cut> cut;
  std::optional<syntax::Grain> grain;
  std::vector<Repeated> details;  // darts, notches, pleats, marks, … in the order of the script
  std::optional<syntax::Allowance> allowance;
  std::optional<syntax::Label> label;

  const PieceSource& source_of(const syntax::View& statement) const;
  const Module& module_of(const syntax::View& statement) const;
};

/// A hole or a line inside a piece.
struct InnerInstance {
  std::string name;  // empty when the script gives none
  syntax::Inner written;
  std::vector<PlannedEdge> edges;
  std::unique_ptr<Scope> scope;  // its edges

  const char* kind() const { return written.is_line() ? "line" : "hole"; }
};

struct PieceInstance {
  std::string name;
  bool late = false;               // drawn elsewhere, perhaps varied here: looked for when it is first asked for
  PieceInstance* taken = nullptr;  // the piece that this one is, where it was drawn elsewhere
  GarmentInstance* garment = nullptr;
  syntax::Piece written;
  PiecePlan plan;
  const Scope* outer = nullptr;                                      // in which it is drawn, or taken
  std::unique_ptr<Scope> parameters;                                 // of its models elsewhere
  std::unique_ptr<Scope> scope;                                      // its lets, edges, holes and lines
  std::map<const PieceInstance*, std::unique_ptr<Scope>> elsewhere;  // for the statements of its models elsewhere
  std::vector<PlannedEdge> edges;                                    // of the plan, those of a `for` put out
  std::vector<std::unique_ptr<Scope>> turns;                         // of a `for` of its edges
  std::vector<std::unique_ptr<InnerInstance>> inner;
  bool sound = true;
  bool doubled = false;  // two of its edges have one name: an unknown edge may be one of them

  /// In which a statement of its plan is read.
  const Scope& scope_of(const syntax::View& statement) const;
  std::vector<std::string> edge_names() const;
  /// The hole or line of that name, or null.
  const InnerInstance* inner_called(std::string_view inner_name) const;
};

struct GarmentInstance {
  syntax::Garment written;
  std::unique_ptr<Scope> scope;
  std::vector<std::unique_ptr<Scope>> turns;  // of a `for` of its pieces
  std::vector<std::unique_ptr<PieceInstance>> pieces;
  std::vector<std::shared_ptr<BodyInstance>> worn_on;  // of each wear
  DraftGarment draft;
  int index = -1;  // among Program::garments()
  bool has_fabric = false;
  bool sound = true;
  bool doubled = false;  // two of its pieces have one name: an unknown piece may be one of them
  std::map<std::string, std::size_t, std::less<>> repeated;  // the pieces of a `for`: how many there are of each
  std::set<std::string> told;                                // names of pieces that there are not
  std::shared_ptr<BodyInstance> drawn_on;                    // of pieces that are to be developed

  PieceInstance* piece(std::string_view piece_name) const;
  void add(std::unique_ptr<PieceInstance> piece);

 private:
  std::map<std::string, PieceInstance*, std::less<>> by_name_;
};

/// A drape or a development.
struct DrapeRecord {
  std::string name;
  Location written;
  bool develops = false;
  const DrapeRecord* developed = nullptr;  // whose pattern is draped, if it is a development's
  bool reached = false;                    // by the commands, in their order
  std::optional<Result> result;
  const GarmentInstance* garment = nullptr;  // of a development
};

}  // namespace toile
