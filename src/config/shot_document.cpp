#include <string>

#include "config/bodies.h"
#include "config/body_flights.h"
#include "config/document_file.h"
#include "config/frame_rate.h"
#include "config/layer_keys.h"
#include "config/output_keys.h"
#include "config/read.h"

namespace overfly {
namespace config {
namespace {

// How fast a flight may go by.
constexpr double kFastest = 1000.0;

constexpr double kMostMemory_gb = 100'000.0;

void read_speeds(Section& section, std::vector<FlightSpeed>& speeds) {
    section.allow_one_of("speed", "ramp");
    double speed = 1.0;
    if (section.read("speed", speed, Range::above(0, kFastest))) speeds = {{0.0, speed}};
    section.each("ramp", Section::Empty::Refused, [&](Section& point) {
        FlightSpeed& at = speeds.emplace_back();
        point.require({"frame", "speed"});
        const bool is_read = point.read("frame", at.frame, {-10'000'000, 20'000'000});
        point.read("speed", at.speed, Range::above(0, kFastest));
        if (!is_read || speeds.size() < 2) return;
        if (at.frame <= speeds[speeds.size() - 2].frame) point.refuse("frame", "a later one than that before");
    });
}

void read_date(Section& section, std::optional<LocalTime>& date) {
    std::string text;
    if (!section.read("date", text, kLocalTimeAllowed)) return;
    date = parse_local_time(text);
    if (!date) section.refuse("date", kLocalTimeAllowed);
}

void read_frames(Section& section, FramesDocument& frames) {
    section.read("first", frames.first, {0, 9'999'999});
    section.read("count", frames.count, {1, 10'000'000});
    section.read("start_s", frames.start_s, {-1'000'000, 1'000'000});
    read_speeds(section, frames.speeds);
    read_date(section, frames.date);
    std::string rate_text;
    if (!section.read("rate", rate_text, kFrameRateAllowed)) return;
    const std::optional<FrameRate> rate = parse_frame_rate(rate_text);
    if (!rate) section.refuse("rate", kFrameRateAllowed);
    frames.rate = rate.value_or(FrameRate{});
}

void read_image(Section& section, ImageDocument& image) {
    section.read("width", image.width, {1, 65536});
    section.read("height", image.height, {1, 65536});
    section.read("transparent_sky", image.transparent_sky);
    static constexpr NamedValue<FilterKind> kFilters[] = {{"box", FilterKind::Box},
                                                          {"tent", FilterKind::Tent},
                                                          {"blackman-harris", FilterKind::BlackmanHarris},
                                                          {"mitchell", FilterKind::Mitchell}};
    section.read("filter", image.filter, kFilters);
    double width_px = 0.0;
    if (section.read("filter_width_px", width_px, {0.5, 16})) image.filter_width_px = width_px;
}

void read_shutter(Section& section, Shutter& shutter) {
    static constexpr NamedValue<Shutter::Phase> kPhases[] = {{"start", Shutter::Phase::Start},
                                                             {"centre", Shutter::Phase::Centre},
                                                             {"center", Shutter::Phase::Centre},
                                                             {"end", Shutter::Phase::End}};
    static constexpr NamedValue<ShutterCurve::Shape> kShapes[] = {{"box", ShutterCurve::Shape::Box},
                                                                  {"trapezoid", ShutterCurve::Shape::Trapezoid},
                                                                  {"smooth", ShutterCurve::Shape::Smooth}};
    section.allow_one_of("angle_deg", "seconds");
    section.read("angle_deg", shutter.angle, {0, 360});
    double seconds = 0.0;
    if (section.read("seconds", seconds, {0, 1000})) shutter.seconds = seconds;
    section.read("phase", shutter.phase, kPhases);
    const bool is_box =
        !section.has("shape") || (section.read("shape", shutter.curve.shape, kShapes) && shutter.curve.is_box());
    section.read("ramp", shutter.curve.ramp, Range::above(0, 0.5));
    if (is_box) section.refuse("ramp", "only with a shape of trapezoid or smooth");
}

void read_sampling(Section& section, SamplingDocument& sampling) {
    static constexpr NamedValue<TracerKind> kTracers[] = {{"kinetic", TracerKind::Kinetic},
                                                          {"interval", TracerKind::Interval},
                                                          {"discrete", TracerKind::Discrete},
                                                          {"hybrid", TracerKind::Hybrid}};
    section.read("tracer", sampling.tracer, kTracers);
    section.read("lines", sampling.lines, {1, 1024});
    section.read("drift_px", sampling.drift_px, {0, 64});
    section.read("error", sampling.error, {0, 1});
    section.read("samples", sampling.samples, {1, 65536});
    section.read("mirror_depth", sampling.mirror_depth, {0, 8});
}

void read_look(Section& section, LookDocument& document) {
    static constexpr NamedValue<SunShadows> kShadows[] = {{"baked", SunShadows::Baked}, {"exact", SunShadows::Exact}};
    Look& look = document.look;
    section.read("colours", document.colours, PathTo::File);
    section.section("sun", [&](Section& sun) {
        sun.read("azimuth_deg", look.sun_azimuth, {-360, 360});
        sun.read("elevation_deg", look.sun_elevation, {-5, 90});
        sun.read("shadows", document.sun_shadows, kShadows);
    });
    section.read("sun_strength", look.sun_strength, {0, 100});
    section.read("sky_strength", look.sky_strength, {0, 100});
    double visibility_km = 0.0;
    if (section.read("visibility_km", visibility_km, {0, 100'000})) look.visibility_m = 1000.0 * visibility_km;
    section.read("exposure_stops", look.exposure_stops, {-20, 20});
}

}  // namespace

void read_shot(Section& document, ShotDocument& shot) {
    document.require({"terrain", "flight"});
    document.read("terrain", shot.terrain.file, PathTo::File);
    document.read("flight", shot.flight.file, PathTo::File);
    document.section("frames", [&](Section& s) { read_frames(s, shot.frames); });
    document.section("image", [&](Section& s) { read_image(s, shot.image); });
    document.section("shutter", [&](Section& s) { read_shutter(s, shot.shutter); });
    document.section("sampling", [&](Section& s) { read_sampling(s, shot.sampling); });
    document.section("look", [&](Section& s) { read_look(s, shot.look); });
    read_bodies(document, shot.bodies);
    read_layers(document, shot.layers);
    read_classes(document, shot.classes);
    document.section("output", [&](Section& s) { read_output(s, shot.output); });
    document.section("motion", [&](Section& s) { s.read("bound_px", shot.motion_bound_px, Range::above(0, 1)); });
    document.section("mesh", [&](Section& s) { s.read("pixel_error", shot.mesh_pixel_error, {0, 100}); });
    document.read("memory_gb", shot.memory_gb, Range::above(0, kMostMemory_gb));
}

}  // namespace config

ShotDocument read_shot_document(const std::filesystem::path& file, std::span<const std::string> overrides) {
    config::Findings findings;
    std::vector<config::Override> own = config::parse_overrides(overrides, findings.problems);
    const std::vector<config::Override> of_terrain = take_overrides_inside("terrain", own);
    const std::vector<config::Override> of_flight = take_overrides_inside("flight", own);
    const std::vector<config::BodyFlightOverride> of_body_flights = take_body_flight_overrides(own);

    ShotDocument shot;
    shot.file = file;
    shot.output.folder = std::filesystem::path("out") / file.stem();
    shot.output.name = file.stem().string();
    read_document(file, own, findings, [&](config::Section& document) { read_shot(document, shot); });
    if (!shot.terrain.file.empty()) {
        read_document(shot.terrain.file, of_terrain, findings,
                      [&](config::Section& document) { read_terrain(document, shot.terrain); });
    }
    if (!shot.flight.file.empty()) {
        read_document(shot.flight.file, of_flight, findings,
                      [&](config::Section& document) { read_flight(document, shot.flight); });
    }
    read_body_flights(shot.bodies, of_body_flights, findings);
    finish(findings);
    return shot;
}

}  // namespace overfly
