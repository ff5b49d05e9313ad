#include "trace/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <embree3/rtcore.h>

#include "core/error.h"

namespace overfly {
namespace {

// Triangles from which on memory counts more than time: a compact hierarchy takes 30 bytes less for each, and rays a
// fifth longer.
constexpr std::size_t kHugeMesh = 8'000'000;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Vector<Scene> closest_on_triangle(Vector<Scene> p, const std::array<Vector<Scene>, 3>& corner) {
    // Ericson 2005, "Real-Time Collision Detection", section 5.1.5: by the Voronoi region that p lies in.
    const Vector<Scene> ab = corner[1] - corner[0];
    const Vector<Scene> ac = corner[2] - corner[0];
    const Vector<Scene> ap = p - corner[0];
    const double d1 = dot(ab, ap);
    const double d2 = dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return corner[0];
    const Vector<Scene> bp = p - corner[1];
    const double d3 = dot(ab, bp);
    const double d4 = dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return corner[1];
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return corner[0] + (d1 / (d1 - d3)) * ab;
    const Vector<Scene> cp = p - corner[2];
    const double d5 = dot(ab, cp);
    const double d6 = dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return corner[2];
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return corner[0] + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        return corner[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (corner[2] - corner[1]);
    }
    const double scale = 1.0 / (va + vb + vc);
    return corner[0] + (vb * scale) * ab + (vc * scale) * ac;
}

void set_rays(RTCRay16& rays, const RayPacket& packet) {
    std::memcpy(rays.org_x, packet.origin_x.data(), sizeof rays.org_x);
    std::memcpy(rays.org_y, packet.origin_y.data(), sizeof rays.org_y);
    std::memcpy(rays.org_z, packet.origin_z.data(), sizeof rays.org_z);
    std::memcpy(rays.dir_x, packet.direction_x.data(), sizeof rays.dir_x);
    std::memcpy(rays.dir_y, packet.direction_y.data(), sizeof rays.dir_y);
    std::memcpy(rays.dir_z, packet.direction_z.data(), sizeof rays.dir_z);
    std::memcpy(rays.tnear, packet.least.data(), sizeof rays.tnear);
    std::ranges::fill(rays.tfar, kInfinity);
    std::ranges::fill(rays.time, 0.0F);
    std::ranges::fill(rays.mask, ~0U);
    std::ranges::fill(rays.flags, 0U);
}

}  // namespace

struct RayScene::Embree {
    const TriangleMesh* mesh = nullptr;
    Point<Scene> centre;
    double longest_side_m = 0.0;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Embree(const TriangleMesh& terrain, Point<Scene> float_centre) : mesh(&terrain), centre(float_centre) {
        device = rtcNewDevice(nullptr);
        check(device != nullptr, "Embree gives a device");
        scene = rtcNewScene(device);
        const bool is_huge = mesh->triangles.size() > kHugeMesh;
        rtcSetSceneFlags(scene, is_huge ? RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT : RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        if (!mesh->triangles.empty()) add_mesh();
        rtcCommitScene(scene);
        check(rtcGetDeviceError(device) == RTC_ERROR_NONE, "Embree builds its hierarchy");
    }
    ~Embree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    void add_mesh();

    [[nodiscard]] Vector<Scene> corner(TriangleId triangle, std::size_t k) const {
        return mesh->positions[mesh->triangles[triangle][k]] - centre;
    }
    [[nodiscard]] RTCRayHit ray(Point<Scene> origin, Vector<Scene> direction, double least) const {
        const Vector<Scene> o = origin - centre;
        RTCRayHit hit{};
        hit.ray.org_x = static_cast<float>(o.x);
        hit.ray.org_y = static_cast<float>(o.y);
        hit.ray.org_z = static_cast<float>(o.z);
        hit.ray.dir_x = static_cast<float>(direction.x);
        hit.ray.dir_y = static_cast<float>(direction.y);
        hit.ray.dir_z = static_cast<float>(direction.z);
        hit.ray.tnear = static_cast<float>(least);
        hit.ray.tfar = kInfinity;
        hit.ray.mask = ~0U;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        return hit;
    }
};

void RayScene::Embree::add_mesh() {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh->positions.size()));
    for (const Point<Scene>& p : mesh->positions) {
        const Vector<Scene> v = p - centre;
        *vertices++ = static_cast<float>(v.x);
        *vertices++ = static_cast<float>(v.y);
        *vertices++ = static_cast<float>(v.z);
    }
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh->triangles.data(), 0,
                               sizeof mesh->triangles[0], mesh->triangles.size());
    for (const auto& t : mesh->triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = distance(mesh->positions[t[k]], mesh->positions[t[(k + 1) % 3]]);
            longest_side_m = std::max(longest_side_m, side);
        }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

RayScene::RayScene(const TriangleMesh& mesh, Point<Scene> float_centre)
    : embree_(std::make_unique<Embree>(mesh, float_centre)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

const TriangleMesh& RayScene::mesh() const { return *embree_->mesh; }
Point<Scene> RayScene::float_centre() const { return embree_->centre; }
double RayScene::longest_side_m() const { return embree_->longest_side_m; }

std::optional<RayHit> RayScene::first_hit(Point<Scene> origin, Vector<Scene> direction, double least) const {
    RTCRayHit hit = embree_->ray(origin, direction, least);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(embree_->scene, &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{hit.hit.primID, static_cast<double>(hit.ray.tfar)};
}

bool RayScene::is_blocked(Point<Scene> origin, Vector<Scene> direction, double least) const {
    RTCRay ray = embree_->ray(origin, direction, least).ray;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(embree_->scene, &context, &ray);
    return ray.tfar < 0.0F;
}

void RayScene::first_hits(RayPacket& packet) const {
    RTCRayHit16 hits;
    set_rays(hits.ray, packet);
    std::ranges::fill(hits.hit.geomID, RTC_INVALID_GEOMETRY_ID);
    std::ranges::fill(hits.hit.primID, kNone);  // stays so in a lane that hits nothing
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(packet.valid.data(), embree_->scene, &context, &hits);
    std::memcpy(packet.triangle.data(), hits.hit.primID, sizeof hits.hit.primID);
    std::memcpy(packet.depth.data(), hits.ray.tfar, sizeof hits.ray.tfar);
    std::memcpy(packet.u.data(), hits.hit.u, sizeof hits.hit.u);
    std::memcpy(packet.v.data(), hits.hit.v, sizeof hits.hit.v);
    std::memcpy(packet.normal_x.data(), hits.hit.Ng_x, sizeof hits.hit.Ng_x);
    std::memcpy(packet.normal_y.data(), hits.hit.Ng_y, sizeof hits.hit.Ng_y);
    std::memcpy(packet.normal_z.data(), hits.hit.Ng_z, sizeof hits.hit.Ng_z);
}

std::uint32_t RayScene::blocked_lanes(const RayPacket& packet) const {
    RTCRay16 rays;
    set_rays(rays, packet);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);  // without the coherent flag: with it twice the time, measured on light's rays
    rtcOccluded16(packet.valid.data(), embree_->scene, &context, &rays);
    std::uint32_t blocked = 0;
    for (std::size_t lane = 0; lane < RayPacket::kSize; ++lane) {
        if (packet.valid[lane] != 0 && rays.tfar[lane] < 0.0F) blocked |= 1U << lane;
    }
    return blocked;
}

double RayScene::distance_m(Point<Scene> p) const {
    struct Search {
        const Embree* embree;
        Vector<Scene> p;
        double nearest = std::numeric_limits<double>::infinity();
    } search{embree_.get(), p - embree_->centre};
    RTCPointQuery query{};
    query.x = static_cast<float>(search.p.x);
    query.y = static_cast<float>(search.p.y);
    query.z = static_cast<float>(search.p.z);
    query.radius = kInfinity;
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const auto visit = [](RTCPointQueryFunctionArguments* arguments) {
        auto& s = *static_cast<Search*>(arguments->userPtr);
        const TriangleId t = arguments->primID;
        const std::array<Vector<Scene>, 3> corner = {s.embree->corner(t, 0), s.embree->corner(t, 1),
                                                     s.embree->corner(t, 2)};
        s.nearest = std::min(s.nearest, length(closest_on_triangle(s.p, corner) - s.p));
        if (static_cast<float>(s.nearest) >= arguments->query->radius) return false;
        arguments->query->radius = static_cast<float>(s.nearest);
        return true;
    };
    rtcPointQuery(embree_->scene, &query, &context, visit, &search);
    return search.nearest;
}

}  // namespace overfly
