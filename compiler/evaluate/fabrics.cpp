#include "compiler/evaluate/fabrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "compiler/diag/nearest.hpp"
#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/fabric_instruments.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/want.hpp"
#include "compiler/pattern/fabric_rows.hpp"
#include "compiler/units/format.hpp"
#include "compiler/units/unit.hpp"

namespace toile {
namespace {

using Both = std::optional<WarpWeft> FabricSheet::*;
using Single = std::optional<double> FabricSheet::*;

std::vector<std::string> row_names() {
  std::vector<std::string> names;
  for (const FabricRow& row : fabric_rows()) names.emplace_back(row.name);
  names.emplace_back("source");
  return names;
}

class FabricReader {
 public:
  FabricReader(Session& session, const Scope& scope, const syntax::Fabric& written)
      : session_(session), scope_(scope), module_(scope.module()), written_(written) {}

  std::optional<FabricSheet> read() {
    if (!read_base()) return std::nullopt;
    sheet_.name = session_.name_of(module_, written_.name());
    sheet_.written = module_.at(written_);
    for (const syntax::View item : syntax::items(written_)) {
      if (const auto row = syntax::as<syntax::Row>(item)) read_row(*row);
    }
    check_whole();
    return sound_ ? std::optional(sheet_) : std::nullopt;
  }

 private:
  bool read_base() {
    const auto base_expr = written_.base();
    if (!base_expr) return true;
    const Value base = evaluate(session_, scope_, base_expr);
    if (base.unknown()) return false;
    if (const auto* fabric = base.as<FabricValue>()) {
      sheet_ = *fabric->sheet;
      return true;
    }
    session_.report.add(Problem("E0202", "a fabric is varied from a fabric, and this is " + describe(base))
                            .at(module_.at(*base_expr), describe(base)));
    return false;
  }

  void read_row(const syntax::Row& row) {
    const auto token = row.name();
    if (!token) return;
    const std::string name = session_.name_of(module_, token);
    const auto kind = std::find_if(fabric_rows().begin(), fabric_rows().end(),
                                   [&](const FabricRow& each) { return each.name == name; });
    if (kind == fabric_rows().end() && name != "source") {
      report_unknown(session_, module_, *token, "a fabric has no row `" + name + "`", row_names(), "E0402");
      sound_ = false;
      return;
    }
    if (const auto [earlier, is_new] = seen_.try_emplace(name, module_.at(*token)); !is_new) {
      session_.report.add(Problem("E0404", "row `" + name + "` is given twice")
                              .at(module_.at(*token), "again here")
                              .also(earlier->second, "first here"));
      sound_ = false;
      return;
    }
    if (name == "source") return read_source(row);
    read_measurement(row, *kind);
  }

  void read_source(const syntax::Row& row) {
    const std::vector<syntax::Expr> values = row.values();
    if (values.empty()) return;
    const Wanted wanted{session_, scope_};
    if (const auto text = wanted.text(values.front(), "a source")) sheet_.source = *text;
  }

  void read_measurement(const syntax::Row& row, const FabricRow& kind) {
    const std::vector<syntax::Expr> values = row.values();
    const bool both = std::holds_alternative<Both>(kind.place);
    const std::size_t most = both ? 2 : 1;
    if (values.empty()) {
      sound_ = false;
      return;
    }
    if (values.size() > most) {
      session_.report.add(
          Problem("E0403", fmt::format("row `{}` has {}", kind.name,
                                       both ? "two values at most: warp, weft" : "one value for both directions"))
              .at(module_.at(values[most]), "this is one too many"));
      sound_ = false;
      return;
    }
    std::vector<double> read;
    for (const syntax::Expr& value : values) {
      if (const auto si = measurement(value, kind)) read.push_back(*si);
    }
    if (read.size() != values.size()) {
      sound_ = false;
    } else if (both) {
      sheet_.*std::get<Both>(kind.place) = WarpWeft{read.front(), read.back()};
    } else {
      sheet_.*std::get<Single>(kind.place) = read.front();
    }
  }

  std::optional<double> measurement(const syntax::Expr& expr, const FabricRow& kind) {
    const Unit unit = parse_unit(kind.unit).value_or(Unit{});
    const Wanted wanted{session_, scope_};
    const Value value = evaluate(session_, scope_, expr);
    if (value.unknown()) return std::nullopt;
    const auto* quantity = value.as<Quantity>();
    if (quantity == nullptr || quantity->dimension != unit.dimension) {
      const std::string in_unit = kind.unit == "1" ? "a plain number" : fmt::format("in {}", kind.unit);
      session_.report.add(
          Problem("E0201", fmt::format("row `{}` is {}, and this is {}", kind.name, in_unit, describe(value)))
              .at(module_.at(expr), describe(value))
              .help(kind.unit == "1" ? "" : fmt::format("write it as on the sheet: {} 1 {}", kind.name, kind.unit)));
      return std::nullopt;
    }
    if (!wanted.there(expr, value, "a fabric")) return std::nullopt;
    const double si = quantity->si;
    if (si >= kind.least && si <= kind.most) return si;
    const auto in_unit = [&](double x) {
      return format_number(x / unit.factor, 4) + (kind.unit == "1" ? "" : " " + std::string(kind.unit));
    };
    session_.report.add(
        Problem("E0403", fmt::format("no cloth has {} = {}", kind.name, in_unit(si)))
            .at(module_.at(expr), si < 0 ? "this is negative" : "")
            .help(fmt::format("{} lies between {} and {}", kind.name, in_unit(kind.least), in_unit(kind.most))));
    return std::nullopt;
  }

  void check_whole() {
    const bool no_weight = !sheet_.weight && !seen_.contains("W");
    const bool no_bending = !sheet_.b && !sheet_.c && !seen_.contains("B") && !seen_.contains("C");
    if (no_weight || no_bending) {
      sound_ = false;
      if (!module_.broken(written_.span())) report_missing(no_weight, no_bending);
    }
    sound_ =
        sound_ && of_one_instrument(session_.report, sheet_, seen_) && fit_together(session_.report, sheet_, seen_);
    if (!sound_) return;
    if (sheet_.lt && sheet_.wt && sheet_.emt) check_tensile();
    if (sheet_.g && sheet_.hg && sheet_.hg5) check_shear();
    if (sheet_.t0 && sheet_.tm && *sheet_.tm > *sheet_.t0) {
      warn_of("Tm", fmt::format("fabric `{}` is thicker under 50 gf/cm^2 than under 0.5", sheet_.name),
              "Tm is at most T0: are they swapped?");
    }
  }

  void report_missing(bool no_weight, bool no_bending) {
    const auto name = written_.name();
    const std::string missing = no_weight && no_bending ? "no weight (row W) and no bending stiffness (row B)"
                                : no_weight             ? "no weight (row W)"
                                                        : "no bending stiffness (row B)";
    session_.report.add(Problem("E0401", fmt::format("fabric `{}` has {}", sheet_.name, missing))
                            .at(name ? module_.at(*name) : module_.at(written_))
                            .help(no_weight ? "add a row like `W 19.2 mg/cm^2`"
                                            : "add a row like `B 0.07 gf*cm^2/cm, 0.06 gf*cm^2/cm`"));
  }

  /// WT = LT * Fm * EMT / 2: the work under the curve is what its linearity says.
  void check_tensile() {
    constexpr double end_force = 490.3325;  // [N/m] 500 gf/cm
    const auto check = [&](double lt, double emt, double wt, std::string_view direction) {
      const double expected = lt * end_force * emt / 2;
      if (std::abs(wt - expected) <= 0.02 * expected) return;
      const double in_kes = parse_unit("gf*cm/cm^2")->factor;
      const auto at = seen_.find("WT");
      session_.report.add(
          Problem(
              "W0405",
              fmt::format("the {} rows of fabric `{}` contradict each other: WT is {} gf*cm/cm^2, and LT * "
                          "Fm * EMT / 2 is {}",
                          direction, sheet_.name, format_number(wt / in_kes, 4), format_number(expected / in_kes, 4)))
              .at(at == seen_.end() ? sheet_.written : at->second)
              .help("one of LT, WT and EMT is mistyped"));
    };
    check(sheet_.lt->warp, sheet_.emt->warp, sheet_.wt->warp, "warp");
    if (sheet_.lt->weft == sheet_.lt->warp && sheet_.emt->weft == sheet_.emt->warp &&
        sheet_.wt->weft == sheet_.wt->warp) {
      return;
    }
    check(sheet_.lt->weft, sheet_.emt->weft, sheet_.wt->weft, "weft");
  }

  /// The loop's half width grows from 0.5 to 5 degrees by a part of what the whole curve does: threads press on each
  /// other the more the cloth is sheared, but something elastic is left.
  void check_shear() {
    constexpr double between = 4.5 * 3.14159265358979323846 / 180;
    const auto check = [&](double g, double hg, double hg5) {
      const double growth = (hg5 - hg) / 2 / between;
      if (hg5 < 0.98 * hg) {
        warn_of("2HG5",
                fmt::format("the loop of shear of fabric `{}` is narrower at 5 deg than at 0.5 deg", sheet_.name),
                "2HG5 is at least 2HG: are they swapped?");
        return false;
      }
      if (growth > 2 * g / 3) {
        warn_of("G", fmt::format("the loop of shear of fabric `{}` grows faster than its curve rises", sheet_.name),
                "G is too small for 2HG5, or one of them is in another unit");
        return false;
      }
      return true;
    };
    if (check(sheet_.g->warp, sheet_.hg->warp, sheet_.hg5->warp)) {
      check(sheet_.g->weft, sheet_.hg->weft, sheet_.hg5->weft);
    }
  }

  void warn_of(const std::string& row, std::string message, std::string help) {
    const auto at = seen_.find(row);
    session_.report.add(
        Problem("W0412", std::move(message)).at(at == seen_.end() ? sheet_.written : at->second).help(std::move(help)));
  }

  Session& session_;
  const Scope& scope_;
  const Module& module_;
  const syntax::Fabric& written_;
  FabricSheet sheet_;
  std::map<std::string, Location> seen_;
  bool sound_ = true;
};

}  // namespace

void define_fabric(Session& session, Scope& scope, const syntax::Fabric& written) {
  define(session, scope, written.name(), [&session, &scope, written]() -> Value {
    auto sheet = FabricReader(session, scope, written).read();
    if (!sheet) return Unknown{};
    return FabricValue{std::make_shared<const FabricSheet>(std::move(*sheet))};
  });
}

}  // namespace toile
