#include "io/manifest_file.h"

#include <algorithm>
#include <fstream>
#include <span>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/output_file.h"

namespace overfly {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "overfly manifest";
constexpr int kVersion = 1;

template <class Value>
Json json_of(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

std::optional<double> number_of(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Json json_of(const FrameStatistics& s) {
    Json luminance;
    if (s.luminance) {
        luminance = {{"min", s.luminance->least}, {"mean", s.luminance->mean}, {"max", s.luminance->most}};
    }
    return {{"luminance", luminance}, {"mean_alpha", json_of(s.mean_alpha)}, {"nearest_m", json_of(s.nearest_m)}};
}

FrameStatistics statistics_of(const Json& json) {
    FrameStatistics s;
    if (const Json& l = json.at("luminance"); !l.is_null()) {
        s.luminance = {l.at("min").get<double>(), l.at("mean").get<double>(), l.at("max").get<double>()};
    }
    s.mean_alpha = number_of(json.at("mean_alpha"));
    s.nearest_m = number_of(json.at("nearest_m"));
    return s;
}

Json json_of(const ManifestFrame& f) {
    return {{"number", f.number},
            {"file", f.file},
            {"time_s", f.time_s},
            {"size_bytes", f.size_bytes},
            {"pixels_sha256", f.pixels_sha256},
            {"statistics", json_of(f.statistics)},
            {"render_s", json_of(f.render_s)}};
}

ManifestFrame frame_of(const Json& json) {
    return {.number = json.at("number").get<int>(),
            .file = json.at("file").get<std::string>(),
            .time_s = json.at("time_s").get<double>(),
            .size_bytes = json.at("size_bytes").get<std::uint64_t>(),
            .pixels_sha256 = json.at("pixels_sha256").get<std::string>(),
            .statistics = statistics_of(json.at("statistics")),
            .render_s = number_of(json.at("render_s"))};
}

Json json_of(const ManifestBound& bound) {
    return {{"asked_px", bound.asked_px}, {"largest_px", json_of(bound.largest_px)}};
}

ManifestBound bound_of(const Json& json) {
    return {json.at("asked_px").get<double>(), number_of(json.at("largest_px"))};
}

Json json_of(const ManifestSampling& s) {
    return {
        {"tracer", s.tracer}, {"lines", s.lines}, {"samples", s.samples}, {"drift_px", s.drift_px}, {"error", s.error}};
}

ManifestSampling sampling_of(const Json& json) {
    return {json.at("tracer").get<std::string>(), json.at("lines").get<int>(), json.at("samples").get<int>(),
            json.at("drift_px").get<double>(), json.at("error").get<double>()};
}

Json json_of(const ManifestSequence& s) {
    Json files = Json::array();
    for (const ManifestInput& f : s.files) files.push_back({{"what", f.what}, {"file", f.file}, {"sha256", f.sha256}});
    Json frames = Json::array();
    for (const ManifestFrame& f : s.frames) frames.push_back(json_of(f));
    return {{"software", s.software},
            {"libraries", s.libraries},
            {"command", s.command},
            {"inputs", {{"sha256", s.inputs}, {"files", files}}},
            {"terrain",
             {{"crs", s.crs},
              {"vertical_datum", s.vertical_datum},
              {"scene_origin",
               {{"lon_deg", s.scene_origin.lon.degrees()},
                {"lat_deg", s.scene_origin.lat.degrees()},
                {"height_m", s.scene_origin.height_m}}}}},
            {"image", {{"width", s.width}, {"height", s.height}}},
            {"frame_rate", {s.rate.numerator, s.rate.denominator}},
            {"first", s.first},
            {"count", s.count},
            {"sampling", json_of(s.sampling)},
            {"mesh_error", json_of(s.mesh)},
            {"motion_error", json_of(s.motion)},
            {"layer_files", names_of(s.layer_files)},
            {"frames", frames}};
}

ManifestSequence sequence_of(const Json& json) {
    ManifestSequence s;
    json.at("software").get_to(s.software);
    json.at("libraries").get_to(s.libraries);
    json.at("command").get_to(s.command);
    json.at("inputs").at("sha256").get_to(s.inputs);
    for (const Json& f : json.at("inputs").at("files")) {
        s.files.push_back(
            {f.at("what").get<std::string>(), f.at("file").get<std::string>(), f.at("sha256").get<std::string>()});
    }
    const Json& terrain = json.at("terrain");
    terrain.at("crs").get_to(s.crs);
    terrain.at("vertical_datum").get_to(s.vertical_datum);
    const Json& origin = terrain.at("scene_origin");
    s.scene_origin = {Angle::degrees(origin.at("lon_deg").get<double>()),
                      Angle::degrees(origin.at("lat_deg").get<double>()), origin.at("height_m").get<double>()};
    json.at("image").at("width").get_to(s.width);
    json.at("image").at("height").get_to(s.height);
    s.rate = {json.at("frame_rate").at(0).get<std::int32_t>(), json.at("frame_rate").at(1).get<std::int32_t>()};
    json.at("first").get_to(s.first);
    json.at("count").get_to(s.count);
    s.sampling = sampling_of(json.at("sampling"));
    s.mesh = bound_of(json.at("mesh_error"));
    s.motion = bound_of(json.at("motion_error"));
    if (json.contains("layer_files")) s.layer_files = layers_of(json.at("layer_files").get<std::vector<std::string>>());
    for (const Json& f : json.at("frames")) s.frames.push_back(frame_of(f));
    std::ranges::sort(s.frames, {}, &ManifestFrame::number);
    return s;
}

Manifest manifest_of(const Json& json) {
    if (json.at("format").get<std::string>() != kFormat) throw std::invalid_argument("it is none");
    if (json.at("version").get<int>() > kVersion) throw std::invalid_argument("it is of a later version of overfly");
    Manifest manifest;
    for (const auto& [name, sequence] : json.at("sequences").items()) {
        manifest.sequences.emplace(name, sequence_of(sequence));
    }
    return manifest;
}

}  // namespace

const ManifestFrame* ManifestSequence::find(int number) const {
    const auto found = std::ranges::lower_bound(frames, number, {}, &ManifestFrame::number);
    return found == frames.end() || found->number != number ? nullptr : &*found;
}

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest) {
    Json sequences = Json::object();
    for (const auto& [name, sequence] : manifest.sequences) sequences[name] = json_of(sequence);
    const Json json = {{"format", kFormat}, {"version", kVersion}, {"sequences", sequences}};
    // File names may hold bytes that are no UTF-8, which JSON does not have.
    const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
    OutputFile file(folder / kManifestName);
    file.write(std::as_bytes(std::span(text)));
    file.commit();
}

std::optional<Manifest> read_manifest(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kManifestName;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::nullopt;
    std::ifstream stream(file);
    try {
        return manifest_of(Json::parse(stream));
    } catch (const std::exception& e) {
        throw UserError(Place{file}, fmt::format("can't be read as a manifest: {}", e.what()));
    }
}

}  // namespace overfly
