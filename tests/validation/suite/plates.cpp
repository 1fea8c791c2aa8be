// The orthotropic plate under a uniform load, and states of constant curvature.
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <functional>
#include <numbers>

#include "runtime/laboratory/rig.hpp"
#include "tests/validation/suite/figures.hpp"
#include "tests/validation/suite/meshes.hpp"

namespace toile::validation {
namespace {

// D = (4, 1, 0, 0.6): bending in warp and weft, no coupling, twist.
constexpr double plate_warp = 4, plate_weft = 1, plate_twist = 0.6;
constexpr double plate_load = 1e-6;  // so small that the plate does not stretch

/// Navier's double series for the mean deflection of the unit square under the unit load.
double navier() {
  double sum = 0;
  for (int m = 1; m < 400; m += 2) {
    for (int n = 1; n < 400; n += 2) {
      const double mm = m * m, nn = n * n;
      sum += 64 / (std::pow(std::numbers::pi, 8) * mm * nn *
                   (plate_warp * mm * mm + 4 * plate_twist * mm * nn + plate_weft * nn * nn));
    }
  }
  return sum;
}

/// The quantities of a polynomial on [0, 1] at points: value and two derivatives.
struct Basis {
  std::array<Vector, 3> at;
};

/// x (1 - x) times the Legendre polynomials, at Gauss points.
std::vector<Basis> basis(int count, const Vector& x) {
  std::vector<std::array<Vector, 3>> legendre;
  const Vector t = 2 * x - Vector::Ones(x.size());
  for (int i = 0; i < count; ++i) {
    if (i == 0) {
      legendre.push_back({Vector::Ones(x.size()), Vector::Zero(x.size()), Vector::Zero(x.size())});
      continue;
    }
    if (i == 1) {
      legendre.push_back({t, Vector::Constant(x.size(), 2), Vector::Zero(x.size())});
      continue;
    }
    const auto& one = legendre[static_cast<std::size_t>(i - 1)];
    const auto& two = legendre[static_cast<std::size_t>(i - 2)];
    std::array<Vector, 3> next;
    const double a = (2.0 * i - 1) / i, b = (i - 1.0) / i;
    next[0] = a * t.cwiseProduct(one[0]) - b * two[0];
    next[1] = a * (2 * one[0] + t.cwiseProduct(one[1])) - b * two[1];
    next[2] = a * (4 * one[1] + t.cwiseProduct(one[2])) - b * two[2];
    legendre.push_back(next);
  }
  const Vector hump = x.cwiseProduct(Vector::Ones(x.size()) - x), slope = Vector::Ones(x.size()) - 2 * x;
  std::vector<Basis> result;
  for (const auto& p : legendre) {
    result.push_back({{hump.cwiseProduct(p[0]), slope.cwiseProduct(p[0]) + hump.cwiseProduct(p[1]),
                       -2 * p[0] + 2 * slope.cwiseProduct(p[1]) + hump.cwiseProduct(p[2])}});
  }
  return result;
}

/// Gauss points and weights on [0, 1] by Newton's method on the Legendre polynomial.
void gauss(int count, Vector& x, Vector& w) {
  x.resize(count);
  w.resize(count);
  for (int i = 0; i < count; ++i) {
    double t = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1;
    for (int pass = 0; pass < 50; ++pass) {
      double last = 1, now = t;
      for (int k = 2; k <= count; ++k) {
        const double next = ((2.0 * k - 1) * t * now - (k - 1.0) * last) / k;
        last = now;
        now = next;
      }
      slope = count * (t * now - last) / (t * t - 1);
      t -= now / slope;
    }
    x[i] = 0.5 * (1 + t);
    w[i] = 1 / ((1 - t * t) * slope * slope);
  }
}

/// Ritz's method with polynomials: the mean deflection where the warp lies at an angle to the sides.
double ritz(double grain, int count) {
  Vector x, w;
  gauss(count + 6, x, w);
  const std::vector<Basis> one = basis(count, x);
  const double c = std::cos(grain), s = std::sin(grain);
  Matrix3 turn;  // (k_xx, k_yy, k_xy) to (k_u, k_v, k_uv)
  turn << c * c, s * s, 2 * s * c, s * s, c * c, -2 * s * c, -s * c, s * c, c * c - s * s;
  const Matrix3 stiffness = turn.transpose() * Vector3(plate_warp, plate_weft, 4 * plate_twist).asDiagonal() * turn;
  // Integrals of products of two derivatives of the basis, [a][b] by orders.
  const auto product = [&](int i, int a, int j, int b) {
    return (one[static_cast<std::size_t>(i)].at[static_cast<std::size_t>(a)].array() *
            one[static_cast<std::size_t>(j)].at[static_cast<std::size_t>(b)].array() * w.array())
        .sum();
  };
  constexpr std::array<std::array<int, 2>, 3> orders{{{2, 0}, {0, 2}, {1, 1}}};
  const int size = count * count;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  std::array<std::array<Eigen::MatrixXd, 3>, 3> integral;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      Eigen::MatrixXd& table = integral[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      table.resize(count, count);
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) table(i, j) = product(i, a, j, b);
      }
    }
  }
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          const auto order = [&](std::size_t k, std::size_t axis) { return static_cast<std::size_t>(orders[k][axis]); };
          matrix(i, j) += stiffness(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) *
                          integral[order(a, 0)][order(b, 0)](i / count, j / count) *
                          integral[order(a, 1)][order(b, 1)](i % count, j % count);
        }
      }
    }
  }
  Vector right(size);
  for (int i = 0; i < size; ++i) {
    right[i] =
        one[static_cast<std::size_t>(i / count)].at[0].dot(w) * one[static_cast<std::size_t>(i % count)].at[0].dot(w);
  }
  return right.dot(matrix.llt().solve(right));
}

/// What a sequence with steady ratios of its differences tends to (Aitken).
double limit_of(double first, double second, double third) {
  return third - (third - second) * (third - second) / ((third - second) - (second - first));
}

bool on_rim(Vec2 p) {
  return near_to(p.x, 0) || near_to(p.x, 1) || near_to(p.y, 0) || near_to(p.y, 1);
}

double mean_deflection(const Specimen& specimen) {
  Rig rig(specimen, bending_cloth({plate_warp, plate_weft}, plate_twist, 0, 1), [](Vec2 p) {
    return std::array<bool, 3>{true, true, on_rim(p)};
  });
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    rig.load.forces[static_cast<Eigen::Index>(3 * v + 2)] = plate_load * specimen.cloth.area_of_vertex[v];
  }
  rig.solve(plate_load * specimen.cloth.area / specimen.cloth.vertex_count, 1e-8, 50);
  double sum = 0;
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    sum += rig.at(static_cast<int>(v)).z() * specimen.cloth.area_of_vertex[v];
  }
  return sum / plate_load;
}

/// From three meshes, each in the next.
double refined(double grain) {
  std::array<double, 3> found{};
  for (std::size_t i = 0; i < 3; ++i)
    found[i] = mean_deflection(sheet(Mesh::OneWay, 1, 1, 1 / (32.0 * (1 << i)), grain));
  return limit_of(found[0], found[1], found[2]);
}

/// z = height times a x^2 + b x y + c y^2, with the edges' rotations that belong to it: what the curvatures miss, and
/// what the forces on inner vertices are beside those within.
struct PatchError {
  double curvature = 0, force = 0;
};

PatchError patch_error(Mesh mesh, double grain, double a, double b, double c) {
  constexpr double height = 1e-5;
  const Specimen specimen = sheet(mesh, 1, 1, 0.1, grain);
  Rig rig(specimen, bending_cloth({plate_warp, plate_weft}, plate_twist, 0, 1),
          [](Vec2) { return std::array<bool, 3>{}; });
  const auto slope = [&](Vec2 p) { return height * Vec2{2 * a * p.x + b * p.y, b * p.x + 2 * c * p.y}; };
  for (std::size_t v = 0; v < specimen.points.size(); ++v) {
    const Vec2 p = specimen.points[v];
    rig.put(static_cast<int>(v), {p.x, p.y, height * (a * p.x * p.x + b * p.x * p.y + c * p.y * p.y)});
  }
  const auto place = [&](int v) { return specimen.points[static_cast<std::size_t>(v)]; };
  // How far the surface's normal leans out of a triangle's over an edge of it.
  const auto lean = [&](int first, int second, int opposite) {
    const Vec2 edge = place(second) - place(first);
    const Vec2 outward = Vec2{edge.y, -edge.x} / norm(edge);
    const Vec2 arm = place(opposite) - place(first);
    const double e = rig.at(second).z() - rig.at(first).z(), o = rig.at(opposite).z() - rig.at(first).z();
    const double determinant = cross(edge, arm);
    const Vec2 flat{(e * arm.y - o * edge.y) / determinant, (o * edge.x - e * arm.x) / determinant};
    return -dot(slope(0.5 * (place(first) + place(second))) - flat, outward);
  };
  for (std::size_t h = 0; h < rig.elastic.hinges().size(); ++h) {
    const ClothHinge& hinge = rig.elastic.hinges()[h];
    const double first = lean(hinge.vertices[0], hinge.vertices[1], hinge.vertices[2]);
    const bool free = hinge.vertices[3] < 0;
    const double second = free ? 0 : lean(hinge.vertices[1], hinge.vertices[0], hinge.vertices[3]);
    rig.q[rig.elastic.unknowns().rotation(static_cast<int>(h))] = free ? first : (first - second) / 2;
  }
  const Vec2 u{std::cos(grain), std::sin(grain)}, v = perpendicular(u);
  const auto bend = [&](Vec2 p, Vec2 q) {
    return -height * (2 * a * p.x * q.x + b * (p.x * q.y + p.y * q.x) + 2 * c * p.y * q.y);
  };
  PatchError error;
  for (const Curvatures& k : rig.elastic.curvatures(rig.q)) {
    for (const double off : {k.warp - bend(u, u), k.weft - bend(v, v), k.twist - bend(u, v)}) {
      error.curvature = std::max(error.curvature, std::abs(off) / height);
    }
  }
  // The rim's rotations count from the triangles there, so a vertex opposite to the rim feels its moments.
  std::vector<bool> at_rim(specimen.points.size());
  for (const ClothHinge& hinge : rig.elastic.hinges()) {
    if (hinge.vertices[3] < 0) at_rim[static_cast<std::size_t>(hinge.vertices[2])] = true;
  }
  const Vector forces = rig.forces();
  double largest = 0;
  for (std::size_t i = 0; i < specimen.points.size(); ++i) {
    const double force = std::abs(forces[static_cast<Eigen::Index>(3 * i + 2)]);
    largest = std::max(largest, force);
    if (!at_rim[i] && !on_rim(specimen.points[i])) error.force = std::max(error.force, force);
  }
  error.force /= largest;
  return error;
}

}  // namespace

Chapter plates(Effort effort) {
  Chapter chapter{
      "Orthotropic plate",
      "D = (4, 1, 0, 0.6), simply supported unit square under the unit load, mean deflection: Navier's "
      "series; at other grain angles what meshes of n = 32, 64 and 128 tend to, which Ritz's method, always "
      "below, confirms.",
      {},
      {},
      {}};
  const int divisions = effort == Effort::Full ? 64 : 24;
  const double held = effort == Effort::Full ? 0.001 : 0.01;
  const double exact = navier();
  for (const Mesh mesh : all_meshes) {
    for (const double grain : {0.0, 90.0, 30.0, 45.0}) {
      if (effort == Effort::Quick && grain != 0 && grain != 30) continue;
      const double reference = std::fmod(grain, 90.0) == 0 ? exact
                               : effort == Effort::Full    ? refined(grain * degree)
                                                           : ritz(grain * degree, 14);
      chapter.figures.push_back(near(fmt::format("n = {}, grain at {:.0f}°, {}", divisions, grain, name(mesh)),
                                     "mean deflection × 10⁴", 1e4 * reference,
                                     1e4 * mean_deflection(sheet(mesh, 1, 1, 1.0 / divisions, grain * degree)), held));
    }
  }
  if (effort == Effort::Full) {
    PlotPanel panel{"Orthotropic plate, grain at 30°", "log2 n", "log10 error of the mean deflection", {}};
    const double reference = refined(30 * degree);
    for (const Mesh mesh : all_meshes) {
      PlotSeries line{name(mesh), {}};
      for (const int n : {8, 16, 32, 64}) {
        const double found = mean_deflection(sheet(mesh, 1, 1, 1.0 / n, 30 * degree));
        line.points.push_back({std::log2(n), std::log10(std::abs(found / reference - 1))});
      }
      panel.series.push_back(line);
    }
    chapter.pictures.push_back(
        {"plate",
         "The error falls with a power of 1.5 to 1.8 of the mesh where the grain runs askew to corners.",
         {panel}});
  }
  return chapter;
}

Chapter patches(Effort) {
  Chapter chapter{"Patch tests",
                  "Constant curvature and constant twist: every triangle has them exactly, and no inner vertex is "
                  "pulled (beside the largest force at the rim).",
                  {},
                  {},
                  {}};
  for (const Mesh mesh : all_meshes) {
    for (const double grain : {0.0, 30.0, 90.0}) {
      struct State {
        const char* name;
        double a, b, c;
      };
      for (const State& state : {State{"bend", 0.5, 0, 0.2}, State{"twist", 0, 1, 0}}) {
        const PatchError error = patch_error(mesh, grain * degree, state.a, state.b, state.c);
        const std::string subject = fmt::format("{}, grain at {:.0f}°, {}", state.name, grain, name(mesh));
        chapter.figures.push_back(within(subject, "curvature missed", 0, error.curvature, 1e-9));
        chapter.figures.push_back(within(subject, "inner force", 0, error.force, 1e-9));
      }
    }
  }
  return chapter;
}

}  // namespace toile::validation
