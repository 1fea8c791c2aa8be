// Cloths of the standard library on the virtual instruments.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/driver/laboratory.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/laboratory/kes.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/library.hpp"

namespace toile::validation {
namespace {

void add_rows(const std::string& name, Chapter& chapter) {
  const FabricSheet was = with_class_values(fabric_called(name));
  const KesReading reading = kes_reading(was, {});
  struct Row {
    const char* name;
    std::optional<WarpWeft> FabricSheet::*row;
    bool is_mean;
  };
  for (const Row& row :
       {Row{"LT", &FabricSheet::lt, false}, Row{"EMT", &FabricSheet::emt, false}, Row{"G", &FabricSheet::g, true},
        Row{"2HG", &FabricSheet::hg, true}, Row{"2HG5", &FabricSheet::hg5, true}, Row{"B", &FabricSheet::b, false},
        Row{"2HB", &FabricSheet::hb, false}}) {
    const WarpWeft in = *(was.*row.row), out = *(reading.sheet.*row.row);
    // The row that is farther off stands for both.
    const double warp = out.warp / (row.is_mean ? 0.5 * (in.warp + in.weft) : in.warp);
    const double weft = out.weft / (row.is_mean ? 0.5 * (in.warp + in.weft) : in.weft);
    if (in.warp == 0 || in.weft == 0) continue;
    chapter.figures.push_back(near(name, fmt::format("{} over the sheet's", row.name), 1,
                                   std::abs(warp - 1) > std::abs(weft - 1) ? warp : weft, 0.005));
  }
}

}  // namespace

Chapter kes_sheets(Effort effort) {
  Chapter chapter{"Virtual KES laboratory",
                  "The sheet that went in; of warp and weft the one that is farther off. The loops are those of the "
                  "friction with a history.",
                  {},
                  {},
                  {}};
  std::vector<std::string> names{"wool_serge"};
  if (effort == Effort::Full) {
    names = {"wool_serge", "cotton_shirting", "denim",         "silk",        "wool_coating", "linen",
             "chiffon",    "velvet",          "cotton_jersey", "double_knit", "leather",      "polyester_tropical"};
  }
  for (const std::string& name : names) add_rows(name, chapter);
  if (effort == Effort::Full) {
    chapter.pictures.push_back({"wool_serge.kes", "The curves of a wool serge, through two loops of shear and bending.",
                                drawn(kes_reading(fabric_called("wool_serge"), {}))});
  }
  return chapter;
}

}  // namespace toile::validation
