#include "shot/shot_inputs.h"

#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/version.h"
#include "io/class_raster.h"
#include "io/content_hash.h"
#include "io/mesh_file.h"

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

std::string text_of(const TimePolynomial& p) { return fmt::format("[{}]", fmt::join(p.coefficients, " ")); }

std::string text_of(const BodyMotion& motion) {
    if (const auto* p = std::get_if<BodyPolynomials>(&motion)) {
        return fmt::format("place {} {} {} {} {} {} {}\n", text_of(p->place), text_of(p->east_m), text_of(p->north_m),
                           text_of(p->up_m), text_of(p->heading_deg), text_of(p->pitch_deg), text_of(p->roll_deg));
    }
    const auto& flight = std::get<BodyFlight>(motion);
    std::string text = fmt::format("flight, delay {}\n", flight.delay_s);
    for (const Keyframe& k : flight.keyframes) text += text_of(k);
    return text;
}

// A mesh file adds itself to the files.
std::string text_of(const BodyShape& shape, std::vector<std::filesystem::path>& files) {
    if (const auto* source = std::get_if<MeshSource>(&shape)) {
        const auto inputs = mesh_file_inputs(source->file);
        files.insert(files.end(), inputs.begin(), inputs.end());
        return fmt::format("mesh of {} files, {} {}\n", inputs.size(), source->scale, static_cast<int>(source->up));
    }
    std::string text;
    if (const auto* polygons = std::get_if<std::vector<Polygon>>(&shape)) {
        for (const Polygon& polygon : *polygons) {
            text += "polygon";
            for (const Point<Scene>& p : polygon) text += fmt::format(" {},{},{}", p.x, p.y, p.z);
            text += '\n';
        }
        return text;
    }
    text = "outline";
    for (const LonLat& c : std::get<Outline>(shape)) text += fmt::format(" {},{}", c.lon.radians(), c.lat.radians());
    return text + '\n';
}

std::string text_of(const BodyDocument& body, std::vector<std::filesystem::path>& files) {
    const std::string shape = text_of(body.shape, files);
    return fmt::format("body {} {} {} mirror {} shadow {}\n", body.albedo.r, body.albedo.g, body.albedo.b, body.mirror,
                       body.shadow) +
           shape + text_of(body.motion);
}

std::string text_of(const Shutter& shutter) {
    std::string text = shutter.seconds ? fmt::format("shutter {} s", *shutter.seconds)
                                       : fmt::format("shutter {}", shutter.angle.radians());
    text += fmt::format(" {}", static_cast<int>(shutter.phase));
    if (!shutter.curve.is_box())
        text += fmt::format(" {} {}", static_cast<int>(shutter.curve.shape), shutter.curve.ramp);
    return text + '\n';
}

// Nothing of a shot without layers, so that frames from before there were any are kept. The raster adds itself to the
// files. Cryptomatte knows bodies and classes by their names.
std::string text_of_layers(const ShotDocument& shot, std::vector<std::filesystem::path>& files) {
    if (shot.layers.empty()) return "";
    std::string text = fmt::format("layer files {} layers", shot.output.layer_files);
    for (const std::string& name : names_of(shot.layers)) text += " " + name;
    text += '\n';
    if (!shot.layers.has_any({Layer::Id, Layer::Cryptomatte})) return text;
    for (const BodyDocument& body : shot.bodies) text += fmt::format("called {}\n", body.name);
    if (!shot.classes) return text;
    const auto inputs = class_raster_inputs(shot.classes->raster);
    files.insert(files.end(), inputs.begin(), inputs.end());
    text += fmt::format("classes of {} files, band {}\n", inputs.size(), shot.classes->band);
    for (const auto& [value, name] : shot.classes->names) text += fmt::format("class {} {}\n", value, name);
    return text;
}

}  // namespace

std::string shot_inputs_hash(const ShotDocument& shot, const std::string& scene_hash) {
    std::string text = fmt::format("overfly {}\nscene {}\n", kVersion, scene_hash);
    for (const Keyframe& k : shot.flight.keyframes) text += text_of(k);
    const Look& look = shot.look.look;
    text += fmt::format("frames {} {}/{} {}\n", shot.frames.first, shot.frames.rate.numerator,
                        shot.frames.rate.denominator, shot.frames.start_s);
    for (const FlightSpeed& s : shot.frames.speeds) text += fmt::format("speed {} {}\n", s.frame, s.speed);
    // Headers are part of a frame. Nothing without a date, so that frames from before there was one are kept.
    if (shot.frames.date) text += fmt::format("date {}\n", iso_text(*shot.frames.date));
    text += fmt::format("image {}x{} {}\n", shot.image.width, shot.image.height, shot.image.transparent_sky);
    text += text_of(shot.shutter);
    const double filter_px = shot.image.filter_width_px.value_or(usual_width_px(shot.image.filter));
    if (shot.image.filter != FilterKind::Box || filter_px != 1.0)
        text += fmt::format("filter {} {}\n", static_cast<int>(shot.image.filter), filter_px);
    const TracerKind tracer = shot.sampling.tracer;
    text += fmt::format("sampling {} {} {} {} {}\n", static_cast<int>(tracer),
                        tracer != TracerKind::Discrete ? shot.sampling.lines : 0,
                        tracer == TracerKind::Discrete || tracer == TracerKind::Hybrid ? shot.sampling.samples : 0,
                        tracer == TracerKind::Interval || tracer == TracerKind::Kinetic ? shot.sampling.drift_px : 0.0,
                        shot.sampling.error);
    text += fmt::format("look {} {} {} {} {} {}\n", look.sun_azimuth.radians(), look.sun_elevation.radians(),
                        look.sun_strength, look.sky_strength, look.visibility_m, look.exposure_stops);
    text += fmt::format("motion {} mesh {}\n", shot.motion_bound_px, shot.mesh_pixel_error);
    text += fmt::format("mirrors {} shadows {}\n", shot.sampling.mirror_depth, static_cast<int>(shot.look.sun_shadows));
    // What is stored without loss is the same frame however it is compressed.
    const FrameStorage& storage = shot.output.storage;
    if (is_lossy(storage.beauty))
        text += fmt::format("compression {} {}\n", static_cast<int>(storage.beauty), storage.quality);
    std::vector<std::filesystem::path> files;
    for (const BodyDocument& body : shot.bodies) text += text_of(body, files);
    if (!shot.look.colours.empty()) files.push_back(shot.look.colours);
    text += text_of_layers(shot, files);
    return content_hash(files, text);
}

}  // namespace overfly
