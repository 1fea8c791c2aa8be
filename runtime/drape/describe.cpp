#include "runtime/drape/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/drape/spread.hpp"

namespace toile {
namespace {

Vector gradient_of(const ClothState& state) {
  Vector gradient = Vector::Zero(state.q.size());
  state.elastic.energy(state.q, &gradient);
  if (state.gravity != nullptr) state.gravity->energy(state.q, &gradient);
  if (state.contact != nullptr) state.contact->energy(state.q, &gradient);
  if (state.layers != nullptr) state.layers->energy(state.q, &gradient);
  return gradient;
}

Energies energies(const ClothState& state) {
  const ElasticParts parts = state.elastic.parts(state.q);
  Energies energies{.stretch_warp = parts.stretch.warp,
                    .stretch_weft = parts.stretch.weft,
                    .shear = parts.stretch.shear,
                    .bend_warp = parts.bend.warp,
                    .bend_weft = parts.bend.weft,
                    .twist = parts.bend.twist};
  if (state.gravity != nullptr) energies.gravity = state.gravity->energy(state.q, nullptr);
  if (state.contact != nullptr) {
    const ContactForces forces = state.contact->forces(state.q);
    energies.contact = forces.normal_energy;
    energies.friction = forces.friction_energy;
  }
  if (state.layers != nullptr) {
    const double friction = state.layers->friction_energy(state.q);
    energies.friction += friction;
    energies.self_contact = state.layers->energy(state.q, nullptr) - friction;
  }
  return energies;
}

Spread pressure_spread(const std::vector<double>& pressure, const Cloth& cloth) {
  std::vector<double> touching, areas;
  for (std::size_t v = 0; v < pressure.size(); ++v) {
    if (pressure[v] <= 0) continue;
    touching.push_back(pressure[v]);
    areas.push_back(cloth.area_of_vertex[v]);
  }
  return touching.empty() ? Spread{} : spread(touching, areas);
}

Contact contact(const ClothState& state, const Vector& gradient, const std::vector<double>& pressure) {
  Contact contact;
  contact.weight_N = state.gravity != nullptr ? state.gravity->weight() : 0;
  for (int v = 0; v < state.cloth.vertex_count; ++v) {
    const int z = 3 * v + 2;
    if (state.reduced[static_cast<std::size_t>(z)] < 0) contact.support_held_N += gradient[z];
  }
  if (state.contact != nullptr) {
    const ContactForces forces = state.contact->forces(state.q);
    contact.support_body_N = forces.normal.z();
    contact.support_friction_N = forces.friction.z();
    contact.max_penetration_m = forces.max_depth;
    contact.contact_area_m2 = forces.area;
    contact.pressure_Pa = pressure_spread(pressure, state.cloth);
    contact.pressure_Pa.max = std::max(contact.pressure_Pa.max, forces.max_pressure);
  }
  if (contact.weight_N > 0) {
    contact.weight_error = std::abs(contact.weight_N - contact.support_total_N()) / contact.weight_N;
  }
  return contact;
}

void describe_triangles(const ClothState& state, Drape& drape) {
  const std::vector<MembraneStrain> strains = state.elastic.strains(state.q);
  for (std::size_t t = 0; t < strains.size(); ++t) {
    const MembraneStrain& strain = strains[t];
    const FabricLaw& law = state.laws[static_cast<std::size_t>(state.cloth.triangles[t].fabric)];
    drape.strain_warp.push_back(strain.warp);
    drape.strain_weft.push_back(strain.weft);
    drape.shear_angle.push_back(strain.shear);
    drape.stress_warp.push_back(law.warp(strain.warp).force);
    drape.stress_weft.push_back(law.weft(strain.weft).force);
    drape.stress_shear.push_back(law.shear(strain.shear).force);
  }
  for (const Curvatures& k : state.elastic.curvatures(state.q)) {
    drape.curvature_warp.push_back(k.warp);
    drape.curvature_weft.push_back(k.weft);
    drape.twist.push_back(k.twist);
  }
}

}  // namespace

LargestResidual largest_residual(const Vector& gradient, const ClothUnknowns& unknowns) {
  LargestResidual largest;
  for (int v = 0; v < unknowns.vertices; ++v) {
    const double force = gradient.segment<3>(3 * v).norm();
    if (!(force > largest.force)) continue;
    largest.force = force;
    largest.vertex = v;
  }
  for (int h = 0; h < unknowns.hinges; ++h) {
    largest.moment = std::max(largest.moment, std::abs(gradient[unknowns.rotation(h)]));
  }
  return largest;
}

void clear_held(Vector& gradient, const std::vector<int>& reduced) {
  for (std::size_t i = 0; i < reduced.size(); ++i) {
    if (reduced[i] < 0) gradient[static_cast<Eigen::Index>(i)] = 0;
  }
}

Drape describe(const ClothState& state) {
  Drape drape;
  for (int v = 0; v < state.cloth.vertex_count; ++v) drape.positions.push_back(to_vec3(state.q.segment<3>(3 * v)));
  for (int h = 0; h < state.elastic.unknowns().hinges; ++h) {
    drape.edge_rotations.push_back(state.q[state.elastic.unknowns().rotation(h)]);
  }
  Vector gradient = gradient_of(state);
  drape.pressure = state.contact != nullptr
                       ? state.contact->pressures(state.q)
                       : std::vector<double>(static_cast<std::size_t>(state.cloth.vertex_count), 0.0);
  drape.contact = contact(state, gradient, drape.pressure);
  clear_held(gradient, state.reduced);
  const LargestResidual largest = largest_residual(gradient, state.elastic.unknowns());
  drape.restless = largest.vertex;
  drape.residual_N = largest.force;
  drape.residual_moment_Nm = largest.moment;
  drape.energy = energies(state);
  describe_triangles(state, drape);
  return drape;
}

std::string trouble(const Drape& drape) {
  if (drape.converged) return {};
  if (drape.cancelled) return "interrupted before it came to rest";
  if (drape.fell_off) return "it slides off the body and falls: nothing holds it";
  return fmt::format("after {} iterations a force of {:.3g} N is still unbalanced ({:.3g} of what a vertex carries)",
                     drape.iterations, drape.residual_N, drape.residual_relative);
}

}  // namespace toile
