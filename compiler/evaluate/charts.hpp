// Charts: the maps of a body's surface in which pieces are drawn that lie on it.
#pragma once

#include <optional>

#include "compiler/evaluate/session.hpp"
#include "compiler/pattern/chart_spec.hpp"

namespace toile {

/// The body and the map of it that a value means that is one, a body, or a line of a body; no body for any other value.
ChartValue chart_meant(const Value& value);

/// The chart that the value after `on` means: a body, a line of it whose axis is meant, or a map. Nothing, with an
/// error, for anything else. Notes with the garment which body it is drawn on.
std::optional<ChartSpec> chart_of(Session& session, const Value& value, Location at, GarmentInstance& garment);

}  // namespace toile
