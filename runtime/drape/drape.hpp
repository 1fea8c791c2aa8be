// Draping: from placed positions to static equilibrium.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compiler/pattern/fabric_sheet.hpp"
#include "runtime/body/body.hpp"
#include "runtime/mesh/cloth.hpp"
#include "runtime/place/place.hpp"
#include "runtime/solve/job.hpp"

namespace toile {

struct RestState;

struct DrapeOptions {
  double accuracy = 1e-3;  // residual_relative to reach
  enum class Solver { Newton, Okabe } solver = Solver::Newton;
  int threads = 0;       // 0: as many as there are
  bool gravity = true;   // off where there is no body
  bool friction = true;  // off while a garment that is held somewhere falls
  int max_iterations = 1500;
  double least_gap =
      0;                // [m] of layers of the cloth where its thickness is less: a finer mesh will have to fit between
  double membrane = 1;  // share of its forces of elongation and shear: a coarse mesh locks with all of them
  bool carried_over = false;                        // the start is a form already draped on another mesh, near rest
  std::function<void(const RestState&)> at_rest{};  // called once the cloth has come to rest, if it does
};

struct Energies {  // [J]
  double stretch_warp = 0, stretch_weft = 0, shear = 0, bend_warp = 0, bend_weft = 0, twist = 0;
  double gravity = 0, contact = 0, friction = 0, self_contact = 0;
  double total() const {
    return stretch_warp + stretch_weft + shear + bend_warp + bend_weft + twist + gravity + contact + friction +
           self_contact;
  }
};

/// Minimum, mean, 95th percentile of the absolute value and maximum, area-weighted.
struct Spread {
  double min = 0, mean = 0, p95 = 0, max = 0;
};

struct Contact {
  double weight_N = 0;
  double support_body_N = 0, support_friction_N = 0, support_held_N = 0;
  double support_total_N() const { return support_body_N + support_friction_N + support_held_N; }
  double weight_error = 0;  // |weight - support| / weight; 0 without gravity
  double max_penetration_m = 0;
  double contact_area_m2 = 0;
  Spread pressure_Pa;  // over the area in contact
};

struct Drape {
  std::vector<Vec3> positions;
  std::vector<double> edge_rotations;  // [rad], one an edge of the S-mesh
  int crossing_pairs = 0;              // of triangles, of the cloth with itself; 0 unless it cannot be otherwise
  bool converged = false;
  bool cancelled = false;
  bool fell_off = false;  // the body: nothing holds it
  int restless = -1;      // the vertex with the largest force that is left; -1 when there is none
  std::string trouble;    // what did not come to rest, in words; empty when converged
  int iterations = 0;
  int factorisations = 0;
  double residual_N = 0;          // the largest norm of the total force on a free vertex
  double residual_moment_Nm = 0;  // the largest moment on an edge rotation
  double residual_relative = 0;
  Energies energy;
  Contact contact;
  // per triangle: strains, [1] and shear angle [rad]; stresses as forces per width [N/m]; curvatures [1/m]
  std::vector<double> strain_warp, strain_weft, shear_angle;
  std::vector<double> stress_warp, stress_weft, stress_shear;
  std::vector<double> curvature_warp, curvature_weft, twist;
  std::vector<double> pressure;  // per vertex [Pa], 0 where nothing touches
};

/// Always returns finite positions; says in `converged` and `trouble` how it ended. A sheet for each fabric of the
/// cloth.
Drape drape(const Cloth& cloth, const std::vector<FabricSheet>& fabrics, const Body* body, const Placed& start,
            const DrapeOptions& options, const Job& job);
Drape drape(const Cloth& cloth, const FabricSheet& fabric, const Body* body, const Placed& start,
            const DrapeOptions& options, const Job& job);

}  // namespace toile
