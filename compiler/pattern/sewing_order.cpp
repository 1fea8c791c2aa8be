#include "compiler/pattern/sewing_order.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "compiler/pattern/sewing.hpp"

namespace toile {
namespace {

SewingStep::Kind kind_of(const Seam& seam) {
  if (seam.is_dart) return SewingStep::Kind::Dart;
  if (seam.is_pleat) return SewingStep::Kind::Pleat;
  return seam.closure == Seam::Closure::Sewn ? SewingStep::Kind::Seam : SewingStep::Kind::Closure;
}

// Both copies of a dart have its name, and both copies and all layers of a seam its statement.
std::string family(const Seam& seam) {
  std::string name = seam.is_dart || seam.is_pleat ? seam.name : "";
  const std::string copy = ".mirrored";
  if (name.ends_with(copy)) name.resize(name.size() - copy.size());
  return name;
}

std::vector<SewingStep> steps_of(const Garment& garment) {
  std::vector<SewingStep> steps;
  std::map<std::tuple<SewingStep::Kind, FileId, std::uint32_t, std::string>, std::size_t> known;
  for (int i = 0; i < static_cast<int>(garment.seams.size()); ++i) {
    const Seam& seam = garment.seams[i];
    const auto [entry, fresh] =
        known.try_emplace({kind_of(seam), seam.written.file, seam.written.span.begin, family(seam)}, steps.size());
    if (fresh) steps.push_back({kind_of(seam), {}, {}});
    steps[entry->second].seams.push_back(i);
  }
  return steps;
}

class Orderer {
 public:
  explicit Orderer(const Garment& garment) : garment_(garment), corners_(garment.pieces), waiting_(steps_of(garment)) {}

  std::vector<SewingStep> run() {
    take_all(SewingStep::Kind::Dart);
    take_all(SewingStep::Kind::Pleat);
    while (!waiting_.empty()) take(next());
    add_hems();
    add_buttons();
    return std::move(steps_);
  }

 private:
  void take(std::size_t i) {
    for (const int seam : waiting_[i].seams) {
      if (!garment_.seams[seam].open) corners_.sew(garment_.seams[seam]);
    }
    steps_.push_back(std::move(waiting_[i]));
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void take_all(SewingStep::Kind kind) {
    for (std::size_t i = 0; i < waiting_.size();) {
      if (waiting_[i].kind == kind) {
        take(i);
      } else {
        ++i;
      }
    }
  }

  int stated(const SewingStep& step) const {
    int first = std::numeric_limits<int>::max();
    for (const int seam : step.seams) first = std::min(first, garment_.seams[seam].step.value_or(first));
    return first;
  }

  // Whether each of its lines runs on through what is sewn already.
  bool ready(const SewingStep& step) const {
    return std::all_of(step.seams.begin(), step.seams.end(), [&](int seam) {
      return runs_on(garment_.seams[seam].first) && runs_on(garment_.seams[seam].second);
    });
  }
  bool runs_on(const Chain& chain) const {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (corners_.end(chain[i]) != corners_.start(chain[i + 1])) return false;
    }
    return true;
  }

  // Pockets and tucks are stitched while their piece still lies flat.
  bool is_upon(const SewingStep& step) const {
    return std::all_of(step.seams.begin(), step.seams.end(),
                       [&](int seam) { return is_sewn_upon(garment_.seams[seam], garment_.pieces); });
  }

  std::size_t next() const {
    const auto rank = [&](std::size_t i) {
      const SewingStep& step = waiting_[i];
      return std::tuple(stated(step), !ready(step), !is_upon(step), step.kind == SewingStep::Kind::Closure, i);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < waiting_.size(); ++i) best = rank(i) < rank(best) ? i : best;
    return best;
  }

  // Edges with an allowance that no seam takes, each with its copies.
  void add_hems() {
    std::set<std::pair<int, int>> taken;
    for (const Seam& seam : garment_.seams) {
      for (const Chain* chain : {&seam.first, &seam.second}) {
        for (const ChainLink& link : *chain) taken.insert({link.edge.piece, link.edge.edge});
      }
    }
    std::map<std::pair<std::string, std::string>, std::size_t> known;
    for (int p = 0; p < static_cast<int>(garment_.pieces.size()); ++p) {
      const Piece& piece = garment_.pieces[p];
      for (int e = 0; e < piece.edge_count(); ++e) {
        const PieceEdge& edge = piece.edge(e);
        if (edge.is_dart_leg || edge.folded_under || !(edge.allowance > 0) || taken.contains({p, e})) continue;
        const auto [entry, fresh] = known.try_emplace({piece.drawn_name, edge.name}, steps_.size());
        if (fresh) steps_.push_back({SewingStep::Kind::Hem, {}, {}});
        steps_[entry->second].edges.push_back({p, e});
      }
    }
  }

  void add_buttons() {
    const bool any = std::any_of(garment_.pieces.begin(), garment_.pieces.end(), [](const Piece& piece) {
      return std::any_of(piece.spots.begin(), piece.spots.end(),
                         [](const PointMark& mark) { return mark.kind != PointMark::Kind::Drill; });
    });
    if (any) steps_.push_back({SewingStep::Kind::Buttons, {}, {}});
  }

  const Garment& garment_;
  SewnCorners corners_;
  std::vector<SewingStep> waiting_, steps_;
};

}  // namespace

std::vector<SewingStep> sewing_order(const Garment& garment) {
  return Orderer(garment).run();
}

}  // namespace toile
