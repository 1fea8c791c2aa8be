#include "compiler/evaluate/fabric_instruments.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/units/format.hpp"
#include "compiler/units/unit.hpp"

namespace toile {
namespace {

using Rows = std::vector<std::string_view>;

/// One property, by two instruments.
struct Property {
  std::string_view name;
  Rows kes, fast;
  void (*forget_kes)(FabricSheet&);
  void (*forget_fast)(FabricSheet&);
  std::string_view help;
};

const std::array<Property, 5>& properties() {
  using S = FabricSheet;
  static const std::array<Property, 5> all{{
      {"bending",
       {"B", "2HB", "B45"},
       {"C", "C45"},
       [](S& s) { s.b.reset(), s.hb.reset(), s.b45.reset(); },
       [](S& s) { s.c.reset(), s.c45.reset(); },
       "a cantilever's rigidity contains the friction that 2HB counts apart: give B and 2HB, or C"},
      {"twisting",
       {"twist"},
       {"B45", "C45"},
       [](S& s) { s.twist.reset(); },
       [](S& s) { s.b45.reset(), s.c45.reset(); },
       "a strip on the bias says the twisting stiffness: give one of the two"},
      {"elongation",
       {"LT", "WT", "RT", "EMT", "stretch"},
       {"E5", "E20", "E100"},
       [](S& s) { s.lt.reset(), s.wt.reset(), s.rt.reset(), s.emt.reset(), s.stretch.reset(); },
       [](S& s) { s.e5.reset(), s.e20.reset(), s.e100.reset(); },
       "give the tensile rows of the KES, or E20 and E100 of FAST"},
      {"shear",
       {"G", "2HG", "2HG5", "shear"},
       {"EB5"},
       [](S& s) { s.g.reset(), s.hg.reset(), s.hg5.reset(), s.shear.reset(); },
       [](S& s) { s.eb5.reset(); },
       "give the shear rows of the KES, or EB5 of FAST"},
      {"thickness",
       {"T0", "Tm"},
       {"T2", "T100"},
       [](S& s) { s.t0.reset(), s.tm.reset(); },
       [](S& s) { s.t2.reset(), s.t100.reset(); },
       "the plates press otherwise: give T0 and Tm, or T2 and T100"},
  }};
  return all;
}

WrittenRows::const_iterator first_of(const WrittenRows& rows, const Rows& names) {
  for (const std::string_view name : names) {
    if (const auto found = rows.find(std::string(name)); found != rows.end()) return found;
  }
  return rows.end();
}

class Fit {
 public:
  Fit(Reporter& report, const FabricSheet& sheet, const WrittenRows& rows)
      : report_(report), sheet_(sheet), rows_(rows) {}

  bool holds() {
    if (sheet_.e20.has_value() != sheet_.e100.has_value() || (sheet_.e5 && !sheet_.e20)) {
      refuse({"E20", "E100", "E5"}, "the curve of elongation needs both E20 and E100", "add the row that is missing");
    } else if (sheet_.e20) {
      curve("warp", &WarpWeft::warp);
      if (holds_) curve("weft", &WarpWeft::weft);
    }
    if (sheet_.c45 && !sheet_.c) refuse({"C45"}, "C45 says the twisting stiffness only beside C", "add the row C");
    if (sheet_.b45 && sheet_.b) {
      const double unit = parse_unit("gf*cm^2/cm")->factor;
      bias("B45", *sheet_.b45 / unit, stiffest(*sheet_.b) / unit, "gf*cm^2/cm");
    }
    if (sheet_.c45 && sheet_.c) {
      const auto cubed = [](double x) { return x * x * x; };
      const double most = std::cbrt(stiffest({cubed(sheet_.c->warp), cubed(sheet_.c->weft)}));
      bias("C45", 1000 * *sheet_.c45, 1000 * most, "mm");
    }
    return holds_;
  }

 private:
  void refuse(const Rows& at, std::string message, std::string help) {
    const auto row = first_of(rows_, at);
    report_.add(Problem("E0414", std::move(message))
                    .at(row == rows_.end() ? sheet_.written : row->second)
                    .help(std::move(help)));
    holds_ = false;
  }

  /// From 20 to 100 gf/cm cloth grows stiffer, never softer.
  void curve(std::string_view thread, double WarpWeft::*of) {
    const double middle = (*sheet_.e20).*of, last = (*sheet_.e100).*of;
    const auto percent = [](double x) { return format_number(100 * x, 4) + "%"; };
    if (last <= middle || (sheet_.e5 && (*sheet_.e5).*of >= middle)) {
      return refuse(
          {"E20", "E100"},
          fmt::format("the elongation of the {} does not grow with the force: {}{} at 20 gf/cm and {} at 100", thread,
                      sheet_.e5 ? percent((*sheet_.e5).*of) + " at 5 gf/cm, " : "", percent(middle), percent(last)),
          "are E5, E20 and E100 swapped?");
    }
    if (last > 5 * middle) {
      refuse({"E100", "E20"},
             fmt::format("the {} would grow softer: {} at 20 gf/cm, and more than five times that, {}, at 100", thread,
                         percent(middle), percent(last)),
             "E100 is at most five times E20");
    }
  }

  /// What a strip on the bias would have, did it not twist at all: 4/B45 = 1/B(warp) + 1/B(weft)
  /// + 1/D66, the strip being free to curve across.
  static double stiffest(WarpWeft b) { return 4 / (1 / b.warp + 1 / b.weft); }

  void bias(std::string_view row, double given, double most, std::string_view unit) {
    if (given < most) return;
    refuse({row},
           fmt::format("with these threads a strip on the bias has {} below {} {}, and {} is given", row,
                       format_number(most, 4), unit, format_number(given, 4)),
           "were warp, weft and bias measured on the same cloth?");
  }

  Reporter& report_;
  const FabricSheet& sheet_;
  const WrittenRows& rows_;
  bool holds_ = true;
};

}  // namespace

bool of_one_instrument(Reporter& report, FabricSheet& sheet, const WrittenRows& rows) {
  bool sound = true;
  for (const Property& property : properties()) {
    const auto kes = first_of(rows, property.kes), fast = first_of(rows, property.fast);
    if (kes != rows.end() && fast != rows.end()) {
      report.add(Problem("E0413", fmt::format("the {} of fabric `{}` is given by two instruments: `{}` and `{}`",
                                              property.name, sheet.name, kes->first, fast->first))
                     .at(fast->second)
                     .also(kes->second, "and here")
                     .help(std::string(property.help)));
      sound = false;
    } else if (fast != rows.end()) {
      property.forget_kes(sheet);
    } else if (kes != rows.end()) {
      property.forget_fast(sheet);
    }
  }
  return sound;
}

bool fit_together(Reporter& report, const FabricSheet& sheet, const WrittenRows& rows) {
  return Fit(report, sheet, rows).holds();
}

}  // namespace toile
