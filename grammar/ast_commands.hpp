// Views of commands; ast.hpp tells how views are used.
#pragma once

#include <optional>
#include <vector>

#include "grammar/ast_expressions.hpp"

namespace toile::syntax {

/// drape coat over skirt over blouse on form as worn to 1e-6
struct Drape : ViewOf<Kind::Drape> {
  std::optional<Expr> garment() const { return after<Expr>(*this, Kind::KwDrape); }
  std::vector<Expr> over() const;  // from the outside in
  std::optional<Expr> body() const { return after<Expr>(*this, Kind::KwOn); }
  std::optional<Token> name() const { return after<Token>(*this, Kind::KwAs); }
  std::optional<Expr> accuracy() const { return after<Expr>(*this, Kind::KwTo); }
};

/// develop bodice as flat with darts to 2% until within 3mm
struct Develop : ViewOf<Kind::Develop> {
  std::optional<Expr> garment() const { return after<Expr>(*this, Kind::KwDevelop); }
  std::optional<Token> name() const { return after<Token>(*this, Kind::KwAs); }
  std::optional<Expr> strain() const { return after<Expr>(*this, Kind::KwTo); }
  std::optional<Expr> within() const { return after<Expr>(*this, Kind::KwWithin); }
};

/// word() is KwFrom with names() of one view, KwShowing with the dotted names() of a field, or KwPixels with sizes().
struct RenderOption : ViewOf<Kind::RenderOption> {
  std::optional<Token> word() const { return child<Token>(*this); }
  std::vector<Token> names() const;
  std::vector<Expr> sizes() const { return all<Expr>(*this); }
};

struct Render : ViewOf<Kind::Render> {
  std::optional<Expr> subject() const { return after<Expr>(*this, Kind::KwRender); }
  std::optional<Expr> path() const { return after<Expr>(*this, Kind::KwTo); }
  std::vector<RenderOption> options() const { return all<RenderOption>(*this); }
};

struct Export : ViewOf<Kind::Export> {
  std::optional<Expr> subject() const { return after<Expr>(*this, Kind::KwExport); }
  std::optional<Expr> path() const { return after<Expr>(*this, Kind::KwTo); }
};

struct Print : ViewOf<Kind::Print> {
  std::vector<Expr> values() const { return all<Expr>(*this); }
};

struct Expect : ViewOf<Kind::Expect> {
  std::optional<Expr> condition() const { return child<Expr>(*this); }
};

}  // namespace toile::syntax
