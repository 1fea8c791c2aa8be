#include "tests/garments/worn_garments.hpp"

#include <fmt/format.h>

#include "tests/garments/random_outline.hpp"

namespace toile::test {
namespace {

/// A form of some size that people have.
std::string form(Dice& dice) {
  const double waist = dice.uniform(0.56, 1.1);
  return fmt::format("body form = bodies.dress_form(waist: {}, hip: {}, bust: {}, height: {})\n", cm(waist),
                     cm(waist + dice.uniform(0.16, 0.3)), cm(waist + dice.uniform(0.14, 0.24)),
                     cm(dice.uniform(1.5, 1.85)));
}

std::string form_of_a_size(Dice& dice, const std::string& further) {
  static const std::vector<std::string> sizes{"6", "8", "10", "12", "14", "16", "18", "20", "22", "24"};
  return fmt::format("let m = sizing.women.all[{}]\nbody form = bodies.dress_form(m...{})\n",
                     dice.from(1, static_cast<int>(sizes.size())), further);
}

const char* held_or_placed(Dice& dice) {
  return dice.chance(0.25) ? " placed" : "";
}

const char* const end = "}\ndrape thing on form as worn\n";

}  // namespace

std::string skirt_of_gores(Dice& dice) {
  const int gores = dice.from(1, 7);
  const double length = dice.uniform(0.2, 1);
  std::string text = form(dice) + fmt::format("garment thing in cloth {{\n  let around = form.waist.girth * {:.4g}\n",
                                              dice.uniform(1, 1.2));
  const bool with_dart = dice.chance(0.3);
  text += fmt::format("  let w = around / {} + {}\n", gores, with_dart ? "2cm" : "0cm");
  const std::string flare = cm(dice.uniform(0, 1.2) / gores);
  text += fmt::format(R"(  piece g1 {{
    outline from (0cm, 0cm) {{
      waist = line to (w, 0cm)
      right = curve to (w + {0}, {1}) leaving -80deg
      hem   = line to (-{0}, {1})
      left  = curve to start arriving 80deg
    }}
{2}  }}
)",
                      flare, cm(-length), with_dart ? "    dart at 50% of waist { width 2cm, depth 9cm }\n" : "");
  std::string waist = "g1.waist";
  for (int i = 2; i <= gores; ++i) {
    text += fmt::format("  piece g{} = g1 with {{ ... }}\n", i);
    waist += fmt::format(" + g{}.waist", i);
  }
  for (int i = 1; i <= gores; ++i) text += fmt::format("  sew g{}.right to g{}.left\n", i, i % gores + 1);
  return text + fmt::format("  wear {} at form.waist{}\n", waist, held_or_placed(dice)) + end;
}

std::string skirt_with_a_ruffle(Dice& dice) {
  const double upper = dice.uniform(0.2, 0.5), lower = dice.uniform(0.1, 0.3), fullness = dice.uniform(1.2, 2);
  return form(dice) +
         fmt::format(R"(garment thing in cloth {{
  let w = form.hip.girth * {0:.4g}
  piece upper {{
    outline from (0cm, 0cm) {{
      waist = line to (w, 0cm)
      right = line to (w, {1})
      hem   = line to (0cm, {1})
      left  = line to start
    }}
  }}
  piece ruffle {{
    outline from (0cm, 0cm) {{
      head  = line to ({2:.4g} * w, 0cm)
      right = line to ({2:.4g} * w, {3})
      hem   = line to (0cm, {3})
      left  = line to start
    }}
  }}
  sew upper.left to upper.right
  sew ruffle.left to ruffle.right
  sew ruffle.head to upper.hem gather
  wear upper.waist at form.waist
)",
                     dice.uniform(1.02, 1.3), cm(-upper), fullness, cm(-lower)) +
         end;
}

std::string pleated_skirt(Dice& dice) {
  const int pleats = dice.from(2, 4);
  static const std::vector<std::string> kinds{"", "pressed left, ", "inverted, ", "box, width 5cm, "};
  return form(dice) +
         fmt::format(R"(garment thing in cloth {{
  let depth = {0}
  let w = form.waist.girth / 2 * {1:.4g}
  let step = w / {2}
  piece front {{
    outline from (0cm, 0cm) {{
      waist = line to (w + {2} * 4 * depth, 0cm)
      right = line to (w + {2} * 4 * depth, {3})
      hem   = line to (0cm, {3})
      left  = line to start
    }}
    for i in 1..{2} {{
      pleat at (i - 0.5) * (step + 4 * depth) of waist {{ {4}depth depth }}
    }}
  }}
  piece back {{
    outline from (0cm, 0cm) {{
      waist = line to (w, 0cm)
      right = line to (w, {3})
      hem   = line to (0cm, {3})
      left  = line to start
    }}
  }}
  sew front.right to back.left
  sew front.left to back.right
  wear front.waist + back.waist at form.waist
)",
                     cm(dice.uniform(0.01, 0.025)), dice.uniform(1.25, 1.5), pleats, cm(-dice.uniform(0.3, 0.7)),
                     dice.one_of(kinds)) +
         end;
}

std::string cape(Dice& dice) {
  const std::string ease = cm(dice.uniform(0.01, 0.1)), length = cm(dice.uniform(0.2, 1.1));
  const bool closed = dice.chance(0.6);
  return form(dice) +
         fmt::format(R"(garment thing in cloth {{
  piece half {{
    let r = (form.neck.girth + {}) / {:.4g}
    let out = r + {}
    let a = {:.4g}deg
    outline from (0cm, -r) {{
      neck  = arc to polar(r, a) radius r
      front = line to polar(out, a)
      hem   = arc to (0cm, -out) radius -out
      back  = line to start
    }}
    cut 2 mirrored
  }}
  sew half.back to half.back
{}  wear half.neck at form.neck{}
)",
                     ease, dice.uniform(5, 6.2), length, dice.uniform(20, 75),
                     closed ? "  sew half.front to half.front\n" : "", dice.chance(0.5) ? " placed" : "") +
         end;
}

std::string poncho(Dice& dice) {
  const Outline outline = random_outline(dice, dice.uniform(0.5, 1));
  const std::string hole =
      fmt::format("    hole neck from (0cm, inner) {{\n      rim = circle about (0cm, 0cm)\n    }}\n    grain {}\n",
                  dice.chance(0.5) ? "down" : "bias");
  return form(dice) +
         fmt::format(
             "garment thing in cloth {{\n  let inner = (form.neck.girth + {}) / (2 * pi)\n{}  wear p.neck.rim at "
             "form.neck{}\n",
             cm(dice.uniform(0, 0.2)), outline.piece("p", hole), held_or_placed(dice)) +
         end;
}

std::string trousers(Dice& dice) {
  return form(dice) +
         fmt::format(R"(let room = form.hip.girth + {0}
garment thing in cloth {{
  let block = blocks.trousers(form, hip: room, length: {1}, hem: {2})
  piece front = block.front
  piece back  = block.back
  sew front.hip + front.side to back.hip + back.side ease
  sew front.leg    to back.leg
  sew front.calf   to back.calf
  sew front.inseam to back.inseam
  sew front.crotch to front.crotch
  sew back.crotch  to back.crotch
  wear front.waist + back.waist at form.waist
  wear front.crotch.drawn + back.crotch.drawn at form.left_crotch placed
  wear front.crotch.mirrored + back.crotch.mirrored at form.right_crotch placed
)",
                     cm(dice.uniform(0.04, 0.15)), cm(dice.uniform(0.75, 1)), cm(dice.uniform(0.38, 0.6))) +
         end;
}

std::string blouse(Dice& dice) {
  const double fullness = dice.uniform(0.01, 0.05);
  const bool sleeveless = dice.chance(0.3);
  std::string text = form_of_a_size(dice, ", armhole: 0.39 * m.bust, upper_arm: 0.3 * m.bust, arm_angle: 40deg") +
                     R"(garment thing in cloth {
  let block = blocks.bodice(form)
  piece front = block.front
  piece back = block.back
  sew front.side to back.side
  sew front.shoulder to back.shoulder
  sew back.centre to back.centre
  wear front.neck + back.neck at form.neck placed
)";
  if (sleeveless) return text + end;
  return text +
         fmt::format(R"(
  piece sleeve = blocks.set_in_sleeve(block.front_scye, block.back_scye, block.cap_height, length: {}, ease: {})
  sew sleeve.front_cap to front.armhole ease
  sew sleeve.back_cap to back.armhole ease
  sew sleeve.front_seam to sleeve.back_seam
  wear sleeve.front_cap.mirrored + sleeve.back_cap.mirrored at form.left_armhole placed
  wear sleeve.front_cap.drawn + sleeve.back_cap.drawn at form.right_armhole placed
)",
                     cm(dice.uniform(0.22, 0.58)), cm(fullness)) +
         end;
}

std::string t_shirt(Dice& dice) {
  return form_of_a_size(dice, ", armhole: 0.42 * m.bust, arm_angle: 45deg") +
         fmt::format(R"(garment thing in cloth {{
  let width      = (m.bust + {0}) / 4
  let neck_width = m.neck / 5 + 0.5cm
  let low        = form.waist.level - form.neck.level - 1.5cm - {1}
  let scye       = m.bust / 8 + 10cm
  let tip        = (neck_width, 0cm) + polar(m.shoulder, -20deg)
  let chest      = (tip.x - 0.5cm, -0.6 * scye)
  piece back {{
    let depth = 2cm
    outline from (0cm, -depth) {{
      neck     = curve to (neck_width, 0cm) leaving 0deg arriving 75deg
      shoulder = line to tip
      armhole  = curve to (width, -scye) through chest leaving -95deg arriving -5deg
      side     = line to (width + 1cm, low)
      hem      = line to (0cm, low)
      centre   = line to start
    }}
    fold  centre
  }}
  piece front = back with {{
    let depth = m.neck / 5 + 1.5cm
  }}
  piece sleeve {{
    let cap = scye / 2.2
    solve half in 8cm..40cm so 2 * length(front_cap) = length(front.armhole) + length(back.armhole)
    outline from (-half, 0cm) {{
      back_cap   = curve to (0cm, cap) leaving 10deg arriving 0deg
      front_cap  = curve to (half, 0cm) leaving 0deg arriving -10deg
      front_seam = line to (half - 1.5cm, cap - {2})
      hem        = line to (1.5cm - half, cap - {2})
      back_seam  = line to start
    }}
    cut   2 mirrored
  }}
  let neckline = 2 * (length(front.neck) + length(back.neck))
  piece neckband = blocks.waistband({3:.4g} * neckline, depth: 2.5cm)
  sew front.shoulder to back.shoulder
  sew front.side to back.side
  sew sleeve.front_seam to sleeve.back_seam
  sew sleeve.front_cap + sleeve.back_cap to front.armhole + back.armhole ease
  sew neckband.left to neckband.right
  sew neckband.foot to back.neck + front.neck stretch
  wear neckband.head at form.neck placed
  wear sleeve.front_cap.mirrored + sleeve.back_cap.mirrored at form.left_armhole placed
  wear sleeve.front_cap.drawn + sleeve.back_cap.drawn at form.right_armhole placed
)",
                     cm(dice.uniform(0.02, 0.25)), cm(dice.uniform(0.05, 0.5)), cm(dice.uniform(0.14, 0.6)),
                     dice.uniform(0.905, 1)) +
         end;
}

}  // namespace toile::test
