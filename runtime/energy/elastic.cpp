#include "runtime/energy/elastic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/solve/parallel.hpp"

namespace toile {
namespace {

using std::size_t;

Vector3 point(const Vector& q, int vertex) {
  return q.segment<3>(3 * vertex);
}

}  // namespace

ElasticForm::ElasticForm(const Cloth& cloth, const FabricLaw& law, Loops loops)
    : ElasticForm(cloth, std::vector<FabricLaw>(static_cast<size_t>(cloth.fabric_count()), law), loops) {}

ElasticForm::ElasticForm(const Cloth& cloth, std::vector<FabricLaw> laws, Loops loops) : laws_(std::move(laws)) {
  triangles_.reserve(cloth.triangles.size());
  for (const ClothTriangle& triangle : cloth.triangles) {
    triangles_.push_back(
        {triangle.vertices, membrane_shape(triangle.uv), bending_shape(triangle.uv), {}, triangle.fabric});
  }
  unknowns_.vertices = cloth.vertex_count;
  make_hinges(cloth);
  unknowns_.hinges = static_cast<int>(hinges_.size());
  last_angle_.assign(hinges_.size(), 0.0);
  if (loops == Loops::Remembered) memory_.resize(triangles_.size());
  make_elements();
}

void ElasticForm::make_hinges(const Cloth& cloth) {
  const auto corner_vertex = [&](const SMesh::Wing& wing, int turn) {
    return cloth.triangles[static_cast<size_t>(wing.triangle)].vertices[static_cast<size_t>((wing.corner + turn) % 3)];
  };
  const auto side = [&](const SMesh::Wing& wing) -> HingeSide& {
    return triangles_[static_cast<size_t>(wing.triangle)].sides[static_cast<size_t>(wing.corner)];
  };
  const auto free_wing = [&](int edge, const SMesh::Wing& wing) {
    side(wing) = {static_cast<int>(hinges_.size()), 0, 1};
    hinges_.push_back({edge, {corner_vertex(wing, 1), corner_vertex(wing, 2), corner_vertex(wing, 0), -1}, 0});
  };
  const auto pair = [&](int edge, const SMesh::Wing& first, const SMesh::Wing& second, double crease) {
    // The second triangle walks the edge against the first where both are turned the same side up.
    const bool agree = corner_vertex(second, 1) == corner_vertex(first, 2);
    const int hinge = static_cast<int>(hinges_.size());
    side(first) = {hinge, 1, 1};
    side(second) = agree ? HingeSide{hinge, 1, -1} : HingeSide{hinge, -1, 1};
    hinges_.push_back(
        {edge,
         {corner_vertex(first, 1), corner_vertex(first, 2), corner_vertex(first, 0), corner_vertex(second, 0)},
         crease});
  };
  // Hinge e belongs to edge e; further pairs of wings, and single ones, come after all edges.
  for (int edge = 0; edge < cloth.edge_count; ++edge) {
    const SMesh::Edge& of = cloth.edges[static_cast<size_t>(edge)];
    if (of.wings.size() == 1) {
      free_wing(edge, of.wings.front());
    } else {
      pair(edge, of.wings[0], of.wings[1], of.crease);
    }
  }
  for (int edge = 0; edge < cloth.edge_count; ++edge) {
    const SMesh::Edge& of = cloth.edges[static_cast<size_t>(edge)];
    const size_t paired = of.pairs == 2 ? 4 : 2;
    if (paired == 4) pair(edge, of.wings[2], of.wings[3], 0);
    for (size_t wing = paired; wing < of.wings.size(); ++wing) free_wing(edge, of.wings[wing]);
  }
}

void ElasticForm::make_elements() {
  elements_.resize(triangles_.size());
  for (size_t t = 0; t < triangles_.size(); ++t) {
    Element& element = elements_[t];
    element.vertices.assign(triangles_[t].vertices.begin(), triangles_[t].vertices.end());
    for (size_t corner = 0; corner < 3; ++corner) {
      const ClothHinge& hinge = hinges_[static_cast<size_t>(triangles_[t].sides[corner].hinge)];
      for (size_t k = 0; k < 4; ++k) {
        const int vertex = hinge.vertices[k];
        if (vertex < 0) continue;
        auto found = std::find(element.vertices.begin(), element.vertices.end(), vertex);
        if (found == element.vertices.end()) found = element.vertices.insert(found, vertex);
        element.of_hinge[corner][k] = static_cast<int>(found - element.vertices.begin());
      }
    }
  }
}

std::vector<int> ElasticForm::unknowns_of(const Element& element, const Triangle& triangle) const {
  std::vector<int> unknowns;
  for (const int vertex : element.vertices) {
    for (int k = 0; k < 3; ++k) unknowns.push_back(3 * vertex + k);
  }
  for (const HingeSide& side : triangle.sides) unknowns.push_back(unknowns_.rotation(side.hinge));
  return unknowns;
}

std::vector<std::vector<int>> ElasticForm::couplings() const {
  std::vector<std::vector<int>> couplings;
  couplings.reserve(elements_.size());
  for (size_t t = 0; t < elements_.size(); ++t) couplings.push_back(unknowns_of(elements_[t], triangles_[t]));
  return couplings;
}

void ElasticForm::prepare(const SparseMatrix& matrix) {
  for (size_t t = 0; t < elements_.size(); ++t) {
    elements_[t].places = matrix.places(unknowns_of(elements_[t], triangles_[t]));
  }
  hinge_places_.assign(hinges_.size(), {});
  for (size_t h = 0; h < hinges_.size(); ++h) {
    if (hinges_[h].vertices[3] < 0) continue;
    std::vector<int> unknowns;
    for (const int vertex : hinges_[h].vertices) {
      for (int k = 0; k < 3; ++k) unknowns.push_back(3 * vertex + k);
    }
    hinge_places_[h] = matrix.places(unknowns);
  }
}

Hinge ElasticForm::hinge_points(const ClothHinge& hinge, const Vector& q) const {
  return {point(q, hinge.vertices[0]), point(q, hinge.vertices[1]), point(q, hinge.vertices[2]),
          point(q, hinge.vertices[3])};
}

double ElasticForm::angle(size_t hinge, const Vector& q) const {
  if (hinges_[hinge].vertices[3] < 0) return 0;
  constexpr double turn = 2 * std::numbers::pi;
  const double raw = dihedral(hinge_points(hinges_[hinge], q)) - hinges_[hinge].crease;
  return raw + turn * std::round((last_angle_[hinge] - raw) / turn);
}

Corners ElasticForm::corners(const std::array<int, 3>& vertices, const Vector& q) {
  return {point(q, vertices[0]), point(q, vertices[1]), point(q, vertices[2])};
}

std::vector<double> ElasticForm::angles(const Vector& q) const {
  std::vector<double> theta(hinges_.size());
  parallel_for(hinges_.size(), [&](size_t begin, size_t end) {
    for (size_t h = begin; h < end; ++h) theta[h] = angle(h, q);
  });
  return theta;
}

Angles ElasticForm::triangle_angles(const Triangle& triangle, const std::vector<double>& theta, const Vector& q) const {
  Angles angles{};
  for (size_t corner = 0; corner < 3; ++corner) {
    const HingeSide& side = triangle.sides[corner];
    angles[corner] =
        side.tilt * theta[static_cast<size_t>(side.hinge)] / 2 + side.turn * q[unknowns_.rotation(side.hinge)];
  }
  return angles;
}

double ElasticForm::energy(const Vector& q, Vector* gradient) const {
  const std::vector<double> theta = angles(q);
  std::vector<double> energies(triangles_.size());
  std::vector<Vector9> forces(gradient != nullptr ? triangles_.size() : 0);
  std::vector<Angles> moments(forces.size());
  parallel_for(triangles_.size(), [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const Triangle& triangle = triangles_[t];
      const MembraneEnergy stretch = membrane_energy(law(t), triangle.membrane, corners(triangle.vertices, q),
                                                     gradient != nullptr ? &forces[t] : nullptr, memory(t));
      const BendingEnergy bend = bending_energy(law(t), triangle.bending, triangle_angles(triangle, theta, q),
                                                gradient != nullptr ? &moments[t] : nullptr, memory(t));
      energies[t] = stretch.warp + stretch.weft + stretch.shear + bend.warp + bend.weft + bend.twist;
    }
  });
  double total = 0;
  for (const double energy : energies) total += energy;
  if (gradient == nullptr) return total;

  std::vector<double> hinge_moment(hinges_.size(), 0.0);
  for (size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& triangle = triangles_[t];
    for (size_t corner = 0; corner < 3; ++corner) {
      gradient->segment<3>(3 * triangle.vertices[corner]) +=
          forces[t].segment<3>(static_cast<Eigen::Index>(3 * corner));
      const HingeSide& side = triangle.sides[corner];
      (*gradient)[unknowns_.rotation(side.hinge)] += side.turn * moments[t][corner];
      hinge_moment[static_cast<size_t>(side.hinge)] += side.tilt / 2 * moments[t][corner];
    }
  }
  std::vector<Vector12> slopes(hinges_.size());
  parallel_for(hinges_.size(), [&](size_t begin, size_t end) {
    for (size_t h = begin; h < end; ++h) {
      if (hinges_[h].vertices[3] >= 0) slopes[h] = hinge_moment[h] * dihedral_gradient(hinge_points(hinges_[h], q));
    }
  });
  for (size_t h = 0; h < hinges_.size(); ++h) {
    if (hinges_[h].vertices[3] < 0) continue;
    for (size_t k = 0; k < 4; ++k) {
      gradient->segment<3>(3 * hinges_[h].vertices[k]) += slopes[h].segment<3>(static_cast<Eigen::Index>(3 * k));
    }
  }
  return total;
}

void ElasticForm::add_hessian(const Vector& q, Curvature curvature, SparseMatrix& matrix) const {
  const std::vector<double> theta = angles(q);
  add_triangles(q, theta, dihedral_slopes(q), curvature, matrix);
  if (curvature == Curvature::Full) add_hinges(q, theta, matrix);
}

std::vector<Vector12> ElasticForm::dihedral_slopes(const Vector& q) const {
  std::vector<Vector12> slopes(hinges_.size());
  parallel_for(hinges_.size(), [&](size_t begin, size_t end) {
    for (size_t h = begin; h < end; ++h) {
      if (hinges_[h].vertices[3] >= 0) slopes[h] = dihedral_gradient(hinge_points(hinges_[h], q));
    }
  });
  return slopes;
}

ElasticForm::AnglesByUnknowns ElasticForm::angles_by_unknowns(size_t triangle,
                                                              const std::vector<Vector12>& slopes) const {
  const Element& element = elements_[triangle];
  const auto coordinates = static_cast<Eigen::Index>(3 * element.vertices.size());
  AnglesByUnknowns by_unknowns(3, coordinates + 3);
  by_unknowns.setZero();
  for (int corner = 0; corner < 3; ++corner) {
    const HingeSide& side = triangles_[triangle].sides[static_cast<size_t>(corner)];
    by_unknowns(corner, coordinates + corner) = side.turn;
    if (side.tilt == 0) continue;
    for (int k = 0; k < 4; ++k) {
      const int at = element.of_hinge[static_cast<size_t>(corner)][static_cast<size_t>(k)];
      by_unknowns.block<1, 3>(corner, 3 * at) +=
          side.tilt / 2 * slopes[static_cast<size_t>(side.hinge)].segment<3>(3 * k).transpose();
    }
  }
  return by_unknowns;
}

void ElasticForm::add_triangles(const Vector& q, const std::vector<double>& theta, const std::vector<Vector12>& slopes,
                                Curvature curvature, SparseMatrix& matrix) const {
  using Dense = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 21, 21>;
  constexpr size_t chunk = 1024;  // element matrices held at a time
  std::vector<Dense> dense(std::min(chunk, triangles_.size()));
  for (size_t first = 0; first < triangles_.size(); first += chunk) {
    const size_t count = std::min(chunk, triangles_.size() - first);
    parallel_for(count, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Triangle& triangle = triangles_[first + i];
        const AnglesByUnknowns by_unknowns = angles_by_unknowns(first + i, slopes);
        const Matrix3 by_angles =
            bending_hessian(law(first + i), triangle.bending, triangle_angles(triangle, theta, q), memory(first + i));
        dense[i].noalias() = by_unknowns.transpose() * (by_angles * by_unknowns);
        const Corners x = corners(triangle.vertices, q);
        const MembraneStrain stressed =
            foreseen_.empty() ? membrane_strain(triangle.membrane, x) : foreseen_[first + i];
        dense[i].topLeftCorner<9, 9>() +=
            membrane_hessian(law(first + i), triangle.membrane, x, stressed, curvature, memory(first + i));
      }
    });
    for (size_t i = 0; i < count; ++i) {
      size_t at = 0;
      for (Eigen::Index row = 0; row < dense[i].rows(); ++row) {
        for (Eigen::Index column = 0; column <= row; ++column, ++at) {
          const std::int32_t place = elements_[first + i].places[at];
          if (place >= 0) matrix.add_at(place, dense[i](row, column));
        }
      }
    }
  }
}

std::vector<double> ElasticForm::hinge_moments(const Vector& q, const std::vector<double>& theta) const {
  std::vector<double> moments(hinges_.size(), 0.0);
  for (size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& triangle = triangles_[t];
    Angles moment{};
    bending_energy(law(t), triangle.bending, triangle_angles(triangle, theta, q), &moment, memory(t));
    for (size_t corner = 0; corner < 3; ++corner) {
      moments[static_cast<size_t>(triangle.sides[corner].hinge)] += triangle.sides[corner].tilt / 2 * moment[corner];
    }
  }
  return moments;
}

void ElasticForm::add_hinges(const Vector& q, const std::vector<double>& theta, SparseMatrix& matrix) const {
  const std::vector<double> moments = hinge_moments(q, theta);
  constexpr size_t chunk = 1024;
  std::vector<Matrix12> dense(std::min(chunk, hinges_.size()));
  for (size_t first = 0; first < hinges_.size(); first += chunk) {
    const size_t count = std::min(chunk, hinges_.size() - first);
    parallel_for(count, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        if (hinges_[first + i].vertices[3] < 0) continue;
        dense[i] = moments[first + i] * dihedral_hessian(hinge_points(hinges_[first + i], q));
      }
    });
    for (size_t i = 0; i < count; ++i) {
      size_t at = 0;
      for (const std::int32_t place : hinge_places_[first + i]) {
        // The lower triangle row by row: entry number r (r + 1) / 2 + c.
        const auto row = static_cast<Eigen::Index>((std::sqrt(8.0 * static_cast<double>(at) + 1) - 1) / 2);
        const auto column = static_cast<Eigen::Index>(at) - row * (row + 1) / 2;
        if (place >= 0) matrix.add_at(place, dense[i](row, column));
        ++at;
      }
    }
  }
}

void ElasticForm::foresee(const Vector& q, const Vector& step) {
  foreseen_.resize(triangles_.size());
  parallel_for(triangles_.size(), [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const Triangle& triangle = triangles_[t];
      foreseen_[t] =
          foreseen_strain(triangle.membrane, corners(triangle.vertices, q), corners(triangle.vertices, step));
    }
  });
}

std::vector<PatternCoupling> ElasticForm::pattern_couplings(const Cloth& cloth, const Vector& q) const {
  const std::vector<double> theta = angles(q);
  const std::vector<Vector12> slopes = dihedral_slopes(q);
  std::vector<PatternCoupling> couplings(triangles_.size());
  parallel_for(triangles_.size(), [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) {
      const Triangle& triangle = triangles_[t];
      couplings[t].unknowns = unknowns_of(elements_[t], triangle);
      couplings[t].by_corners = angles_by_unknowns(t, slopes).transpose() *
                                bending_by_pattern(law(t), cloth.triangles[t].uv, triangle_angles(triangle, theta, q));
      couplings[t].by_corners.topRows<9>() +=
          membrane_by_pattern(law(t), triangle.membrane, corners(triangle.vertices, q));
    }
  });
  return couplings;
}

void ElasticForm::accept(const Vector& q) {
  last_angle_ = angles(q);
}

void ElasticForm::remember(const Vector& q) {
  const std::vector<double> theta = angles(q);
  for (size_t t = 0; t < memory_.size(); ++t) {
    const Triangle& triangle = triangles_[t];
    const Curvatures k = toile::curvatures(triangle.bending, triangle_angles(triangle, theta, q));
    const double angle = membrane_strain(triangle.membrane, corners(triangle.vertices, q)).shear;
    ClothMemory& memory = memory_[t];
    memory = {anchor_after(law(t).shear.loop(), memory.shear, angle),
              anchor_after(law(t).bend_warp.loop(), memory.bend_warp, k.warp),
              anchor_after(law(t).bend_weft.loop(), memory.bend_weft, k.weft)};
  }
}

}  // namespace toile
