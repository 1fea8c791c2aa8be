// From a garment of the program to its drape: mesh, sew, place, solve.
#include <fmt/format.h>

#include "runtime/driver/stopwatch.hpp"
#include "runtime/driver/workroom.hpp"
#include "runtime/report/tightness.hpp"

namespace toile {

namespace {

/// The garments that are draped as one, from the outside in.
std::vector<int> worn(const DrapeCommand& command) {
  std::vector<int> outside_in{command.garment};
  outside_in.insert(outside_in.end(), command.over.begin(), command.over.end());
  return outside_in;
}

}  // namespace

std::shared_ptr<const MadeGarment> Workroom::make(const std::vector<int>& outside_in) {
  if (const auto found = made_.find(outside_in); found != made_.end()) return found->second;
  auto made = std::make_shared<MadeGarment>();
  std::vector<Garment> inside_out;
  const std::vector<int> numbers(outside_in.rbegin(), outside_in.rend());
  for (const int number : numbers) {
    inside_out.push_back(program_->garments()[static_cast<std::size_t>(number)]);
    if (!options_.fabric) continue;
    std::optional<FabricSheet> fabric = fabric_called(*options_.fabric, "--fabric ");
    if (!fabric) return nullptr;
    inside_out.back().fabric = *std::move(fabric);
  }
  made->garment = worn_over_each_other(inside_out);
  {
    const Stopwatch watch(profile_.mesh_s);
    made->mesh_options.target_edge = edge_for_triangles(made->garment, options_.triangles);
    made->mesh = sew(made->garment, made->mesh_options);
    made->cloth = make_cloth(made->mesh);
  }
  if (interrupted()) return nullptr;
  made_.emplace(outside_in, made);
  return made;
}

const std::vector<CoarseGarment>& Workroom::coarse(const std::vector<int>& outside_in, const MadeGarment& made) {
  const auto [found, is_new] = coarse_.try_emplace(outside_in);
  std::vector<CoarseGarment>& coarse = found->second;
  if (!is_new) return coarse;
  const Stopwatch watch(profile_.mesh_s);
  PMeshOptions options = made.mesh_options;
  for (const double edge : level_edges(options.target_edge, static_cast<int>(made.cloth.triangles.size()))) {
    options.target_edge = edge;
    CoarseGarment& level = coarse.emplace_back();
    level.mesh = sew(made.garment, options);
    level.cloth = make_cloth(level.mesh);
  }
  return coarse;
}

// The expression is evaluated in the script's own scope: a garment of one plain square in that cloth is added to the
// text, and its cloth is taken.
std::optional<FabricSheet> Workroom::fabric_called(const std::string& expression, const std::string& asked) {
  const std::string probe = fmt::format(
      "\ngarment cloth_asked_for in {} {{\n  piece square {{\n    outline from (0cm, 0cm) {{\n"
      "      a = line to (10cm, 0cm)\n      b = line to (10cm, 10cm)\n      c = line to (0cm, 10cm)\n"
      "      d = line to start\n    }}\n  }}\n}}\n",
      expression);
  const std::unique_ptr<Program> probed =
      toile::load(script_, text_ + probe, options_.settings, *world_, options_.size);
  if (!probed->ok()) {
    std::string message = fmt::format("{}{}: no such cloth", asked, expression);
    std::string help = "name a fabric as the script could: its own, or one of an imported module (fabrics.wool_serge)";
    for (const Diagnostic& diagnostic : probed->diagnostics()) {
      if (diagnostic.severity != Severity::Error) continue;
      message = fmt::format("{}{}: {}", asked, expression, diagnostic.message);
      if (!diagnostic.help.empty()) help = diagnostic.help;
      break;
    }
    wrong_usage(message, help);
    return std::nullopt;
  }
  return probed->garments().back().fabric;
}

namespace {

std::vector<ArrangedPiece> arranged(const Garment& garment) {
  const auto vec = [](const std::array<double, 3>& v) { return Vec3{v[0], v[1], v[2]}; };
  std::vector<ArrangedPiece> pieces;
  for (const Arrangement& at : garment.arrangements) {
    pieces.push_back({at.piece, vec(at.origin), vec(at.across), vec(at.up)});
  }
  return pieces;
}

}  // namespace
std::shared_ptr<const Body> Workroom::body(int number, Location wanted) {
  std::string error;
  std::shared_ptr<const Body> body = world_->body(program_->bodies()[static_cast<std::size_t>(number)], error);
  if (!body) {
    diagnose(at_place(Severity::Error, "E0407", wanted, "this body cannot be made: " + error, "needed here"));
  }
  return body;
}

DrapeOptions Workroom::drape_options(const DrapeCommand& command) const {
  DrapeOptions options;
  options.accuracy = options_.accuracy.value_or(command.accuracy.value_or(options.accuracy));
  options.solver = options_.solver;
  options.threads = options_.threads;
  options.gravity = command.body >= 0;
  return options;
}

std::optional<Draped> Workroom::drape(const DrapeCommand& command) {
  Draped draped;
  draped.made = make(worn(command));
  if (!draped.made) return std::nullopt;
  if (command.body >= 0) {
    draped.body = body(command.body, command.written);
    if (!draped.body) return std::nullopt;
  }
  std::optional<DrapedLevels> warm = options_.warm ? drape_warm(command, draped) : std::nullopt;
  DrapedLevels result = warm ? *std::move(warm) : drape_cold(command, draped);
  profile_.place_s += result.place_seconds;
  profile_.solve_s += result.solve_seconds;
  if (!result.error.empty()) {
    diagnose(at_place(Severity::Error, "E0505", command.written, "this garment cannot be placed: " + result.error,
                      "draped here"));
    return std::nullopt;
  }
  draped.drape = std::move(result.drape);
  profile_.factorisations += draped.drape.factorisations;
  if (interrupted()) return std::nullopt;
  if (options_.warm && draped.drape.converged) {
    kept_.keep(warm_key(draped), keep(draped.made->garment, draped.made->mesh, draped.drape.positions));
  }
  note_drape(command, draped);
  return draped;
}

DrapedLevels Workroom::drape_cold(const DrapeCommand& command, const Draped& draped) {
  std::vector<DrapeLevel> levels;
  for (const CoarseGarment& level : coarse(worn(command), *draped.made)) levels.push_back({&level.mesh, &level.cloth});
  levels.push_back({&draped.made->mesh, &draped.made->cloth});
  const Garment& garment = draped.made->garment;
  return drape_levels(levels, garment.wears, arranged(garment), garment.fabrics(), draped.body.get(),
                      drape_options(command), job_);
}

std::string Workroom::warm_key(const Draped& draped) const {
  std::error_code none;
  const std::filesystem::path script = std::filesystem::absolute(script_, none);
  return fmt::format("{}\n{}\n{}\n{}", script.lexically_normal().string(), draped.made->garment.name,
                     draped.body ? draped.body->spec().name : "", options_.size);
}

std::optional<DrapedLevels> Workroom::drape_warm(const DrapeCommand& command, const Draped& draped) {
  const std::optional<KeptDrape> kept = kept_.find(warm_key(draped));
  if (!kept) return std::nullopt;
  const Garment& garment = draped.made->garment;
  const std::optional<std::vector<Vec3>> start = start_from(*kept, garment, draped.made->mesh);
  if (!start) return std::nullopt;
  DrapedLevels result = drape_from(*start, {&draped.made->mesh, &draped.made->cloth}, garment.wears, arranged(garment),
                                   garment.fabrics(), draped.body.get(), drape_options(command), job_);
  if (!result.drape.converged && !result.drape.cancelled) return std::nullopt;
  return result;
}

namespace {

/// "; the most in piece front, at (12.3, -4.0, 101.2) cm".
std::string where_restless(const Draped& draped) {
  const int v = draped.drape.restless;
  if (v < 0 || draped.drape.fell_off || draped.drape.cancelled) return "";
  const SewnMesh& mesh = draped.made->mesh;
  const PieceId piece =
      mesh.p.piece_of_point[static_cast<std::size_t>(mesh.s.p_of_s[static_cast<std::size_t>(v)].front())];
  const Vec3 at = draped.drape.positions[static_cast<std::size_t>(v)];
  return fmt::format("; the most in piece {}, at ({:.1f}, {:.1f}, {:.1f}) cm",
                     draped.made->garment.pieces[static_cast<std::size_t>(piece)].name, 100 * at.x, 100 * at.y,
                     100 * at.z);
}

/// `depth` [m] of the deepest point.
std::string why_tight(const Tightness& tight, const std::string& piece, double depth) {
  constexpr double comes_through = 0.015;  // [m]
  constexpr double least_strain = 0.01;    // below it is not the piece's length that is wrong
  constexpr double least_short = 0.002;    // [m]
  std::string stretched =
      fmt::format("its {} is stretched by {:.1f} % there", tight.along_warp ? "warp" : "weft", 100 * tight.strain);
  if (tight.strain < least_strain)
    stretched = "its threads are hardly stretched there";
  else if (tight.short_m < least_short)
    stretched += " and hardly elsewhere";
  else
    stretched += fmt::format(": {} is {:.1f} cm too short along it, over {:.1f} cm", piece, 100 * tight.short_m,
                             100 * tight.length_m);
  if (depth < comes_through) return stretched;
  return stretched +
         "; so deep, the body comes through: large triangles slip past a limb, more of them (--triangles) " + "may not";
}

std::string help_with(const Drape& drape) {
  return drape.fell_off ? "`wear` without `placed` holds an edge at a line of the body, as a waistband does"
                        : "files and pictures show the state it reached; the report says what is left";
}

}  // namespace

void Workroom::note_tightness(const DrapeCommand& command, const Draped& draped) {
  constexpr double strongest_class = 6500;  // [Pa], see W0518
  if (!draped.body) return;
  const Tightness tight = tightest(draped.view());
  const double deepest = draped.drape.contact.max_penetration_m;
  if (tight.pressure_Pa < strongest_class || tight.piece < 0) return;
  const std::string& piece = draped.made->garment.pieces[static_cast<std::size_t>(tight.piece)].name;
  diagnose(at_place(
      Severity::Warning, "W0518", command.written,
      fmt::format("{} presses on {} with {:.1f} kPa, {:.1f} mm deep, in piece {} at ({:.1f}, {:.1f}, {:.1f}) cm",
                  draped.made->garment.name, draped.body->spec().name, tight.pressure_Pa / 1000,
                  1000 * tight.pressure_Pa / draped.body->spec().softness, piece, 100 * tight.at.x, 100 * tight.at.y,
                  100 * tight.at.z),
      "draped here", why_tight(tight, piece, deepest)));
}

void Workroom::note_drape(const DrapeCommand& command, const Draped& draped) {
  const Drape& result = draped.drape;
  const std::string on = draped.body ? " on " + draped.body->spec().name : "";
  std::string line =
      fmt::format("{}{}: {} triangles, {} iterations, residual {:.1e} of a vertex's load", draped.made->garment.name,
                  on, draped.made->cloth.triangles.size(), result.iterations, result.residual_relative);
  if (draped.body) {
    line +=
        fmt::format("; weight {:.2f} N carried to within {:.2g} %, deepest contact {:.3f} mm", result.contact.weight_N,
                    100 * result.contact.weight_error, 1000 * result.contact.max_penetration_m);
  }
  listener_->noted(line);
  note_tightness(command, draped);
  if (result.crossing_pairs > 0) {
    diagnose(at_place(Severity::Warning, "W0516", command.written,
                      fmt::format("{} passes through itself: {} pairs of triangles cross", draped.made->garment.name,
                                  result.crossing_pairs),
                      "draped here",
                      "the cloth starts crossed and cannot come apart; see whether its seams are sewn the right way"));
  }
  if (!result.converged) {
    outcome_.unsettled = true;
    diagnose(at_place(
        Severity::Warning, "W0509", command.written,
        fmt::format("{} did not come to rest: {}{}", draped.made->garment.name, result.trouble, where_restless(draped)),
        "draped here", help_with(result)));
  }
}

}  // namespace toile
