// What is read off a cloth as it lies: its energies by term, strains, curvatures, the force that it carries.
#include "runtime/energy/elastic.hpp"

namespace toile {

ElasticParts ElasticForm::parts(const Vector& q) const {
  const std::vector<double> theta = angles(q);
  ElasticParts parts;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& triangle = triangles_[t];
    const MembraneEnergy stretch =
        membrane_energy(law(t), triangle.membrane, corners(triangle.vertices, q), nullptr, memory(t));
    const BendingEnergy bend =
        bending_energy(law(t), triangle.bending, triangle_angles(triangle, theta, q), nullptr, memory(t));
    parts.stretch.warp += stretch.warp;
    parts.stretch.weft += stretch.weft;
    parts.stretch.shear += stretch.shear;
    parts.bend.warp += bend.warp;
    parts.bend.weft += bend.weft;
    parts.bend.twist += bend.twist;
  }
  return parts;
}

std::vector<MembraneStrain> ElasticForm::strains(const Vector& q) const {
  std::vector<MembraneStrain> strains;
  strains.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_) {
    strains.push_back(membrane_strain(triangle.membrane, corners(triangle.vertices, q)));
  }
  return strains;
}

std::vector<Curvatures> ElasticForm::curvatures(const Vector& q) const {
  const std::vector<double> theta = angles(q);
  std::vector<Curvatures> curvatures;
  curvatures.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_) {
    curvatures.push_back(toile::curvatures(triangle.bending, triangle_angles(triangle, theta, q)));
  }
  return curvatures;
}

double ElasticForm::mean_internal_force(const Vector& q) const {
  double sum = 0;
  Vector9 force;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    membrane_energy(law(t), triangles_[t].membrane, corners(triangles_[t].vertices, q), &force);
    for (Eigen::Index corner = 0; corner < 3; ++corner) sum += force.segment<3>(3 * corner).norm();
  }
  return unknowns_.vertices > 0 ? sum / unknowns_.vertices : 0;
}

}  // namespace toile
