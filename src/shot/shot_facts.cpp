#include "shot/shot_facts.h"

#include <cmath>

#include "shade/parallel_blocks.h"
#include "shot/shot_motion.h"
#include "shot/shot_sight.h"

namespace overfly {
namespace {

// The frames with one more at each end.
std::vector<PlannedFrame> with_neighbours(std::span<const PlannedFrame> frames) {
    const auto shifted = [](PlannedFrame frame, double by_s) {
        frame.time_s += by_s;
        frame.exposure = {frame.exposure.begin_s + by_s, frame.exposure.end_s + by_s};
        return frame;
    };
    std::vector<PlannedFrame> out = {shifted(frames.front(), -frames.front().lasts_s)};
    out.insert(out.end(), frames.begin(), frames.end());
    out.push_back(shifted(frames.back(), frames.back().lasts_s));
    return out;
}

std::vector<Float4> of_each(std::size_t count, const auto& value) {
    std::vector<Float4> out(count);
    parallel_blocks(count, "", {}, [&](std::size_t i) { out[i] = value(i); });
    return out;
}

}  // namespace

Float4 geodetic_fact(const Stage& stage, Point<Scene> p) {
    const Geodetic place = stage.frame().geodetic(p);
    const Geodetic& origin = stage.frame().origin();
    const double lon_deg = std::remainder(place.lon.degrees() - origin.lon.degrees(), 360.0);
    const double sea_level_m = stage.sea_level_m(place.lon, place.lat);
    return Float4{static_cast<float>(lon_deg), static_cast<float>(place.lat.degrees() - origin.lat.degrees()),
                  static_cast<float>(place.height_m), static_cast<float>(place.height_m - sea_level_m)};
}

bool has_light_parts(LayerSet layers) { return layers.has_any({Layer::Albedo, Layer::Direct, Layer::Shadow}); }

GroundFacts ground_facts(const ShotDocument& shot, const Stage& stage, const GroundLight& light,
                         const ShotObjects& objects) {
    if (shot.layers.empty()) return {};
    const TerrainMesh& mesh = stage.full_mesh();
    const Quantities wanted = Quantities(shot.layers);
    const SampleGrid grid(mesh);
    GroundFacts facts(grid);
    const auto add = [&](GroundFacts::Kind kind, const auto& at_vertex) {
        facts.add(kind, grid, of_each(mesh.positions.size(), at_vertex));
    };
    if (wanted.has(Quantity::Normal)) {
        const std::vector<Vector<Scene>> normals = vertex_normals(mesh);
        add(GroundFacts::Kind::Normal, [&](std::size_t v) { return four(normals[v]); });
    }
    if (wanted.has(Quantity::Geodetic))
        add(GroundFacts::Kind::Geodetic, [&](std::size_t v) { return geodetic_fact(stage, mesh.positions[v]); });
    if (wanted.has(Quantity::Albedo))
        add(GroundFacts::Kind::Albedo, [&](std::size_t v) { return four(light.albedo[v]); });
    if (wanted.has(Quantity::Direct) || wanted.has(Quantity::Shadow))
        add(GroundFacts::Kind::Sunlight, [&](std::size_t v) { return four(light.sunlight[v]); });
    if (!objects.of_vertices().empty()) facts.add_objects(grid, objects.of_vertices());
    return facts;
}

ShotFacts::ShotFacts(const ShotDocument& shot, const Stage& stage, const CameraPath& path,
                     std::span<const PlannedFrame> frames, const ShotBodies& bodies, const ShotObjects& objects) {
    sources_.kinds = FactKinds(shot.layers);
    sources_.px_per_film = 0.5 * shot.image.width;
    sources_.geodetic = [&stage](Point<Scene> p) { return geodetic_fact(stage, p); };
    sources_.surfaces.assign(objects.of_surfaces().begin(), objects.of_surfaces().end());
    if (!sources_.kinds.quantities.has(Quantity::Motion)) return;
    ShotDocument without_mirrors = shot;
    without_mirrors.sampling.mirror_depth = 0;
    sight_ =
        make_sight(without_mirrors, path, shot_motion(shot, path, with_neighbours(frames), stage), {stage, bodies, {}});
    sources_.sight = &sight_;
}

}  // namespace overfly
