// Garments: pieces, seams and worn lines, drafted and handed to the pattern.
#pragma once

#include <optional>
#include <vector>

#include "compiler/evaluate/call.hpp"
#include "compiler/evaluate/session.hpp"

namespace toile {

/// Defines a `garment` statement: a template when it has parameters, else the garment itself.
void define_garment(Session& session, Scope& scope, const syntax::Garment& written);

Value instantiate(Session& session, const GarmentTemplate& garment, const std::vector<std::optional<Given>>& arguments);

/// The garment that a value stands for: a garment, or a template all of whose parameters have defaults. Null, with an
/// error, for anything else.
GarmentInstance* as_garment(Session& session, const Value& value, Location at);

}  // namespace toile
