// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/silhouette_facing.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/parallel.h"
#include "trace/silhouette_facing.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace silhouette_facing {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kTrianglesTogether = 16;

using Floats = hn::CappedTag<float, kTrianglesTogether>;
using Ints = hn::CappedTag<std::int32_t, kTrianglesTogether>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Ints>;

// Coordinates are off by 2^-24 of the greatest of them, differences of two by twice that, and so on: a height over a
// plane by less than this much of that coordinate, the lengths of two sides and the distance, multiplied.
constexpr float kRounding = 16.0F * 0x1p-24F;

struct Vec3 {
    V x, y, z;
};

HWY_INLINE Vec3 minus(const Vec3& a, const Vec3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE V dot(const Vec3& a, const Vec3& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE V extent(const Vec3& a) { return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z)); }
HWY_INLINE V greatest(const Vec3& a) { return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z)); }

HWY_INLINE Vec3 place(const float* places, I vertex) {
    const Floats d;
    const I at = hn::ShiftLeft<2>(vertex);
    return {hn::GatherIndex(d, places, at), hn::GatherIndex(d, places + 1, at), hn::GatherIndex(d, places + 2, at)};
}

HWY_INLINE Vec3 broadcast(const std::array<float, 3>& a) {
    const Floats d;
    return {hn::Set(d, a[0]), hn::Set(d, a[1]), hn::Set(d, a[2])};
}

// From a triangle on; returns for how many, whole vectors of them.
std::size_t classify(const FacingTask& task, TriangleId from_triangle, std::span<Facing> facing) {
    const Floats d;
    const Ints di;
    const std::size_t lanes = hn::Lanes(d);
    const auto* corners = reinterpret_cast<const std::int32_t*>(task.mesh->triangles.data() + from_triangle);
    const float* places = task.places.front().data();
    const Vec3 c0 = broadcast(task.origin[0]);
    const Vec3 c1 = broadcast(task.origin[1]);
    const Vec3 c2 = broadcast(task.origin[2]);
    const V most_motion = hn::Add(extent(c1), extent(c2));
    std::size_t done = 0;
    for (; done + lanes <= facing.size(); done += lanes) {
        I ia;
        I ib;
        I ic;
        hn::LoadInterleaved3(di, corners + 3 * done, ia, ib, ic);
        const Vec3 a = place(places, ia);
        const Vec3 ab = minus(place(places, ib), a);
        const Vec3 ac = minus(place(places, ic), a);
        const Vec3 normal = cross(ab, ac);
        const Vec3 from = minus(c0, a);
        const V h1 = dot(normal, c1);
        const V first = dot(normal, from);
        const V middle = hn::Add(first, hn::Mul(h1, hn::Set(d, 0.5F)));
        const V last = hn::Add(hn::Add(first, h1), dot(normal, c2));
        const V span = hn::Add(greatest(a), hn::Add(extent(ab), extent(ac)));
        const V sides = hn::Add(extent(ab), extent(ac));
        const V doubt =
            hn::Mul(hn::Mul(hn::Mul(hn::Set(d, kRounding), span), sides), hn::Add(extent(from), most_motion));
        const auto is_front = hn::Gt(hn::Min(hn::Min(first, middle), last), doubt);
        const auto is_back = hn::Lt(hn::Max(hn::Max(first, middle), last), hn::Neg(doubt));
        const I code =
            hn::IfThenElse(hn::RebindMask(di, is_front), hn::Set(di, static_cast<int>(Facing::Front)),
                           hn::IfThenElse(hn::RebindMask(di, is_back), hn::Set(di, static_cast<int>(Facing::Back)),
                                          hn::Set(di, static_cast<int>(Facing::Changes))));
        const hn::Rebind<std::uint8_t, Ints> d8;
        hn::StoreU(hn::DemoteTo(d8, code), d8, reinterpret_cast<std::uint8_t*>(&facing[done]));
    }
    return done;
}

}  // namespace silhouette_facing

std::size_t classify_facing(const FacingTask& task, TriangleId first, std::span<Facing> facing) {
    return silhouette_facing::classify(task, first, facing);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(classify_facing);

namespace {
constexpr std::size_t kTrianglesInTask = std::size_t{1} << 15U;
}

std::vector<Facing> facing_over(const FacingTask& task, const MotionPiece& piece) {
    std::vector<Facing> facing(task.mesh->triangles.size(), Facing::Changes);
    parallel_for((facing.size() + kTrianglesInTask - 1) / kTrianglesInTask, [&](std::size_t i) {
        const std::size_t first = i * kTrianglesInTask;
        const std::span<Facing> part =
            std::span(facing).subspan(first, std::min(kTrianglesInTask, facing.size() - first));
        const std::size_t done = HWY_DYNAMIC_DISPATCH(classify_facing)(task, static_cast<TriangleId>(first), part);
        // What floats leave open, and the last few, are decided in double.
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (k >= done || part[k] == Facing::Changes)
                part[k] = facing_over(*task.mesh, static_cast<TriangleId>(first + k), piece);
        }
    });
    return facing;
}
}  // namespace overfly
#endif
