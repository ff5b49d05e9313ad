#include <fmt/format.h>

#include <optional>

#include "config/document_file.h"
#include "config/flight_place.h"
#include "config/read.h"

namespace overfly {
namespace config {
namespace {

constexpr Range kFieldOfView_deg{0.01, 179};
constexpr Range kTime_s{-1'000'000, 1'000'000};

// What keyframes take over from the flight where they say nothing.
struct FlightDefaults {
    HeightAbove above = HeightAbove::SeaLevel;
    Lens lens;
    std::optional<FlightPlace> target;
};

std::optional<FlightPlace> read_target(Section& section, HeightAbove above) {
    FlightPlace target;
    const bool given = section.section("look_at", [&](Section& s) { target = read_place(s, above); });
    return given ? std::optional(target) : std::nullopt;
}

void read_lens(Section& section, Lens& lens) {
    section.section("lens", [&](Section& s) {
        double focal_length_mm = 0.0;
        s.read("hfov_deg", lens.horizontal_fov, kFieldOfView_deg);
        const bool by_focal_length = s.read("focal_length_mm", focal_length_mm, {0.1, 100'000});
        s.read("sensor_width_mm", lens.sensor_width_mm, {0.1, 1000});
        s.allow_one_of("hfov_deg", "focal_length_mm");
        if (!by_focal_length) return;
        const Lens focal = Lens::of_focal_length(focal_length_mm, lens.sensor_width_mm);
        if (kFieldOfView_deg.contains(focal.horizontal_fov.degrees())) {
            lens = focal;
        } else {
            s.refuse("focal_length_mm", fmt::format("what gives a field of view of {} degrees with a sensor of {} mm",
                                                    kFieldOfView_deg.text(), lens.sensor_width_mm));
        }
    });
}

std::variant<Attitude, LookAt> read_aim(Section& section, const FlightDefaults& defaults) {
    Attitude attitude;
    const std::optional<FlightPlace> own_target = read_target(section, defaults.above);
    section.read("heading_deg", attitude.heading, {-720, 720});
    section.read("pitch_deg", attitude.pitch, {-90, 90});
    section.read("roll_deg", attitude.roll, {-3600, 3600});

    const bool has_attitude = section.has("heading_deg") || section.has("pitch_deg");
    if (own_target) {
        section.allow_one_of("look_at", section.has("heading_deg") ? "heading_deg" : "pitch_deg");
        return LookAt{*own_target, attitude.roll};
    }
    if (has_attitude) {
        section.require({"heading_deg", "pitch_deg"});
    } else if (defaults.target) {
        return LookAt{*defaults.target, attitude.roll};
    } else {
        section.problem(
            "got no aim, allowed 'look_at', or 'heading_deg' and 'pitch_deg', or a 'look_at' of the flight");
    }
    return attitude;
}

// `last_time_s` is the time of the keyframe before, where there is one that has a valid time.
Keyframe read_keyframe(Section& section, const FlightDefaults& defaults, std::optional<double>& last_time_s) {
    Keyframe keyframe;
    keyframe.lens = defaults.lens;
    section.require({"time_s"});
    if (section.read("time_s", keyframe.time_s, kTime_s)) {
        if (last_time_s && keyframe.time_s <= *last_time_s) {
            section.refuse("time_s", fmt::format("more than {}, the time of the keyframe before", *last_time_s));
        }
        last_time_s = keyframe.time_s;
    }
    keyframe.place = read_place(section, defaults.above);
    keyframe.aim = read_aim(section, defaults);
    read_lens(section, keyframe.lens);
    return keyframe;
}

}  // namespace

void read_flight(Section& document, FlightDocument& flight) {
    FlightDefaults defaults;
    read_height_above(document, defaults.above);
    read_lens(document, defaults.lens);
    defaults.target = read_target(document, defaults.above);

    document.require({"keyframes"});
    std::optional<double> last_time_s;
    document.each("keyframes", Section::Empty::Refused, [&](Section& item) {
        flight.keyframes.push_back(read_keyframe(item, defaults, last_time_s));
        flight.places.push_back(item.place());
    });
}

}  // namespace config

FlightDocument read_flight_document(const std::filesystem::path& file, std::span<const std::string> overrides) {
    config::Findings findings;
    FlightDocument flight{.file = file, .keyframes = {}, .places = {}};
    read_document(file, config::parse_overrides(overrides, findings.problems), findings,
                  [&](config::Section& document) { read_flight(document, flight); });
    finish(findings);
    return flight;
}

}  // namespace overfly
