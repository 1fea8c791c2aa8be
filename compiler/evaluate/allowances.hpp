// `allow W0410`: warnings that are meant to be.
#pragma once

#include "compiler/evaluate/session.hpp"

namespace toile {

/// Tells the reporter what a module allows, before anything of it is evaluated: in its file, its garments and pieces.
void read_allowances(Session& session, const Module& module);

}  // namespace toile
