// Which garment, body or drape a call of the command line means.
#pragma once

#include <optional>
#include <string>

#include "runtime/driver/workroom.hpp"

namespace toile {

/// The garment of that name, or the only one for an empty name. Nullopt is a wrong usage that has been said.
std::optional<int> choose_garment(Workroom& workroom, const std::string& name);

/// The drape that the names mean: what they leave open is taken from the script's first drape command that fits, or
/// from there being only one. Evaluates commands up to that one.
std::optional<DrapeCommand> choose_drape(Workroom& workroom, const std::string& garment, const std::string& body);

/// The development of that garment, or of the script's first develop command, or of its only garment that is drawn on a
/// body.
std::optional<DevelopCommand> choose_development(Workroom& workroom, const std::string& garment);

}  // namespace toile
