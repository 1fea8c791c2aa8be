// `until within`: a pattern draped on its form again and again, and changed by what it misses the form by.
#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "runtime/develop/mirror.hpp"
#include "runtime/develop/pattern_step.hpp"
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

/// The best pattern so far, the changes that lead on from it, and how the changes have fared.
struct Search {
  Developed best;
  double root = 1e300;             // [m] root of the mean square of what it misses
  double within = 1e300;           // [m] 95 % of it come as near
  std::vector<PatternStep> steps;  // by caution
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
      search = {developed, root, p95, std::move(steps),
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
  diagnose(at_place(
      Severity::Warning, "W0514", command.written,
      fmt::format("no pattern was found that {} takes this form by: after {} drapes 95 % of the cloth come within "
                  "{:.2f} mm of it, not {:.2f} mm",
                  developed.drawn->garment.name, developed.drapes, 1000 * search.within, 1000 * *command.within),
      "developed here",
      search.step() == nullptr
          ? "no change of the pattern brings the cloth nearer: hold or sew it where it stands off, or ask for less"
          : "cloth that is draped cannot follow hollows: hold or sew it there, or ask for less"));
}

}  // namespace toile
