// How statements are written, for whoever got one wrong.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// The form of the statement around a place in a text, "param NAME = VALUE in LOW..HIGH"; empty where none is known.
std::string_view form_of_statement(std::string_view text, std::uint32_t at);

/// The words that begin statements, anywhere.
const std::vector<std::string>& statement_names();

}  // namespace toile
