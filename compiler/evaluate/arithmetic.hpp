// Operators on values: what they mean for each pair of kinds, and what dimension comes out.
#pragma once

#include <optional>

#include "compiler/evaluate/session.hpp"
#include "compiler/evaluate/value.hpp"
#include "grammar/kinds.hpp"

namespace toile {

/// A value and the text that it came from.
struct Operand {
  const Value& value;
  Location at;
  std::optional<Location> defined = std::nullopt;  // of a name
};

/// `+ - * / ^ < <= > >= == !=`; `and` and `or` are the evaluator's, which need not look at their right side.
Value apply_binary(Session& session, syntax::Kind op, const Operand& left, const Operand& right, Location whole);
Value apply_minus(Session& session, const Operand& operand);

/// The value itself, or Unknown with an error: not a number, infinite, or a length that no garment has.
Value checked(Session& session, Value value, Location at);

}  // namespace toile
