#include "shot/shot_inputs.h"

#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/version.h"
#include "io/content_hash.h"

namespace overfly {
namespace {

std::string text_of(const FlightPlace& p) {
    return fmt::format("{},{},{},{};", p.lon.radians(), p.lat.radians(), p.height_m, static_cast<int>(p.above));
}

std::string text_of(const Keyframe& k) {
    std::string text = fmt::format("keyframe {} {} lens {} {} ", k.time_s, text_of(k.place),
                                   k.lens.horizontal_fov.radians(), k.lens.sensor_width_mm);
    if (const auto* look_at = std::get_if<LookAt>(&k.aim)) {
        return text + fmt::format("look_at {} {}\n", text_of(look_at->target), look_at->roll.radians());
    }
    const Attitude& a = std::get<Attitude>(k.aim);
    return text + fmt::format("attitude {} {} {}\n", a.heading.radians(), a.pitch.radians(), a.roll.radians());
}

}  // namespace

std::string shot_inputs_hash(const ShotDocument& shot, const std::string& scene_hash) {
    std::string text = fmt::format("overfly {}\nscene {}\n", kVersion, scene_hash);
    for (const Keyframe& k : shot.flight.keyframes) text += text_of(k);
    const Look& look = shot.look.look;
    text += fmt::format("frames {} {}/{} {}\n", shot.frames.first, shot.frames.rate.numerator,
                        shot.frames.rate.denominator, shot.frames.start_s);
    text += fmt::format("image {}x{} {}\n", shot.image.width, shot.image.height, shot.image.transparent_sky);
    text += fmt::format("shutter {} {}\n", shot.shutter.angle.radians(), static_cast<int>(shot.shutter.phase));
    text += fmt::format("sampling {} {}\n", static_cast<int>(shot.sampling.tracer),
                        shot.sampling.tracer == TracerKind::Discrete ? shot.sampling.samples : shot.sampling.lines);
    text += fmt::format("look {} {} {} {} {} {}\n", look.sun_azimuth.radians(), look.sun_elevation.radians(),
                        look.sun_strength, look.sky_strength, look.visibility_m, look.exposure_stops);
    text += fmt::format("motion {}\n", shot.motion_bound_px);
    std::vector<std::filesystem::path> files;
    if (!shot.look.colours.empty()) files.push_back(shot.look.colours);
    return content_hash(files, text);
}

}  // namespace overfly
