#include "shot/stage.h"

#include <utility>

#include "core/error.h"
#include "flight/check_flight.h"
#include "io/geoid_file.h"

namespace overfly {
namespace {

// Rays that look for the ground start above any terrain on Earth.
constexpr double kAboveEverything_m = 12'000.0;

Point<Scene> float_centre(const SceneFrame& frame, const std::optional<Geodetic>& around) {
    return around ? frame.scene(*around) : Point<Scene>{};
}

}  // namespace

Stage::Stage(PreparedTerrain terrain, const std::optional<Geodetic>& around)
    : terrain_(std::move(terrain)),
      frame_(terrain_.scene.origin),
      full_rays_(std::in_place, terrain_.scene.mesh, float_centre(frame_, around)),
      geoid_(read_egm96()) {}

const RayScene& Stage::full_rays() const {
    check(full_rays_.has_value(), "the full mesh is still there");
    return *full_rays_;
}

void Stage::look_at(TerrainMesh flight_mesh) { flight_.emplace(std::move(flight_mesh), full_rays().float_centre()); }

void Stage::drop_full_mesh() {
    if (!flight_) return;
    full_rays_.reset();
    terrain_.scene.mesh = {};
}

std::optional<double> Stage::ground_height_m(Angle lon, Angle lat) const {
    const Point<Scene> from = frame_.scene({lon, lat, kAboveEverything_m});
    const Vector<Scene> up = frame_.local_axes({lon, lat, 0.0}).z;
    const auto hit = full_rays().first_hit(from, -up);
    if (!hit) return std::nullopt;
    return kAboveEverything_m - hit->distance;
}

Surroundings Stage::surroundings() const {
    return {[this](Angle lon, Angle lat) { return ground_height_m(lon, lat); },
            [this](Angle lon, Angle lat) { return sea_level_m(lon, lat); },
            [this](Point<Scene> p) { return full_rays().distance_m(p); }};
}

std::optional<Geodetic> middle_of(const FlightDocument& flight) {
    if (flight.keyframes.empty()) return std::nullopt;
    Vector<Ecef> sum;
    for (const Keyframe& k : flight.keyframes) {
        const Point<Ecef> p = ecef({k.place.lon, k.place.lat, k.place.height_m});
        sum = sum + Vector<Ecef>{p.x, p.y, p.z};
    }
    const Vector<Ecef> mean = sum / static_cast<double>(flight.keyframes.size());
    return geodetic(Point<Ecef>{mean.x, mean.y, mean.z});
}

CameraPath make_path(const FlightDocument& flight, const Stage& stage) {
    const Surroundings surroundings = stage.surroundings();
    std::vector<Problem> problems = check_keyframes(flight.keyframes, flight.places, surroundings);
    if (!problems.empty()) throw UserError(std::move(problems));
    return {flight.keyframes, stage.frame(), surroundings};
}

}  // namespace overfly
