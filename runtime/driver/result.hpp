// A drape's summary as the plain record that a script's later lines read: the names of result_schema(), SI.
#pragma once

#include "compiler/evaluate/program.hpp"
#include "runtime/driver/draped.hpp"

namespace toile {

Result result_of(const Draped& draped);

/// The same of a development: the names of development_schema().
Result result_of(const Developed& developed);

}  // namespace toile
