#include "runtime/driver/laboratory.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/export/plot.hpp"
#include "runtime/fabric/law.hpp"
#include "runtime/laboratory/kes.hpp"

namespace toile {
namespace {

constexpr double gf_per_cm = 0.980665;        // [N/m]
constexpr double gf_cm_per_cm = 9.80665e-3;   // [N]
constexpr double gf_cm2_per_cm = 9.80665e-5;  // [N m]
constexpr double gf_cm_per_cm2 = 0.980665;    // [J/m2]
constexpr double degree = std::numbers::pi / 180;
constexpr double kes_force = 490.3325;  // [N/m]

using Row = std::optional<WarpWeft>;

/// A row of the sheet as it is printed.
struct SheetRow {
  const char* name;
  const char* unit;
  double in_unit;  // SI of one of it
  Row FabricSheet::*row;
  bool is_mean;  // warp and weft act through their mean
};

const std::array<SheetRow, 8> sheet_rows{{{"LT", "", 1, &FabricSheet::lt, false},
                                          {"WT", "gf cm/cm2", gf_cm_per_cm2, &FabricSheet::wt, false},
                                          {"EMT", "%", 0.01, &FabricSheet::emt, false},
                                          {"G", "gf/cm/deg", gf_per_cm / degree, &FabricSheet::g, true},
                                          {"2HG", "gf/cm", gf_per_cm, &FabricSheet::hg, true},
                                          {"2HG5", "gf/cm", gf_per_cm, &FabricSheet::hg5, true},
                                          {"B", "gf cm2/cm", gf_cm2_per_cm, &FabricSheet::b, false},
                                          {"2HB", "gf cm/cm", gf_cm_per_cm, &FabricSheet::hb, false}}};

/// The sheet that the solver works with: class values in missing rows, and the rows that plain constants amount to.
FabricSheet effective(const FabricSheet& measured) {
  FabricSheet sheet = with_class_values(measured);
  if (sheet.stretch) {
    sheet.lt = WarpWeft{1, 1};
    sheet.emt = WarpWeft{kes_force / sheet.stretch->warp, kes_force / sheet.stretch->weft};
  }
  if (sheet.shear) {
    sheet.g = WarpWeft{*sheet.shear, *sheet.shear};
    sheet.hg = sheet.hg5 = WarpWeft{};
  }
  if (!measured.wt || sheet.stretch) {
    sheet.wt =
        WarpWeft{sheet.lt->warp * kes_force * sheet.emt->warp / 2, sheet.lt->weft * kes_force * sheet.emt->weft / 2};
  }
  return sheet;
}

std::string difference(double found, double was) {
  if (was == 0) return std::abs(found) < 1e-9 ? "0" : "–";
  return fmt::format("{:+.2f} %", 100 * (found / was - 1));
}

void print_row(Workroom& workroom, const SheetRow& row, const FabricSheet& measured, const FabricSheet& in,
               const FabricSheet& read) {
  const WarpWeft was = *(in.*row.row), found = *(read.*row.row);
  const double mean = 0.5 * (was.warp + was.weft);
  const auto shown = [&row](double value) { return fmt::format("{:.4g}", value / row.in_unit); };
  std::string note;
  if (!(measured.*row.row)) {
    const FabricSheet told = in_kes_rows(measured);
    note = told.*row.row                                        ? "  from FAST or the cantilever"
           : row.row == &FabricSheet::wt && told.lt && told.emt ? "  from LT and EMT"
           : measured.stretch || measured.shear                 ? "  from the constants"
                                                                : "  class value";
  }
  if (row.is_mean && was.warp != was.weft) note += "  the mean of both acts";
  workroom.listener().printed(fmt::format("{:5} {:10} {:>9} {:>9}   {:>9} {:>9}   {:>9} {:>9}{}", row.name, row.unit,
                                          shown(was.warp), shown(was.weft), shown(found.warp), shown(found.weft),
                                          difference(found.warp, row.is_mean ? mean : was.warp),
                                          difference(found.weft, row.is_mean ? mean : was.weft), note));
}

PlotPanel panel(const std::string& title, const std::string& across, double across_unit, const std::string& up,
                double up_unit, const std::array<KesCurve, 2>& curves) {
  PlotPanel panel{title, across, up, {}};
  for (const std::size_t thread : {std::size_t{0}, std::size_t{1}}) {
    PlotSeries& series = panel.series.emplace_back();
    series.name = thread == 0 ? "warp" : "weft";
    for (const Vec2 p : curves[thread]) series.points.push_back({p.x / across_unit, p.y / up_unit});
  }
  return panel;
}

}  // namespace

std::vector<PlotPanel> drawn(const KesReading& reading) {
  return {panel("Tensile", "elongation [%]", 0.01, "force [gf/cm]", gf_per_cm, reading.tensile),
          panel("Shear", "angle [deg]", degree, "force [gf/cm]", gf_per_cm, reading.shear),
          panel("Bending", "curvature [1/cm]", 100, "moment [gf cm/cm]", gf_cm_per_cm, reading.bending)};
}

void test_fabric(Workroom& workroom, const std::string& fabric, const std::filesystem::path& drawing) {
  const std::optional<FabricSheet> measured = workroom.fabric_called(fabric);
  if (!measured) return;
  const FabricSheet in = effective(*measured);
  const KesReading reading = kes_reading(*measured, workroom.job());
  if (workroom.interrupted()) return;
  Listener& listener = workroom.listener();
  listener.printed(fmt::format("{}{}", fabric, measured->source.empty() ? "" : ": " + measured->source));
  listener.printed(fmt::format("{:16} {:^19}   {:^19}   {:^19}", "", "sheet", "read back", "difference"));
  listener.printed(
      fmt::format("{:16} {:>9} {:>9}   {:>9} {:>9}   {:>9} {:>9}", "", "warp", "weft", "warp", "weft", "warp", "weft"));
  for (const SheetRow& row : sheet_rows) print_row(workroom, row, *measured, in, reading.sheet);
  if (!reading.trouble.empty()) workroom.unsettled(reading.trouble + " did not come to rest");
  workroom.write(drawing, plot_svg(drawn(reading)));
}

}  // namespace toile
