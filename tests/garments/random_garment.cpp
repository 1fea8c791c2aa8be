#include "tests/garments/random_garment.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "tests/garments/dice.hpp"
#include "tests/garments/random_outline.hpp"
#include "tests/garments/worn_garments.hpp"

namespace toile::test {
namespace {

constexpr double least_scale = 0.025, greatest_scale = 60;  // edges of 0.2 to 0.8 m become 5 mm and 50 m

/// Of things that no figure wears: mostly as large as garments, now and then as a doll's or a tent.
double scale(Dice& dice) {
  return dice.chance(0.7) ? dice.uniform(0.5, 1.5) : dice.scaled(least_scale, greatest_scale);
}

/// A definition `body stand = …` that goes with a cloth of so many metres.
std::string stand(Dice& dice, double size) {
  const double height = size + dice.uniform(0.5, 1.5);
  switch (dice.from(0, 5)) {
    case 0:
      return fmt::format("sphere(radius: {}, height: {})", cm(size * dice.uniform(0.2, 0.7)), cm(height));
    case 1:
      return fmt::format("cylinder(radius: {}, length: {}, height: {}, upright: true)",
                         cm(size * dice.uniform(0.2, 0.6)), cm(size * dice.uniform(0.5, 1.2)), cm(height));
    case 2:
      return fmt::format("cylinder(radius: {}, length: {}, height: {}, upright: false)",
                         cm(size * dice.uniform(0.1, 0.5)), cm(size * dice.uniform(1.5, 2.5)), cm(height));
    case 3:
      return fmt::format("disc(radius: {}, thickness: {}, height: {})", cm(size * dice.uniform(0.3, 0.8)),
                         cm(size * dice.uniform(0.02, 0.1)), cm(height));
    case 4:
      return fmt::format("box(width: {}, depth: {}, tall: {}, height: {})", cm(size * dice.uniform(0.4, 1.2)),
                         cm(size * dice.uniform(0.4, 1.2)), cm(size * dice.uniform(0.2, 1)), cm(height));
    default:
      return "plane(height: 0cm)";
  }
}

std::string cloth_on_a_body(Dice& dice) {
  const double size = scale(dice) * dice.uniform(0.2, 0.6);
  const Outline outline = random_outline(dice, size);
  std::string text = fmt::format("body stand = {}\n", stand(dice, size));
  text += fmt::format("garment thing in cloth {{\n{}}}\n", outline.piece("sheet", outline.random_dart(dice)));
  return text + "drape thing on stand as worn\n";
}

std::string floating_cloth(Dice& dice) {
  const Outline outline = random_outline(dice, scale(dice) * dice.uniform(0.2, 0.6));
  return fmt::format("garment thing in cloth {{\n{}}}\ndrape thing as worn\n",
                     outline.piece("sheet", outline.random_dart(dice)));
}

/// Two alike, sewn to each other around, with an opening or without.
std::string bag(Dice& dice) {
  const double size = scale(dice) * dice.uniform(0.1, 0.4);
  const Outline outline = random_outline(dice, size);
  std::string text = fmt::format("garment thing in cloth {{\n{}", outline.piece("side", "    cut 2 mirrored\n"));
  const int open = dice.chance(0.5) ? dice.from(0, outline.count() - 1) : -1;
  for (int i = 0; i < outline.count(); ++i) {
    if (i != open) text += fmt::format("  sew side.e{0} to side.e{0}\n", i);
  }
  text += "}\n";
  if (dice.chance(0.5)) return text + "drape thing as worn\n";
  return text + fmt::format("body stand = {}\ndrape thing on stand as worn\n", stand(dice, size));
}

/// Pieces sewn to each other edge by edge as they come, shorter edges to longer ones.
std::string patchwork(Dice& dice) {
  const double size = scale(dice) * dice.uniform(0.1, 0.3);
  std::vector<Outline> pieces{random_outline(dice, size)};
  std::vector<std::pair<int, int>> free;
  for (int e = 0; e < pieces[0].count(); ++e) free.emplace_back(0, e);
  std::string seams;
  for (int p = 1, count = dice.from(2, 5); p < count; ++p) {
    const auto at = static_cast<std::ptrdiff_t>(dice.from(0, static_cast<int>(free.size()) - 1));
    const auto [other, edge] = free[static_cast<std::size_t>(at)];
    free.erase(free.begin() + at);
    Outline next = random_outline(dice, size);
    int own = 0;  // the longest: nothing grows beyond what it is sewn to
    for (int e = 1; e < next.count(); ++e) own = next.length(e) > next.length(own) ? e : own;
    const double wanted = pieces[static_cast<std::size_t>(other)].length(edge) * dice.uniform(0.75, 1.35);
    next = next.scaled(wanted / next.length(own));
    for (int e = 0; e < next.count(); ++e) {
      if (e != own) free.emplace_back(p, e);
    }
    pieces.push_back(next);
    seams += fmt::format("  sew p{}.e{} to p{}.e{} gather\n", other, edge, p, own);
  }
  std::string text = "garment thing in cloth {\n";
  for (std::size_t p = 0; p < pieces.size(); ++p) text += pieces[p].piece(fmt::format("p{}", p), "");
  text += seams + "}\n";
  if (dice.chance(0.5)) return text + "drape thing as worn\n";
  return text + fmt::format("body stand = {}\ndrape thing on stand as worn\n", stand(dice, size));
}

std::string prism(Dice& dice) {
  const int corners = dice.from(3, 8);
  const double side = scale(dice) * dice.uniform(0.05, 0.3), tall = side * dice.uniform(0.4, 3);
  std::string text = fmt::format(R"(
piece floor_of(corners, side) {{
  let r = side / (2 * sin(180deg / corners))
  outline from (r, 0cm) {{
    for i in 1..corners {{
      edge = line to polar(r, i * 360deg / corners)
    }}
  }}
}}
piece wall_of(side, tall) {{
  outline from (0cm, 0cm) {{
    e0 = line to (side, 0cm)
    e1 = line to (side, tall)
    e2 = line to (0cm, tall)
    e3 = line to start
  }}
}}
garment thing in cloth {{
  piece top    = floor_of({0}, {1})
  piece bottom = floor_of({0}, {1})
  for i in 1..{0} {{
    piece wall = wall_of({1}, {2})
  }}
  for i in 1..{0} {{
    let next = if i == {0} then 1 else i + 1
    sew wall[i].e1 to wall[next].e3
    sew wall[i].e2 to top.edge[i]
    sew wall[i].e0 to bottom.edge[{0} + 1 - i]
  }}
}}
)",
                                 corners, cm(side), cm(tall));
  if (dice.chance(0.6)) return text + "drape thing as worn\n";
  return text + fmt::format("body stand = {}\ndrape thing on stand as worn\n", stand(dice, side));
}

/// Round a post, held at its top or only put there.
std::string sleeve_on_a_post(Dice& dice) {
  const double radius = scale(dice) * dice.uniform(0.03, 0.2), long_side = radius * dice.uniform(1, 8);
  const double around = 2 * 3.14159265 * radius * dice.uniform(0.95, 1.6), flare = dice.uniform(-0.1, 0.5) * around;
  return fmt::format(R"(body stand = cylinder(radius: {0}, length: {1}, height: {2}, upright: true)
garment thing in cloth {{
  piece sheet {{
    outline from (0cm, 0cm) {{
      head  = line to ({3}, 0cm)
      right = line to ({4}, {5})
      foot  = line to ({6}, {5})
      left  = line to start
    }}
  }}
  sew sheet.left to sheet.right
  wear sheet.head at stand.{7}{8}
}}
drape thing on stand as worn
)",
                     cm(radius), cm(1.2 * long_side), cm(2 * long_side), cm(around), cm(around + flare / 2),
                     cm(-long_side), cm(-flare / 2), dice.chance(0.7) ? "top" : "middle",
                     dice.chance(0.3) ? " placed" : "");
}

/// A cloth from the standard library, a likely one, or one at the ends of what there is.
std::string fabric(Dice& dice) {
  static const std::vector<std::string> known{"silk",          "chiffon",      "cotton_shirting", "wool_serge",
                                              "denim",         "leather",      "linen",           "velvet",
                                              "cotton_jersey", "wool_coating", "paper",           "double_knit"};
  if (dice.chance(0.5))
    return fmt::format("fabric cloth = fabrics.{} with {{\n  source \"random\"\n}}\n", dice.one_of(known));
  const bool extreme = dice.chance(0.5);
  const auto range = [&](double low, double high, double least, double greatest) {
    return extreme ? dice.scaled(least, greatest) : dice.scaled(low, high);
  };
  const double hysteresis = range(0.2, 4, 0.01, 20);
  std::string rows = fmt::format("  LT   {:.3f}, {:.3f}\n", dice.uniform(0.5, 0.95), dice.uniform(0.5, 0.95));
  rows += fmt::format("  EMT  {:.3g}%, {:.3g}%\n", range(2, 15, 0.1, 60), range(2, 20, 0.1, 60));
  rows += fmt::format("  G    {:.3g} gf/cm/deg\n", range(0.3, 3, 0.03, 10));
  rows += fmt::format("  2HG  {:.3g} gf/cm\n  2HG5 {:.3g} gf/cm\n", hysteresis, 1.5 * hysteresis);
  rows += fmt::format("  B    {:.3g} gf*cm^2/cm, {:.3g} gf*cm^2/cm\n", range(0.01, 0.3, 1e-4, 10),
                      range(0.01, 0.3, 1e-4, 10));
  rows += fmt::format("  2HB  {:.3g} gf*cm/cm\n", range(0.005, 0.1, 1e-4, 1));
  rows += fmt::format("  T0   {:.3g} mm\n", range(0.2, 1.2, 0.03, 4));
  rows += fmt::format("  W    {:.4g} mg/cm^2\n", range(5, 40, 0.1, 200));
  rows += fmt::format("  MIU  {:.3f}\n", dice.uniform(0, 0.6));
  return fmt::format("fabric cloth {{\n{}}}\n", rows);
}

struct Kind {
  const char* name;
  std::string (*make)(Dice&);
  int least_triangles = 0;
};
constexpr int limbs = 800;
constexpr std::array<Kind, 14> kinds{{{"cloth on a body", cloth_on_a_body},
                                      {"skirt of gores", skirt_of_gores},
                                      {"bag", bag},
                                      {"cape", cape},
                                      {"patchwork", patchwork},
                                      {"trousers", trousers, limbs},
                                      {"prism", prism},
                                      {"blouse", blouse, limbs},
                                      {"sleeve on a post", sleeve_on_a_post},
                                      {"skirt with a ruffle", skirt_with_a_ruffle},
                                      {"floating cloth", floating_cloth},
                                      {"poncho", poncho},
                                      {"T-shirt", t_shirt, limbs},
                                      {"pleated skirt", pleated_skirt}}};

}  // namespace

RandomGarment random_garment(unsigned seed) {
  Dice dice(seed);
  const Kind& kind = kinds[seed % kinds.size()];
  std::string text = "import bodies\nimport blocks\nimport fabrics\nimport sizing\n" + fabric(dice) + kind.make(dice);
  return {kind.name, std::move(text), kind.least_triangles};
}

const std::vector<std::string>& kinds_of_random_garments() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Kind& kind : kinds) all.emplace_back(kind.name);
    return all;
  }();
  return names;
}

}  // namespace toile::test
