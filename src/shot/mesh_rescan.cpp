#include "shot/mesh_rescan.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "core/parallel.h"

namespace overfly {
namespace {

constexpr std::size_t kBlock = 256;  // of triangles, which follow the raster's rows

// A ray starts this far above the place: above the other mesh wherever that isn't entirely wrong, and so near that
// float still counts millimetres. Where it finds nothing another one starts above everything.
constexpr double kAbove_m = 2'000.0;
constexpr double kAboveEverything_m = 30'000.0;

class Rescan {
  public:
    Rescan(const TerrainMesh& full, const SceneFrame& frame, const RayScene& other, const ClosestApproach& approach)
        : full_(&full), frame_(&frame), other_(&other), approach_(&approach) {}

    // Of one block of the full mesh's triangles: their corners and the middles of their sides along diagonals.
    [[nodiscard]] double largest_px(std::size_t block) const {
        const std::size_t begin = block * kBlock;
        const std::size_t end = std::min(begin + kBlock, full_->triangles.size());
        std::vector<Point<Scene>> places;
        for (std::size_t t = begin; t < end; ++t) add_places(full_->triangles[t], places);
        std::ranges::sort(places, [](Point<Scene> a, Point<Scene> b) {
            return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
        });
        places.erase(std::unique(places.begin(), places.end()), places.end());
        const Point<Scene> middle = places[places.size() / 2];
        double radius_m = 0.0;
        for (const Point<Scene>& p : places) radius_m = std::max(radius_m, distance(p, middle));
        // Most places are too far off the flight to matter beside the worst one so far, which this tells at once.
        const double at_most = approach_->pixels_per_metre(middle, radius_m);
        const Vector<Scene> up = frame_->local_axes(frame_->geodetic(middle)).z;
        double largest_px = 0.0;
        for (const Point<Scene>& p : places) {
            const double error_m = distance_m(p, up);
            if (error_m * at_most > largest_px)
                largest_px = std::max(largest_px, error_m * approach_->pixels_per_metre(p));
        }
        return largest_px;
    }

  private:
    void add_places(const std::array<VertexId, 3>& t, std::vector<Point<Scene>>& places) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point<Scene> a = full_->positions[t[k]], b = full_->positions[t[(k + 1) % 3]];
            const GridPlace from = full_->samples[t[k]], to = full_->samples[t[(k + 1) % 3]];
            places.push_back(a);
            if (from.column != to.column && from.row != to.row) places.push_back(a + 0.5 * (b - a));
        }
    }

    [[nodiscard]] double distance_m(Point<Scene> p, Vector<Scene> up) const {
        auto hit = other_->first_hit(p + kAbove_m * up, -up);
        if (!hit) hit = other_->first_hit(p + kAboveEverything_m * up, -up);
        if (!hit) return other_->distance_m(p);
        // Which triangle is a matter of float, how far its plane is one of double.
        const auto& t = other_->mesh().triangles[hit->triangle];
        const Point<Scene> a = other_->mesh().positions[t[0]];
        const Vector<Scene> normal = cross(other_->mesh().positions[t[1]] - a, other_->mesh().positions[t[2]] - a);
        return std::abs(dot(normal, p - a) / dot(normal, up));
    }

    const TerrainMesh* full_;
    const SceneFrame* frame_;
    const RayScene* other_;
    const ClosestApproach* approach_;
};

}  // namespace

double largest_mesh_error_px(const TerrainMesh& full, const SceneFrame& frame, const RayScene& other,
                             const ClosestApproach& approach, const Progress& progress) {
    const Rescan rescan(full, frame, other, approach);
    const std::size_t blocks = (full.triangles.size() + kBlock - 1) / kBlock;
    std::mutex mutex;
    double largest_px = 0.0, done = 0.0;
    parallel_for(blocks, [&](std::size_t block) {
        const double px = rescan.largest_px(block);
        const std::scoped_lock lock(mutex);
        largest_px = std::max(largest_px, px);
        if (progress) progress("checking the mesh", ++done, static_cast<double>(blocks));
    });
    return largest_px;
}

}  // namespace overfly
