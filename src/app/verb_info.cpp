#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/channel_table.h"
#include "app/verbs.h"
#include "config/read.h"
#include "core/error.h"
#include "io/frame_channels.h"
#include "io/frame_facts.h"
#include "io/layer_attributes.h"

namespace overfly {
namespace {

using Json = nlohmann::ordered_json;

struct FrameInfo {
    FrameFacts facts;
    std::vector<ChannelInfo> channels;
    std::vector<ObjectCoverage> objects;
};

// Documents have verbs that tell more of them than this one could.
void refuse_documents(const std::filesystem::path& file) {
    if (file.extension() != ".yaml" && file.extension() != ".yml") return;
    switch (document_kind(file)) {
        case DocumentKind::Terrain:
            throw UserError({file}, "a terrain document; overfly import tells what it holds");
        case DocumentKind::Flight:
            throw UserError({file}, "a flight document; overfly path tells what it holds");
        case DocumentKind::Shot:
            throw UserError({file}, "a shot document; overfly path tells of its flight");
        case DocumentKind::Batch:
            throw UserError({file}, "a batch document, a list of shots; overfly info is for frames");
    }
}

FrameInfo frame_info(const std::filesystem::path& file) {
    refuse_documents(file);
    FrameFacts facts = read_frame_facts(file);
    const FrameChannels channels = read_channels(file);
    std::vector<ObjectCoverage> objects = object_coverage(channels, facts.objects);
    return {std::move(facts), channel_infos(channels), std::move(objects)};
}

// Without a sign before zero.
double rounded(double value, double decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale + 0.0;
}

class Lines {
  public:
    void add(const char* what, const std::string& value) {
        if (!value.empty()) text_ += fmt::format("{:<18}{}\n", what, value);
    }
    void add(const char* what, const NamedDocument& document) {
        if (document.name.empty()) return;
        add(what,
            document.sha256.empty() ? document.name : fmt::format("{}  SHA-256 {}", document.name, document.sha256));
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::string text_;
};

std::string rate_text(const std::optional<FrameRate>& rate) {
    if (!rate) return "";
    if (rate->denominator == 1) return fmt::format("{} frames per second", rate->numerator);
    return fmt::format("{}/{} = {:.6g} frames per second", rate->numerator, rate->denominator, rate->per_s());
}

std::string time_code_text(const std::optional<SmpteTime>& t) {
    if (!t) return "";
    return fmt::format("{:02}:{:02}:{:02}:{:02}{}", t->hours, t->minutes, t->seconds, t->frame,
                       t->second_of_pair ? " (second field)" : "");
}

void add_time(Lines& lines, const FrameFacts& f) {
    if (f.number) lines.add("frame", fmt::format("{}", *f.number));
    if (f.time_s) lines.add("time", fmt::format("{:.6f} s of the flight", *f.time_s));
    lines.add("date", f.date);
    lines.add("rate", rate_text(f.rate));
    if (f.capture_rate != f.rate) lines.add("capture rate", rate_text(f.capture_rate));
    lines.add("time code", time_code_text(f.time_code));
    if (f.exposure_s) {
        lines.add("exposure",
                  fmt::format("{:.6g} s{}", *f.exposure_s,
                              f.shutter_angle_deg ? fmt::format(", {:g} degrees", *f.shutter_angle_deg) : ""));
    }
}

void add_camera(Lines& lines, const FrameFacts& f) {
    if (f.camera_place) {
        lines.add("place",
                  fmt::format("lon {:.7f} lat {:.7f}, {:.2f} m above the ellipsoid{}", f.camera_place->lon.degrees(),
                              f.camera_place->lat.degrees(), f.camera_place->height_m,
                              f.altitude_m ? fmt::format(", {:.2f} m above sea level", *f.altitude_m) : ""));
    }
    if (const auto attitude = camera_attitude(f)) {
        lines.add("attitude", fmt::format("heading {:.3f}, pitch {:.3f}, roll {:.3f} degrees",
                                          rounded(attitude->heading.degrees(), 3),
                                          rounded(attitude->pitch.degrees(), 3), rounded(attitude->roll.degrees(), 3)));
    }
    if (f.focal_length_mm && f.sensor_width_mm) {
        const Lens lens = Lens::of_focal_length(*f.focal_length_mm, *f.sensor_width_mm);
        lines.add("lens", fmt::format("{:.4g} mm before a sensor {:g} mm wide, {:.3f} degrees across",
                                      *f.focal_length_mm, *f.sensor_width_mm, lens.horizontal_fov.degrees()));
    }
    if (f.scene_origin) {
        lines.add("scene origin",
                  fmt::format("lon {:.7f} lat {:.7f}, {:.2f} m above the ellipsoid", f.scene_origin->lon.degrees(),
                              f.scene_origin->lat.degrees(), f.scene_origin->height_m));
    }
}

std::string info_text(const FrameInfo& info) {
    const FrameFacts& f = info.facts;
    Lines lines;
    lines.add("size", fmt::format("{} x {}", f.width, f.height));
    add_time(lines, f);
    add_camera(lines, f);
    lines.add("shot", f.shot);
    lines.add("terrain", f.terrain);
    lines.add("flight", f.flight);
    lines.add("inputs", f.inputs);
    lines.add("software", f.software);
    lines.add("layer files", fmt::format("{}", fmt::join(names_of(f.layer_files), " ")));
    return lines.text() + channel_table(info.channels) + object_table(info.objects);
}

template <class Value>
Json json_of(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

Json rate_json(const std::optional<FrameRate>& rate) {
    return rate ? Json{rate->numerator, rate->denominator} : Json();
}

Json place_json(const std::optional<Geodetic>& place) {
    if (!place) return {};
    return {{"lon_deg", place->lon.degrees()}, {"lat_deg", place->lat.degrees()}, {"height_m", place->height_m}};
}

Json attitude_json(const std::optional<Attitude>& attitude) {
    if (!attitude) return {};
    return {{"heading_deg", attitude->heading.degrees()},
            {"pitch_deg", attitude->pitch.degrees()},
            {"roll_deg", attitude->roll.degrees()}};
}

Json document_json(const NamedDocument& document) { return {{"name", document.name}, {"sha256", document.sha256}}; }

Json info_json(const FrameInfo& info) {
    const FrameFacts& f = info.facts;
    return {
        {"width", f.width},
        {"height", f.height},
        {"frame", json_of(f.number)},
        {"time_s", json_of(f.time_s)},
        {"date", f.date},
        {"rate", rate_json(f.rate)},
        {"capture_rate", rate_json(f.capture_rate)},
        {"time_code", time_code_text(f.time_code)},
        {"exposure_s", json_of(f.exposure_s)},
        {"shutter_angle_deg", json_of(f.shutter_angle_deg)},
        {"camera",
         {{"place", place_json(f.camera_place)},
          {"altitude_m", json_of(f.altitude_m)},
          {"attitude", attitude_json(camera_attitude(f))},
          {"focal_length_mm", json_of(f.focal_length_mm)},
          {"sensor_width_mm", json_of(f.sensor_width_mm)}}},
        {"scene_origin", place_json(f.scene_origin)},
        {"documents",
         {{"shot", document_json(f.shot)}, {"terrain", document_json(f.terrain)}, {"flight", document_json(f.flight)}}},
        {"inputs", f.inputs},
        {"software", f.software},
        {"layer_files", names_of(f.layer_files)},
        {"channels", channels_json(info.channels)},
        {"objects", objects_json(info.objects)}};
}

int run_info(const std::string& file, const CommonOptions& common) {
    Console console(common);
    const FrameInfo info = frame_info(file);
    console.result(info_text(info), info_json(info));
    return kDone;
}

}  // namespace

RunVerb add_info(CLI::App& verb) {
    const auto file = std::make_shared<std::string>();
    verb.add_option("frame", *file, "an OpenEXR file")->required();
    return [file](const CommonOptions& common) { return run_info(*file, common); };
}

}  // namespace overfly
