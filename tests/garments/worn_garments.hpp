// Garments for a dress form with random measures, as text from `body form` to `drape`. Their cloth is called `cloth`.
#pragma once

#include <string>

#include "tests/garments/dice.hpp"

namespace toile::test {

std::string skirt_of_gores(Dice& dice);
std::string skirt_with_a_ruffle(Dice& dice);
std::string pleated_skirt(Dice& dice);
std::string cape(Dice& dice);
std::string poncho(Dice& dice);
std::string trousers(Dice& dice);
std::string blouse(Dice& dice);
std::string t_shirt(Dice& dice);

}  // namespace toile::test
