#include "runtime/body/mesh_body.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/body/pseudonormals.hpp"
#include "runtime/body/smooth_distance.hpp"
#include "runtime/body/triangle_tree.hpp"

namespace toile {
namespace {

// Signed distances at the centres of coarse cells. Distances change no faster than the way one goes, so a centre's
// bounds those in its cell from both sides; they only save searching and never show in an answer.
class CoarseField {
 public:
  template <class Distance>
  CoarseField(const BoundingBox& bounds, Distance signed_distance) {
    const Vec3 size = bounds.high - bounds.low;
    cell_ = std::max({size.x, size.y, size.z}) / 40;
    low_ = bounds.low - 0.5 * Vec3{cell_, cell_, cell_};
    const auto cells = [&](double extent) { return static_cast<int>(std::ceil(extent / cell_)) + 1; };
    nx_ = cells(size.x), ny_ = cells(size.y), nz_ = cells(size.z);
    distances_.reserve(static_cast<std::size_t>(nx_) * ny_ * nz_);
    for (int k = 0; k < nz_; ++k) {
      for (int j = 0; j < ny_; ++j) {
        double guess = size.x + size.y + size.z;
        for (int i = 0; i < nx_; ++i) {
          distances_.push_back(signed_distance(centre(i, j, k), guess));
          guess = std::abs(distances_.back()) + 1.01 * cell_;
        }
      }
    }
  }

  struct Range {
    double low, high;
  };
  /// What the signed distance at p must lie between; p within half a cell of the bounds.
  Range at(Vec3 p) const {
    const auto index = [&](double offset, int n) { return std::clamp(static_cast<int>(offset / cell_), 0, n - 1); };
    const int i = index(p.x - low_.x, nx_), j = index(p.y - low_.y, ny_), k = index(p.z - low_.z, nz_);
    const double d = distances_[(static_cast<std::size_t>(k) * ny_ + j) * nx_ + i];
    const double way = distance(p, centre(i, j, k)) + 1e-9;
    return {d - way, d + way};
  }

 private:
  Vec3 centre(int i, int j, int k) const { return low_ + cell_ * Vec3{i + 0.5, j + 0.5, k + 0.5}; }

  Vec3 low_;
  double cell_ = 0;
  int nx_ = 0, ny_ = 0, nz_ = 0;
  std::vector<double> distances_;
};

// The centre of what lies within a centimetre of the highest point, and the height of that.
Vec3 top_of(const Body::Surface& surface) {
  double top = surface.points.front().z;
  for (const Vec3& p : surface.points) top = std::max(top, p.z);
  Vec3 sum;
  double area = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 p = surface.points[a], q = surface.points[b], r = surface.points[c];
    if (std::min({p.z, q.z, r.z}) < top - 0.01) continue;
    const double weight = norm(cross(q - p, r - p));
    sum += weight / 3 * (p + q + r);
    area += weight;
  }
  if (area > 0) return {sum.x / area, sum.y / area, top};
  const auto highest = std::max_element(surface.points.begin(), surface.points.end(),
                                        [](const Vec3& p, const Vec3& q) { return p.z < q.z; });
  return *highest;
}

class MeshBody final : public Body {
 public:
  MeshBody(BodySpec spec, LinedSurface lined)
      : spec_(std::move(spec)),
        surface_(std::move(lined.surface)),
        lines_(std::move(lined.lines)),
        tree_(surface_),
        normals_(surface_),
        smooth_(surface_, tree_),
        field_(tree_.bounds(), [this](Vec3 p, double bound) { return search(p, bound).distance; }),
        top_(top_of(surface_)) {}

  const BodySpec& spec() const override { return spec_; }
  const Surface& surface() const override { return surface_; }
  const std::vector<BodyLine>& lines() const override { return lines_; }
  Vec3 top() const override { return top_; }

  std::optional<SurfacePoint> nearest(Vec3 p, double reach) const override {
    if (!std::isfinite(p.x + p.y + p.z) || !(reach >= 0)) return std::nullopt;
    const double away2 = tree_.bounds().squared_distance(p);
    if (away2 > reach * reach) return std::nullopt;
    double bound = reach;
    if (away2 == 0) {
      const CoarseField::Range range = field_.at(p);
      if (range.low > reach) return std::nullopt;
      // Inside it must be found at any depth; elsewhere the field may bring the bound down.
      const double farthest = std::max(std::abs(range.low), std::abs(range.high));
      bound = range.low < -reach ? farthest : std::min(reach, farthest);
    }
    const SurfacePoint found = search(p, bound);
    if (found.triangle < 0 || found.distance > reach) return std::nullopt;
    return found;
  }

  std::optional<Clearance> clearance(Vec3 p, double reach) const override {
    const std::optional<SurfacePoint> surface = nearest(p, reach);
    if (!surface) return std::nullopt;
    if (surface->distance > 2 * smooth_.radius()) return Clearance{surface->distance, surface->normal, {}};
    return smooth_.at(p, surface->distance);
  }

 private:
  SurfacePoint search(Vec3 p, double bound) const {
    constexpr double on_surface = 1e-7;  // [m] closer than this the offset gives no direction
    const TriangleTree::Hit hit = tree_.nearest(p, bound);
    if (hit.triangle < 0) return {};
    const Vec3 normal = normals_.at(hit.triangle, hit.where);
    const Vec3 offset = p - hit.where.point;
    const double length = std::sqrt(hit.squared);
    const double sign = dot(offset, normal) >= 0 ? 1 : -1;
    return {hit.where.point, length > on_surface ? sign / length * offset : normal, sign * length, hit.triangle};
  }

  BodySpec spec_;
  Surface surface_;
  std::vector<BodyLine> lines_;
  TriangleTree tree_;
  Pseudonormals normals_;
  SmoothDistance smooth_;
  CoarseField field_;
  Vec3 top_;
};

}  // namespace

std::shared_ptr<const Body> make_mesh_body(BodySpec spec, LinedSurface lined) {
  return std::make_shared<MeshBody>(std::move(spec), std::move(lined));
}

}  // namespace toile
