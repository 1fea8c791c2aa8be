#include "runtime/render/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <cstddef>
#include <limits>

namespace toile {

struct RayScene::Embree {
  // One thread builds: the tree, and with it which of two triangles a ray on their common edge meets, must not depend
  // on how many cores there are.
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  int meshes = 0;

  Embree() {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
};

namespace {

RTCRay embree_ray(const Ray& ray) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = 0;
  r.tfar = std::numeric_limits<float>::infinity();
  r.mask = ~0u;
  return r;
}

}  // namespace

RayScene::RayScene() : embree_(std::make_unique<Embree>()) {}
RayScene::~RayScene() = default;

int RayScene::add(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles) {
  const int number = embree_->meshes++;
  if (points.empty() || triangles.empty()) return number;
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), points.size()));
  for (const Vec3& p : points) {
    *vertices++ = static_cast<float>(p.x);
    *vertices++ = static_cast<float>(p.y);
    *vertices++ = static_cast<float>(p.z);
  }
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), triangles.size()));
  for (const auto& triangle : triangles) {
    for (const int corner : triangle) *indices++ = static_cast<unsigned>(corner);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(embree_->scene, geometry, static_cast<unsigned>(number));
  rtcReleaseGeometry(geometry);
  return number;
}

void RayScene::commit() {
  rtcCommitScene(embree_->scene);
}

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
  RTCRayHit query{};
  query.ray = embree_ray(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{static_cast<int>(query.hit.geomID), static_cast<int>(query.hit.primID), query.hit.u, query.hit.v,
                query.ray.tfar};
}

bool RayScene::is_blocked(const Ray& ray) const {
  RTCRay query = embree_ray(ray);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0;
}

}  // namespace toile
