// `until within`: a pattern draped on its form again and again, and changed by what it misses the form by.
#include <fmt/format.h>

#include <cmath>

#include "runtime/develop/mirror.hpp"
#include "runtime/develop/pattern_step.hpp"
#include "runtime/driver/workroom.hpp"
#include "runtime/fabric/law.hpp"

namespace toile {
namespace {

constexpr int most_drapes = 12;
constexpr double caution = 1e-3;    // what a change of the pattern costs, beside what it gains
constexpr double shortening = 0.4;  // after a change that did no good, of the same change
constexpr int most_shortenings = 3;
constexpr double worth_a_drape = 0.97;  // of the miss, that a change has to leave less than

/// The best pattern so far, where a change leads from it, and how the changes have fared.
struct Search {
  Developed best;
  double root = 1e300;    // [m] root of the mean square of what it misses
  double within = 1e300;  // [m] 95 % of it come as near
  PatternStep step;
  double fraction = 1;
  int shortenings = 0;
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
    PatternStep step;
    const auto at_rest = [&](const RestState& rest, const FormDistance& misses) {
      step = pattern_step(developed.development.plane, developed.development.flat.uv, developed.on_form.made->cloth,
                          rest, misses, caution);
    };
    const std::optional<Draped> draped = drape_on_form(draping, developed, form, at_rest);
    if (!draped) return;
    const double root = missed(draped->made->cloth, *draped->form);
    listener_->noted(fmt::format("{}: drape {}: 95 % within {:.2f} mm of the form", developed.drawn->garment.name,
                                 drapes, 1000 * draped->form->distance.p95));
    if (root < search.root) {
      search = {developed, root, draped->form->distance.p95, std::move(step), 1, 0};
    } else {
      search.fraction *= shortening;
      ++search.shortenings;
    }
    search.best.drapes = drapes;
    const bool reached = search.within <= *command.within;
    const bool no_better = search.step.change.empty() || search.step.left > worth_a_drape;
    if (reached || no_better || search.shortenings > most_shortenings) break;
    std::vector<Vec2> change = mirror.evened(search.step.change);
    for (Vec2& each : change) each = search.fraction * each;
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
      search.step.left > worth_a_drape
          ? "no change of the pattern brings the cloth nearer: hold or sew it where it stands off, or ask for less"
          : "cloth that is draped cannot follow hollows: hold or sew it there, or ask for less"));
}

}  // namespace toile
