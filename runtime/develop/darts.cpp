#include "runtime/develop/darts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/develop/develop.hpp"
#include "runtime/develop/flattening.hpp"
#include "runtime/drape/spread.hpp"
#include "runtime/mesh/index.hpp"

namespace toile {
namespace {

constexpr double margin = 0.95;       // of the strain asked for: in the garment the piece is meshed a little otherwise
constexpr int most_darts = 6;         // in a piece as drawn
constexpr int trial_triangles = 400;  // of a piece while places are tried
constexpr double worth_a_dart = 0.9;  // of the energy, that a dart has to leave less than
constexpr int places_on_an_edge = 6, tips_across = 5;
constexpr double least_room = 0.012;   // [m] from a mouth to a corner or another mouth, from a tip to the outline
constexpr double longest_reach = 0.6;  // of the way across the piece, that a dart goes
constexpr int most_trials = 4;
constexpr int most_refinements = 3;     // each by half the step
constexpr double least_opening = 2e-4;  // [m] between the sides of a dart, but at its tip

double distance_to(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double t = std::clamp(dot(p - from, way) / std::max(dot(way, way), 1e-12), 0.0, 1.0);
  return distance(p, from + t * way);
}

/// One piece of a garment by itself.
class PieceWithDarts {
 public:
  PieceWithDarts(const DraftGarment& garment, std::size_t number, const Body& body, int triangles, const Job& job)
      : body_(body), job_(job) {
    alone_.name = garment.name;
    alone_.pieces = {garment.pieces[number]};
    alone_.fabric = garment.fabric;
    alone_.drawn_on = garment.drawn_on;
    alone_.written = garment.written;
    drawn_ = static_cast<int>(alone_.pieces.front().darts.size());
    std::vector<Diagnostic> found;
    const Garment made = make_garment(alone_, found);
    trial_.target_edge = edge_for_triangles(made, trial_triangles);
    whole_.target_edge = edge_for_triangles(made, triangles);
    find_places();
  }

  /// Adds darts until the strain is reached or no more do any good.
  void add_darts(double strain) {
    std::optional<ResidualStrain> now = tried(darts(), whole_);
    while (now && now->p95 > strain && added() < most_darts && !job_.is_cancelled()) {
      if (!add_best()) break;
      now = tried(darts(), whole_);
    }
    if (now && now->p95 <= strain) leave_out_needless(strain);
  }

  std::vector<ProposedDart> proposed() { return without_each_from(static_cast<std::size_t>(drawn_)); }

  std::vector<ProposedDart> without_each_from(std::size_t first) {
    std::vector<ProposedDart> all;
    if (first >= darts().size()) return all;
    const ResidualStrain with = tried(darts(), whole_, false).value_or(ResidualStrain{});
    for (std::size_t i = first; i < darts().size() && !job_.is_cancelled(); ++i) {
      std::vector<DraftDart> others = darts();
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      all.push_back(
          {alone_.pieces.front().name, darts()[i], tried(others, whole_, false).value_or(ResidualStrain{}), with});
    }
    return all;
  }

  std::vector<TriedDart> tried_each() {
    std::vector<TriedDart> all;
    const std::vector<DraftDart> tries = piece().tried;
    if (tries.empty()) return all;
    const std::optional<Trial> without = trial(darts(), whole_);
    for (const DraftDart& dart : tries) {
      std::vector<DraftDart> with = darts();
      with.push_back(dart);
      const std::optional<Trial> cut = trial(with, whole_);
      if (without && cut) {
        all.push_back({piece().name, dart, without->left, cut->left, cut->last_opening, cut->last_opens});
      }
    }
    return all;
  }
  int developments() const { return developments_; }

 private:
  struct Place {
    std::string edge;
    double at = 0;
    Vec2 tip;
  };

  std::vector<DraftDart>& darts() { return alone_.pieces.front().darts; }
  int added() { return static_cast<int>(darts().size()) - drawn_; }
  const DraftPiece& piece() const { return alone_.pieces.front(); }

  struct Trial {
    ResidualStrain left;
    bool all_open = true, last_opens = true;  // its darts all along; the last one at its mouth
    double last_opening = 0;                  // [m] of that
  };

  /// What is left with these darts; nothing where they cannot be cut or do not open.
  std::optional<ResidualStrain> tried(const std::vector<DraftDart>& with, const PMeshOptions& options,
                                      bool must_open = true) {
    const std::optional<Trial> found = trial(with, options);
    return found && (found->all_open || !must_open) ? std::optional(found->left) : std::nullopt;
  }

  std::optional<Trial> trial(const std::vector<DraftDart>& with, const PMeshOptions& options) {
    DraftGarment draft = alone_;
    draft.pieces.front().darts = with;
    std::vector<Diagnostic> found;
    const Garment garment = make_garment(draft, found);
    if (std::any_of(found.begin(), found.end(), [](const Diagnostic& d) { return d.severity == Severity::Error; })) {
      return std::nullopt;
    }
    const SewnMesh mesh = sew(garment, options);
    Target target = find_target(garment, mesh, body_);
    if (!target.troubles.empty()) return std::nullopt;
    ++developments_;
    FlattenOptions flattening;
    flattening.tolerance = 1e-4;
    const Development development = develop(garment, mesh, std::move(target), flattening, job_);
    Trial left{left_in(development)};
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
      for (const Dart& dart : garment.pieces[p].darts) {
        const std::vector<double> apart = openings(mesh, p, dart, development);
        left.all_open = left.all_open && *std::min_element(apart.begin(), apart.end()) >= least_opening;
        if (with.empty() || dart.name != with.back().name) continue;
        left.last_opens = left.last_opens && apart.front() > 0;
        left.last_opening = opened_dart(mesh.p, static_cast<int>(p), dart, development).width;
      }
    }
    return left;
  }

  static ResidualStrain left_in(const Development& development) {
    const Flattened& flat = development.flat;
    std::vector<double> warp, weft, shear, areas;
    for (std::size_t t = 0; t < flat.strains.size(); ++t) {
      warp.push_back(flat.strains[t].warp);
      weft.push_back(flat.strains[t].weft);
      shear.push_back(flat.strains[t].shear);
      const std::array<int, 3>& corners = development.plane.triangles[t];
      const auto at = [&](std::size_t i) { return flat.uv[index(corners[i])]; };
      areas.push_back(0.5 * turn({at(0), at(1), at(2)}));
    }
    return {flat.energy.warp + flat.energy.weft + flat.energy.shear, worst_strain_p95(warp, weft, shear, areas)};
  }

  /// [m] How far the sides of a dart lie apart, from its mouth to before its tip; negative where they lap over. One leg
  /// is walked to the tip and the other from it, the cloth on the left: the other leg of an open one lies to the right.
  static std::vector<double> openings(const SewnMesh& mesh, std::size_t piece, const Dart& dart,
                                      const Development& development) {
    const auto at = [&](int leg, std::size_t from_mouth, bool inwards) {
      const std::vector<int>& nodes = mesh.p.edge_nodes[piece][index(leg)].points;
      return development.points[index(nodes[inwards ? from_mouth : nodes.size() - 1 - from_mouth])];
    };
    const int first = std::min(dart.left_leg, dart.right_leg), second = std::max(dart.left_leg, dart.right_leg);
    const std::size_t nodes = mesh.p.edge_nodes[piece][index(first)].points.size();
    std::vector<double> apart;
    for (std::size_t i = 0; i + 1 < nodes; ++i) {
      const Vec2 in = at(first, i, true), way = at(first, i + 1, true) - in;
      apart.push_back(-cross(way, at(second, i, false) - in) / norm(way));
    }
    return apart;
  }

  /// Mouths along the edges, and tips inside.
  void find_places() {
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
    for (const DraftEdge& edge : piece().outline) {
      for (const double s : edge.curve.divide(1e-3, 0.02)) {
        const Vec2 p = edge.curve.at(s);
        outline_.push_back(p);
        if (piece().fold != edge.name) rim_.push_back(p);
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
      const double length = edge.curve.length();
      if (piece().fold == edge.name || length < 3 * least_room) continue;
      for (int i = 0; i < places_on_an_edge; ++i) {
        const double at = length * (i + 0.5) / places_on_an_edge;
        if (std::min(at, length - at) > least_room) mouths_.push_back({edge.name, at, {}});
      }
    }
    step_ = std::max(high.x - low.x, high.y - low.y) / tips_across;
    for (double x = low.x + step_ / 2; x < high.x; x += step_) {
      for (double y = low.y + step_ / 2; y < high.y; y += step_) {
        if (inside({x, y})) tips_.push_back({x, y});
      }
    }
  }

  bool inside(Vec2 p) const {
    bool in = false;
    for (std::size_t i = 0, j = outline_.size() - 1; i < outline_.size(); j = i++) {
      const Vec2 a = outline_[i], b = outline_[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) in = !in;
    }
    return in && std::none_of(rim_.begin(), rim_.end(), [&](Vec2 a) { return distance(p, a) < least_room; });
  }

  const Curve& edge(const std::string& name) const {
    return std::find_if(piece().outline.begin(), piece().outline.end(),
                        [&](const DraftEdge& e) { return e.name == name; })
        ->curve;
  }

  /// From the mouth through the tip to the far side of the piece, or to its fold.
  double across(Vec2 mouth, Vec2 tip) const {
    const Vec2 way = (tip - mouth) / distance(mouth, tip);
    double nearest = 1e300;
    for (std::size_t i = 0, j = outline_.size() - 1; i < outline_.size(); j = i++) {
      const Vec2 side = outline_[i] - outline_[j];
      const double facing = cross(way, side);
      if (std::abs(facing) < 1e-12) continue;
      const double far = cross(outline_[j] - mouth, side) / facing, along = cross(outline_[j] - mouth, way) / facing;
      if (along >= 0 && along <= 1 && far > least_room) nearest = std::min(nearest, far);
    }
    return nearest;
  }

  std::optional<DraftDart> dart_at(const Place& place) const {
    const Curve& curve = edge(place.edge);
    if (!(place.at > least_room && place.at < curve.length() - least_room)) return std::nullopt;
    const Vec2 mouth = curve.at(place.at);
    if (distance(mouth, place.tip) < 2 * least_room || !inside(place.tip)) return std::nullopt;
    if (distance(mouth, place.tip) > longest_reach * across(mouth, place.tip)) return std::nullopt;
    for (const DraftDart& other : piece().darts) {
      if (other.tip && distance_to(place.tip, edge(other.edge).at(other.at), *other.tip) < 2 * least_room) {
        return std::nullopt;
      }
      if (other.edge == place.edge && std::abs(other.at - place.at) < 2 * least_room) return std::nullopt;
    }
    DraftDart dart;
    dart.name = fmt::format("dart{}", piece().darts.size() + 1);
    dart.edge = place.edge;
    dart.at = place.at;
    dart.tip = place.tip;
    dart.depth = distance(mouth, place.tip);
    dart.width = slit_width(dart.depth);
    dart.written = piece().written;
    return dart;
  }

  /// The energy with one more dart; none where it cannot be.
  std::optional<double> energy_with(const Place& place) {
    const std::optional<DraftDart> dart = dart_at(place);
    if (!dart || job_.is_cancelled()) return std::nullopt;
    std::vector<DraftDart> with = darts();
    with.push_back(*dart);
    const std::optional<ResidualStrain> left = tried(with, trial_);
    return left ? std::optional(left->energy) : std::nullopt;
  }

  /// Of what does best on the coarse mesh the first that also opens on the fine one.
  bool add_best() {
    std::vector<Place> mouths = mouths_;
    for (int trial = 0; trial < most_trials; ++trial) {
      const std::optional<Place> best = best_place(mouths);
      if (!best) return false;
      std::vector<DraftDart> with = darts();
      with.push_back(*dart_at(*best));
      if (tried(with, whole_)) {
        darts() = with;
        return true;
      }
      std::erase_if(mouths, [&](const Place& mouth) {
        return mouth.edge == best->edge && std::abs(mouth.at - best->at) < 2 * least_room;
      });
    }
    return false;
  }

  std::optional<Place> best_place(const std::vector<Place>& mouths) {
    const std::optional<ResidualStrain> before = tried(darts(), trial_);
    if (!before) return std::nullopt;
    Place best;
    double least = worth_a_dart * before->energy;
    const auto consider = [&](const Place& place) {
      const std::optional<double> energy = energy_with(place);
      if (!energy || *energy >= least) return false;
      least = *energy;
      best = place;
      return true;
    };
    for (Place place : mouths) {
      for (const Vec2 tip : tips_) {
        place.tip = tip;
        consider(place);
      }
    }
    if (best.edge.empty()) return std::nullopt;
    double step = step_ / 2;
    for (int round = 0; round < most_refinements; ++round, step /= 2) {
      for (const Vec2 way : {Vec2{step, 0}, Vec2{-step, 0}, Vec2{0, step}, Vec2{0, -step}}) {
        consider({best.edge, best.at, best.tip + way});
      }
      for (const double way : {step, -step}) consider({best.edge, best.at + way, best.tip});
    }
    return best;
  }

  void leave_out_needless(double strain) {
    for (auto i = static_cast<std::size_t>(drawn_); i < darts().size() && added() > 1;) {
      std::vector<DraftDart> others = darts();
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const std::optional<ResidualStrain> left = tried(others, whole_);
      if (left && left->p95 <= strain) {
        darts() = others;
      } else {
        ++i;
      }
    }
  }

  const Body& body_;
  const Job& job_;
  DraftGarment alone_;
  int drawn_ = 0;  // darts of the script's own
  PMeshOptions trial_, whole_;
  std::vector<Vec2> outline_, rim_, tips_;  // the rim is the outline but for the fold
  std::vector<Place> mouths_;
  double step_ = 0;  // [m] between tips
  int developments_ = 0;
};

}  // namespace

double worst_strain_p95(const std::vector<double>& warp, const std::vector<double>& weft,
                        const std::vector<double>& shear, const std::vector<double>& areas) {
  std::vector<double> worst;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    worst.push_back(std::max({std::abs(warp[t]), std::abs(weft[t]), std::abs(shear[t])}));
  }
  return spread(worst, areas).p95;
}

std::vector<ProposedDart> without_each_dart(const DraftGarment& draft, const Body& body, int triangles,
                                            const Job& job) {
  std::vector<ProposedDart> all;
  for (std::size_t p = 0; p < draft.pieces.size(); ++p) {
    for (ProposedDart& dart : PieceWithDarts(draft, p, body, triangles, job).without_each_from(0)) {
      all.push_back(std::move(dart));
    }
  }
  return all;
}

std::vector<TriedDart> try_darts(const DraftGarment& draft, const Body& body, int triangles, const Job& job) {
  std::vector<TriedDart> all;
  for (std::size_t p = 0; p < draft.pieces.size(); ++p) {
    for (TriedDart& dart : PieceWithDarts(draft, p, body, triangles, job).tried_each()) all.push_back(std::move(dart));
  }
  return all;
}

DartProposal propose_darts(const DraftGarment& draft, const Body& body, double strain, int triangles, const Job& job) {
  DartProposal proposal;
  proposal.draft = draft;
  for (std::size_t p = 0; p < draft.pieces.size(); ++p) {
    PieceWithDarts piece(draft, p, body, triangles, job);
    piece.add_darts(margin * strain);
    for (ProposedDart& dart : piece.proposed()) {
      proposal.draft.pieces[p].darts.push_back(dart.dart);
      proposal.darts.push_back(std::move(dart));
    }
    proposal.developments += piece.developments();
  }
  return proposal;
}

}  // namespace toile
