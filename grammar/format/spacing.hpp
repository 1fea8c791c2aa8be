// Small questions of the layout: which kinds are set in columns, where a blank stands, where a line may end.
#pragma once

#include "grammar/format/document.hpp"
#include "grammar/view.hpp"

namespace toile::syntax {

/// With what a statement, property or parameter is set in columns.
Table table_of(Kind kind);

/// How many columns begin before the n-th part (from 0) of a statement.
int stops_before(View statement, View part, int n);

/// Whether neighbours in a line have a blank between them.
bool has_blank_between(View parent, View left, View right, const Source& source);

/// Whether a line of a statement may end between two parts, outside of brackets.
bool may_break_between(View left, View right);

/// `a^2`: a power of a name or a plain number. Behind a unit the blanks are needed: `3cm ^ 2` is not `3cm^2`.
bool is_tight_power(View binary);

/// Two chains of operators that are read from left to right as one: + and -, * and /, and, or.
bool bind_alike(View binary, View other);

/// Numbers, colours, texts and names only: such a list fills its lines.
bool is_list_of_short_values(View list);

/// The parser may take a line that begins with this token for a new statement.
bool may_seem_statement(const Tree& tree, const Source& source, NodeId token);

}  // namespace toile::syntax
