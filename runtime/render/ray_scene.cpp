#include "runtime/render/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <cstddef>
#include <limits>

#include "runtime/library/late_library.hpp"

namespace toile {
namespace {

/// The functions of Embree that are called here.
struct EmbreeFunctions {
  LateLibrary library{TOILE_EMBREE};
  decltype(rtcNewDevice)* new_device = library.function<decltype(rtcNewDevice)>("rtcNewDevice");
  decltype(rtcReleaseDevice)* release_device = library.function<decltype(rtcReleaseDevice)>("rtcReleaseDevice");
  decltype(rtcNewScene)* new_scene = library.function<decltype(rtcNewScene)>("rtcNewScene");
  decltype(rtcReleaseScene)* release_scene = library.function<decltype(rtcReleaseScene)>("rtcReleaseScene");
  decltype(rtcSetSceneFlags)* set_scene_flags = library.function<decltype(rtcSetSceneFlags)>("rtcSetSceneFlags");
  decltype(rtcSetSceneBuildQuality)* set_scene_build_quality =
      library.function<decltype(rtcSetSceneBuildQuality)>("rtcSetSceneBuildQuality");
  decltype(rtcCommitScene)* commit_scene = library.function<decltype(rtcCommitScene)>("rtcCommitScene");
  decltype(rtcNewGeometry)* new_geometry = library.function<decltype(rtcNewGeometry)>("rtcNewGeometry");
  decltype(rtcReleaseGeometry)* release_geometry = library.function<decltype(rtcReleaseGeometry)>("rtcReleaseGeometry");
  decltype(rtcSetNewGeometryBuffer)* set_new_geometry_buffer =
      library.function<decltype(rtcSetNewGeometryBuffer)>("rtcSetNewGeometryBuffer");
  decltype(rtcCommitGeometry)* commit_geometry = library.function<decltype(rtcCommitGeometry)>("rtcCommitGeometry");
  decltype(rtcAttachGeometryByID)* attach_geometry_by_id =
      library.function<decltype(rtcAttachGeometryByID)>("rtcAttachGeometryByID");
  decltype(rtcIntersect1)* intersect = library.function<decltype(rtcIntersect1)>("rtcIntersect1");
  decltype(rtcOccluded1)* occluded = library.function<decltype(rtcOccluded1)>("rtcOccluded1");
};

const EmbreeFunctions& embree() {
  static const EmbreeFunctions opened;
  return opened;
}

}  // namespace

struct RayScene::Embree {
  // One thread builds: the tree, and with it which of two triangles a ray on their common edge meets, must not depend
  // on how many cores there are.
  RTCDevice device = embree().new_device("threads=1");
  RTCScene scene = embree().new_scene(device);
  int meshes = 0;

  Embree() {
    embree().set_scene_flags(scene, RTC_SCENE_FLAG_ROBUST);
    embree().set_scene_build_quality(scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  ~Embree() {
    embree().release_scene(scene);
    embree().release_device(device);
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
  RTCGeometry geometry = embree().new_geometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(embree().set_new_geometry_buffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), points.size()));
  for (const Vec3& p : points) {
    *vertices++ = static_cast<float>(p.x);
    *vertices++ = static_cast<float>(p.y);
    *vertices++ = static_cast<float>(p.z);
  }
  auto* indices = static_cast<unsigned*>(embree().set_new_geometry_buffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
  for (const auto& triangle : triangles) {
    for (const int corner : triangle) *indices++ = static_cast<unsigned>(corner);
  }
  embree().commit_geometry(geometry);
  embree().attach_geometry_by_id(embree_->scene, geometry, static_cast<unsigned>(number));
  embree().release_geometry(geometry);
  return number;
}

void RayScene::commit() {
  embree().commit_scene(embree_->scene);
}

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
  RTCRayHit query{};
  query.ray = embree_ray(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  embree().intersect(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{static_cast<int>(query.hit.geomID), static_cast<int>(query.hit.primID), query.hit.u, query.hit.v,
                query.ray.tfar};
}

bool RayScene::is_blocked(const Ray& ray) const {
  RTCRay query = embree_ray(ray);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  embree().occluded(embree_->scene, &context, &query);
  return query.tfar < 0;
}

}  // namespace toile
