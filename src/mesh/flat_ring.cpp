#include "mesh/flat_ring.h"

#include <geos_c.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "core/error.h"

namespace overfly {
namespace {

// GEOS with a state of its own, so that threads don't meet. It tells of errors by what its functions return; the
// messages, which it would hand to a callback, go nowhere.
class Geos {
  public:
    Geos() : handle_(GEOS_init_r()) { check(handle_ != nullptr, "GEOS starts"); }
    ~Geos() { GEOS_finish_r(handle_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    [[nodiscard]] GEOSContextHandle_t handle() const { return handle_; }

    struct Destroy {
        GEOSContextHandle_t handle;
        void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

    [[nodiscard]] Geometry owned(GEOSGeometry* g) const {
        check(g != nullptr, "GEOS makes the geometry");
        return {g, Destroy{handle_}};
    }

    [[nodiscard]] Geometry polygon(FlatRing ring) const {
        GEOSCoordSequence* points = GEOSCoordSeq_create_r(handle_, static_cast<unsigned>(ring.size() + 1), 2);
        check(points != nullptr, "GEOS makes room for a ring");
        for (std::size_t i = 0; i <= ring.size(); ++i) {
            const FlatPoint& p = ring[i % ring.size()];
            GEOSCoordSeq_setXY_r(handle_, points, static_cast<unsigned>(i), p.x, p.y);
        }
        // Each owns what it is made of.
        return owned(GEOSGeom_createPolygon_r(handle_, GEOSGeom_createLinearRing_r(handle_, points), nullptr, 0));
    }

    // The corners of a polygon's outer ring, the first not repeated.
    [[nodiscard]] std::vector<FlatPoint> corners(const GEOSGeometry* polygon) const {
        const GEOSCoordSequence* points = sequence(polygon);
        unsigned size = 0;
        GEOSCoordSeq_getSize_r(handle_, points, &size);
        std::vector<FlatPoint> result(size - 1);
        for (unsigned i = 0; i + 1 < size; ++i) GEOSCoordSeq_getXY_r(handle_, points, i, &result[i].x, &result[i].y);
        return result;
    }

    [[nodiscard]] bool is_anticlockwise(const GEOSGeometry* polygon) const {
        char result = 0;
        check(GEOSCoordSeq_isCCW_r(handle_, sequence(polygon), &result) == 1, "GEOS tells a ring's direction");
        return result != 0;
    }

  private:
    [[nodiscard]] const GEOSCoordSequence* sequence(const GEOSGeometry* polygon) const {
        return GEOSGeom_getCoordSeq_r(handle_, GEOSGetExteriorRing_r(handle_, polygon));
    }

    GEOSContextHandle_t handle_;
};

// The place in the ring of each of its points, found by what they are: GEOS hands out copies, to the bit.
class PlacesInRing {
  public:
    explicit PlacesInRing(FlatRing ring) : ring_(ring), by_point_(ring.size()) {
        std::iota(by_point_.begin(), by_point_.end(), std::size_t{0});
        std::ranges::sort(by_point_, {}, [&](std::size_t i) { return key(ring_[i]); });
    }

    [[nodiscard]] std::size_t of(const FlatPoint& p) const {
        const auto found =
            std::ranges::lower_bound(by_point_, key(p), {}, [&](std::size_t i) { return key(ring_[i]); });
        check(found != by_point_.end() && ring_[*found] == p, "a triangle's corners are corners of its polygon");
        return *found;
    }

  private:
    static std::pair<double, double> key(const FlatPoint& p) { return {p.x, p.y}; }

    FlatRing ring_;
    std::vector<std::size_t> by_point_;
};

}  // namespace

std::optional<FlatPoint> crossing(FlatRing ring) {
    const Geos geos;
    const Geos::Geometry polygon = geos.polygon(ring);
    GEOSGeometry* where = nullptr;
    const char valid = GEOSisValidDetail_r(geos.handle(), polygon.get(), 0, nullptr, &where);
    check(valid == 0 || valid == 1, "GEOS tells whether a ring crosses itself");
    if (valid == 1) return std::nullopt;
    const Geos::Geometry point = geos.owned(where);
    FlatPoint result;
    GEOSGeomGetX_r(geos.handle(), point.get(), &result.x);
    GEOSGeomGetY_r(geos.handle(), point.get(), &result.y);
    return result;
}

std::vector<std::array<std::size_t, 3>> triangulate(FlatRing ring) {
    const Geos geos;
    const Geos::Geometry polygon = geos.polygon(ring);
    const bool anticlockwise = geos.is_anticlockwise(polygon.get());
    const Geos::Geometry parts = geos.owned(GEOSConstrainedDelaunayTriangulation_r(geos.handle(), polygon.get()));
    const PlacesInRing places(ring);
    std::vector<std::array<std::size_t, 3>> triangles;
    for (int i = 0; i < GEOSGetNumGeometries_r(geos.handle(), parts.get()); ++i) {
        const GEOSGeometry* part = GEOSGetGeometryN_r(geos.handle(), parts.get(), i);
        const std::vector<FlatPoint> corners = geos.corners(part);
        check(corners.size() == 3, "a triangle has three corners");
        std::array<std::size_t, 3> triangle{places.of(corners[0]), places.of(corners[1]), places.of(corners[2])};
        if (geos.is_anticlockwise(part) != anticlockwise) std::swap(triangle[1], triangle[2]);
        triangles.push_back(triangle);
    }
    check(triangles.size() + 2 == ring.size(), "a ring is cut into two triangles less than it has corners");
    return triangles;
}

}  // namespace overfly
