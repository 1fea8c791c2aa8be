// `until within`: a pattern draped on its form again and again, and changed by what it misses the form by.
#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "runtime/develop/mirror.hpp"
#include "runtime/develop/pattern_step.hpp"
#include "runtime/driver/result.hpp"
#include "runtime/driver/workroom.hpp"
#include "runtime/fabric/law.hpp"

namespace toile {
namespace {

constexpr int most_drapes = 12;
/// What a change of the pattern costs, beside what it gains: where cloth is about to buckle, little of it moves much,
/// and only small changes do what they promise.
constexpr std::array<double, 4> cautions{1e-3, 3e-2, 1, 30};
constexpr double worth_a_drape = 0.97;  // of the miss, that a change has to leave less than
constexpr double kept_promise = 0.5;    // of the gain foretold, from which the next change may be bolder

constexpr double round_about = 0.03;   // [m] over which a form is looked at for hollows
constexpr double hollowness = 0.01;    // of that, by which it rises about a place
constexpr double leaning_back = 0.05;  // how much a form's normal looks down where it draws back below

/// Where cloth lies farthest from its form, and how the form is there.
struct Farthest {
  std::string piece;
  Vec2 place;                             // where it is drawn
  double off = 0;                         // [m]
  bool outside = false, touches = false;  // the form; the body
  bool hollow = false, leans_back = false;
  double untouched = 0;  // of the cloth that is farther off than asked, the share that touches nothing

  std::string why() const {
    if (!outside) return "it lies inside the form, with nothing to hold it off the body";
    if (hollow) return "the form is hollow there, which cloth spans";
    if (leans_back) return "the form draws back below there, and nothing draws the cloth in";
    return touches ? "it is carried there, but not as near as asked" : "it hangs free there";
  }
};

/// The form rises about a hollow place: by this, over the distance.
bool is_hollow(const std::vector<Vec3>& form, Vec3 at, Vec3 out) {
  double rise = 0, away = 0;
  for (const Vec3 p : form) {
    const double near = distance(p, at);
    if (near > round_about) continue;
    rise += dot(p - at, out);
    away += near;
  }
  return rise > hollowness * away;
}

Farthest farthest_from(const Draped& draped, const std::vector<Vec3>& form, const std::vector<Vec2>& chart,
                       double within) {
  const MadeGarment& made = *draped.made;
  const std::vector<double>& off = draped.form->of_vertex;
  Farthest found;
  std::size_t worst = 0;
  double beyond = 0;
  for (std::size_t v = 0; v < off.size(); ++v) {
    if (off[v] > off[worst]) worst = v;
    if (off[v] <= within) continue;
    beyond += made.cloth.area_of_vertex[v];
    if (!(draped.drape.pressure[v] > 0)) found.untouched += made.cloth.area_of_vertex[v];
  }
  if (beyond > 0) found.untouched /= beyond;
  const auto point = static_cast<std::size_t>(made.mesh.s.p_of_s[worst].front());
  found.piece = made.garment.pieces[static_cast<std::size_t>(made.mesh.p.piece_of_point[point])].drawn_name;
  found.place = chart[point];
  found.off = off[worst];
  found.touches = draped.drape.pressure[worst] > 0;
  const auto surface = draped.body->nearest(form[worst], 1);
  if (!surface) return found;
  found.outside = dot(draped.drape.positions[worst] - form[worst], surface->normal) > 0;
  found.hollow = is_hollow(form, form[worst], surface->normal);
  found.leans_back = surface->normal.z < -leaning_back;
  return found;
}

/// The best pattern so far, the changes that lead on from it, and how the changes have fared.
struct Search {
  Developed best;
  double root = 1e300;             // [m] root of the mean square of what it misses
  double within = 1e300;           // [m] 95 % of it come as near
  std::vector<PatternStep> steps;  // by caution
  Farthest farthest;               // of its cloth
  std::size_t caution = 1;         // of the change tried; bolder once promises are kept

  const PatternStep* step() const {
    const bool some = caution < steps.size() && !steps[caution].change.empty() && steps[caution].left < worth_a_drape;
    return some ? &steps[caution] : nullptr;
  }
};

}  // namespace

void Workroom::correct(const DevelopCommand& command, const Target& form, Developed& developed) {
  DrapeCommand draping;
  draping.garment = command.garment;
  draping.body = command.body;
  const FabricLaw law = make_law(developed.drawn->garment.fabric);
  const auto strained = [](const Developed& made) { return result_of(made).at("strain.worst.p95"); };
  const double uncorrected = strained(developed);
  const Mirror mirror(developed.drawn->garment, developed.drawn->mesh.p);
  Search search;
  for (int drapes = 1; drapes <= most_drapes; ++drapes) {
    std::vector<PatternStep> steps;
    const auto at_rest = [&](const RestState& rest, const FormDistance& misses) {
      for (const double caution : cautions) {
        steps.push_back(pattern_step(developed.development.plane, developed.development.flat.uv,
                                     developed.on_form.made->cloth, rest, misses, caution));
      }
    };
    const std::optional<Draped> draped = drape_on_form(draping, developed, form, at_rest);
    if (!draped) return;
    const double root = missed(draped->made->cloth, *draped->form), p95 = draped->form->distance.p95;
    listener_->noted(fmt::format("{}: drape {}: 95 % within {:.2f} mm of the form", developed.drawn->garment.name,
                                 drapes, 1000 * p95));
    const bool reached = p95 <= *command.within;
    if ((root < search.root && (!steps.empty() || drapes == 1)) || reached) {
      const PatternStep* tried = search.step();
      const bool kept = tried != nullptr && root < (1 - kept_promise * (1 - tried->left)) * search.root;
      search = {developed,
                root,
                p95,
                std::move(steps),
                farthest_from(*draped, form.positions, form.chart, *command.within),
                kept && search.caution > 0 ? search.caution - 1 : search.caution};
    } else {
      ++search.caution;
    }
    search.best.drapes = drapes;
    if (reached || search.step() == nullptr) break;
    std::vector<Vec2> change = mirror.evened(search.step()->change);
    developed = search.best;
    developed.development =
        with_pattern(developed.drawn->mesh, law, search.best.development,
                     changed_pattern(search.best.development.plane, search.best.development.flat.uv, change));
    lay_on_form(developed);
  }
  developed = std::move(search.best);
  if (search.within <= *command.within) return;
  outcome_.unsettled = true;
  const Farthest& far = search.farthest;
  diagnose(at_place(
      Severity::Warning, "W0514", command.written,
      fmt::format("no pattern was found that {} takes this form by: after {} drapes 95 % of the cloth come within "
                  "{:.2f} mm of it, not {:.2f} mm. Farthest off, by {:.1f} mm, is piece `{}` where it is drawn at "
                  "({:.1f}cm, {:.1f}cm): {}",
                  developed.drawn->garment.name, developed.drapes, 1000 * search.within, 1000 * *command.within,
                  1000 * far.off, far.piece, 100 * far.place.x, 100 * far.place.y, far.why()),
      "developed here",
      fmt::format(
          "{:.0f} % of the cloth that is farther off than asked touch nothing{}; as cut now 95 % of it would be "
          "strained by {:.1f} % at most on the form, uncorrected by {:.1f} %. Hold or sew it there, or ask for "
          "less",
          100 * far.untouched, search.step() == nullptr ? ", and no small change of the pattern brings it nearer" : "",
          100 * strained(developed), 100 * uncorrected)));
}

}  // namespace toile
