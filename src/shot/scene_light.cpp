#include "shot/scene_light.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "io/colour_relief_file.h"
#include "shade/are_blocked.h"
#include "shade/hypsometric.h"
#include "shot/shot_facts.h"

namespace overfly {
namespace {

ColourRamp colours_of(const ShotDocument& shot, const Stage& stage) {
    const auto& heights = stage.full_mesh().elevation_m;
    const auto [lowest, highest] = std::ranges::minmax_element(heights);
    if (shot.look.colours.empty()) return hypsometric_ramp(*lowest, *highest);
    return colour_ramp(read_colour_relief(shot.look.colours),
                       {static_cast<double>(*lowest), static_cast<double>(*highest)});
}

std::uint32_t blocked(const RayScene& ground, std::span<const LightRay> rays) {
    static_assert(kRaysAtOnce <= RayPacket::kSize);
    RayPacket packet;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        packet.aim(i, rays[i].from - ground.float_centre(), rays[i].direction, true);
    }
    return ground.blocked_lanes(packet);
}

GroundLight ground_light(const ShotDocument& shot, const Stage& stage, const Daylight& day, const Progress& progress) {
    const auto are_blocked = [&ground = stage.full_rays()](std::span<const LightRay> r) { return blocked(ground, r); };
    const auto shadows = shot.look.sun_shadows == SunShadows::Baked ? GroundShadows::Baked : GroundShadows::Traced;
    return light_ground(stage.full_mesh(), colours_of(shot, stage), day, are_blocked,
                        {shadows, has_light_parts(shot.layers)}, progress);
}

}  // namespace

SceneLight::SceneLight(const ShotDocument& shot, const Stage& stage, const Daylight& day, const ShotObjects& objects,
                       const Progress& progress)
    : SceneLight(shot, stage, day, objects, ground_light(shot, stage, day, progress)) {}

SceneLight::SceneLight(const ShotDocument& shot, const Stage& stage, const Daylight& day, const ShotObjects& objects,
                       const GroundLight& light)
    : shot_(&shot),
      stage_(&stage),
      day_(&day),
      ground_(stage.full_mesh(), light),
      facts_(ground_facts(shot, stage, light, objects)) {}

SceneShader SceneLight::shader(const ShotBodies& bodies) const {
    std::vector<ShadedBody> shaded;
    for (const auto& body : bodies)
        shaded.push_back({&body->mesh(), {body->document().albedo, body->document().mirror}});
    return {stage_->mesh(), ground_, *day_, shot_->image.transparent_sky, std::move(shaded)};
}

}  // namespace overfly
