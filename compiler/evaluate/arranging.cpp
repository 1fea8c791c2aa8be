#include "compiler/evaluate/arranging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "compiler/evaluate/expression.hpp"
#include "compiler/evaluate/names.hpp"
#include "compiler/evaluate/repetition.hpp"
#include "compiler/evaluate/want.hpp"

namespace toile {
namespace {

class ArrangementReader {
 public:
  ArrangementReader(Session& session, GarmentInstance& garment, const Scope& scope)
      : session_(session), garment_(garment), scope_(scope), module_(scope.module()), wanted_{session, scope} {}

  bool read(const syntax::Arrange& arrange) {
    const auto name = arrange.piece();
    if (!name) return false;
    DraftArrangement made;
    made.written = module_.at(arrange);
    const std::optional<std::vector<std::string>> path = path_of(session_, scope_, arrange);
    if (!path || path->empty()) return false;
    made.piece = path->front();
    if (garment_.piece(made.piece) == nullptr) {
      std::vector<std::string> names;
      for (const auto& each : garment_.pieces) names.push_back(each->name);
      report_unknown(session_, module_, *name,
                     fmt::format("garment `{}` has no piece `{}`", garment_.draft.name, made.piece), names, "E0309");
      return false;
    }
    if (is_arranged(made.piece, *name)) return false;
    const auto at = triple(arrange.place(), dimension::length, "where a piece is put", "a point in space");
    if (!at) return false;
    made.at = *at;
    if (arrange.turn()) {
      const auto turn = triple(arrange.turn(), dimension::angle, "how a piece is turned", "three angles");
      if (!turn) return false;
      made.turn = *turn;
    }
    garment_.draft.arrangements.push_back(std::move(made));
    return true;
  }

 private:
  bool is_arranged(const std::string& piece, const syntax::Token& name) {
    const auto& all = garment_.draft.arrangements;
    const auto before =
        std::find_if(all.begin(), all.end(), [&](const DraftArrangement& each) { return each.piece == piece; });
    if (before == all.end()) return false;
    session_.report.add(Problem("E0102", fmt::format("piece `{}` is arranged twice", piece))
                            .at(module_.at(name))
                            .also(before->written, "here before"));
    return true;
  }

  std::optional<std::array<double, 3>> triple(const std::optional<syntax::Expr>& expr, Dimension wanted_dimension,
                                              const std::string& what, const std::string& wanted) {
    const Value value = evaluate(session_, scope_, expr);
    if (value.unknown()) return std::nullopt;
    const auto* point = value.as<Point3>();
    if (point == nullptr || point->dimension != wanted_dimension) {
      wanted_.wrong(*expr, value, what, wanted);
      return std::nullopt;
    }
    if (!wanted_.there(*expr, value, what)) return std::nullopt;
    return point->at;
  }

  Session& session_;
  GarmentInstance& garment_;
  const Scope& scope_;
  const Module& module_;
  Wanted wanted_;
};

}  // namespace

void read_arrangement(Session& session, GarmentInstance& garment, const Scope& scope, const syntax::Arrange& arrange) {
  if (!ArrangementReader(session, garment, scope).read(arrange)) garment.sound = false;
}

}  // namespace toile
