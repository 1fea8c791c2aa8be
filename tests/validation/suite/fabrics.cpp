// Cloths of the standard library: their sheets read back, and Cusick's drape test where it was measured.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/body/body.hpp"
#include "runtime/drape/levels.hpp"
#include "runtime/driver/laboratory.hpp"
#include "runtime/driver/workroom.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/laboratory/kes.hpp"
#include "runtime/report/folds.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/shadow.hpp"

namespace toile::validation {
namespace {

class Nobody final : public Listener {
 public:
  void diagnosed(const Diagnostic&, const Sources&) override {}
  void printed(const std::string&) override {}
  void noted(const std::string&) override {}
  void wrote(const std::string&) override {}
  void failed(const std::string&, const std::string&) override {}
};

FabricSheet fabric_called(const std::string& name) {
  Nobody nobody;
  Workroom workroom({}, nobody, {});
  workroom.load("validation", "import fabrics\n");
  return workroom.fabric_called("fabrics." + name).value();
}

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

/// A round specimen on a round disc.
struct Tester {
  double specimen, disc;  // [m] radii
  std::string name;
};
const Tester cusick{0.15, 0.09, "30 cm on 18 cm"};
const Tester japanese{0.127, 0.0635, "25.4 cm on 12.7 cm"};

struct Measured {
  const char* fabric;
  const Tester* tester;
  double coefficient;  // [%]
  int nodes;           // 0: not published
};

struct Draped {
  double coefficient = 0;
  int folds = 0;
  double energy = 0;
  bool converged = false;
};

Draped drape_test(const FabricSheet& fabric, const Tester& tester, double edge) {
  DraftPiece piece;
  piece.name = "round";
  const Curve rim = circle({0, 0}, {tester.specimen, 0});
  const double half = rim.length() / 2;
  piece.outline = {{"first", rim.part(0, half), {}}, {"second", rim.part(half, rim.length()), {}}};
  DraftGarment draft;
  draft.name = "specimen";
  draft.pieces = {piece};
  draft.fabric = fabric;
  std::vector<Diagnostic> found;
  const Garment garment = make_garment(draft, found);
  BodySpec spec;
  spec.shape = DiscSpec{tester.disc, 0.02, 0.3};
  std::string error;
  const auto body = Body::make(spec, &error);
  std::vector<SewnMesh> meshes;
  std::vector<double> edges =
      level_edges(edge, static_cast<int>(2.3 * std::numbers::pi * tester.specimen * tester.specimen / (edge * edge)));
  edges.push_back(edge);
  for (const double each : edges) {
    PMeshOptions options;
    options.target_edge = each;
    meshes.push_back(sew(garment, options));
  }
  std::vector<Cloth> cloths;
  for (const SewnMesh& mesh : meshes) cloths.push_back(make_cloth(mesh));
  std::vector<DrapeLevel> levels;
  for (std::size_t i = 0; i < meshes.size(); ++i) levels.push_back({&meshes[i], &cloths[i]});
  const DrapedLevels result = drape_levels(levels, {}, {}, fabric, body.get(), {}, {});
  const double disc = std::numbers::pi * tester.disc * tester.disc;
  const double all = std::numbers::pi * tester.specimen * tester.specimen;
  Draped draped;
  draped.coefficient = 100 * (shadow_area(cloths.back(), result.drape.positions) - disc) / (all - disc);
  const std::vector<bool> held(result.drape.positions.size(), false);
  if (const auto hem = lowest_free_loop(meshes.back().s, result.drape.positions, held)) {
    std::vector<Vec3> loop;
    for (const int vertex : *hem) loop.push_back(result.drape.positions[static_cast<std::size_t>(vertex)]);
    draped.folds = count_folds(loop);
  }
  draped.energy = result.drape.energy.total();
  draped.converged = result.drape.converged;
  return draped;
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

Chapter drape_coefficients(Effort effort) {
  Chapter chapter{
      "Cusick's drape test on published fabrics",
      "Petrak et al. (2025) and Matsudaira et al. (2015), drape coefficients in per cent; rows that were not "
      "published take class values. A single fabric is held to 9 points, the mean of all to 9.",
      {},
      {},
      {}};
  const std::vector<Measured> measured{{"polyester_twill", &cusick, 22.3, 0},
                                       {"polyester_plain", &cusick, 22.8, 0},
                                       {"wool_blend_twill", &cusick, 34.9, 0},
                                       {"polyester_tropical", &japanese, 50.7, 5},
                                       {"polyester_faille", &japanese, 28.3, 7}};
  const double edge = effort == Effort::Full ? 0.005 : 0.01;
  double sum = 0;
  for (const Measured& each : measured) {
    if (effort == Effort::Quick && each.nodes == 0) continue;
    const FabricSheet fabric = fabric_called(each.fabric);
    const Draped draped = drape_test(fabric, *each.tester, edge);
    const std::string subject = fmt::format("{}, {}", each.fabric, each.tester->name);
    chapter.figures.push_back(within(subject, "drape coefficient [%]", each.coefficient, draped.coefficient, 9));
    if (each.nodes > 0) chapter.figures.push_back(within(subject, "folds", each.nodes, draped.folds, 2));
    chapter.remarks.push_back(fmt::format("{}: {} folds, energy {:.6f} J{}.", subject, draped.folds, draped.energy,
                                          draped.converged ? "" : ", not at rest"));
    sum += std::abs(draped.coefficient - each.coefficient);
    if (effort == Effort::Full) {
      const Draped finer = drape_test(fabric, *each.tester, 0.0035);
      chapter.figures.push_back(within(
          subject,
          finer.folds == draped.folds ? "drift from 5 to 3.5 mm [points]" : "drift from 5 to 3.5 mm, folds changed", 0,
          finer.coefficient - draped.coefficient, 1));
    }
  }
  if (effort == Effort::Full) {
    chapter.figures.push_back(
        within("all", "mean difference [points]", 0, sum / static_cast<double>(measured.size()), 9));
  }
  return chapter;
}

}  // namespace toile::validation
