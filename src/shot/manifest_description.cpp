#include "shot/manifest_description.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "core/version.h"
#include "shot/library_versions.h"

namespace overfly {
namespace {

const char* name_of(TracerKind tracer) {
    switch (tracer) {
        case TracerKind::Kinetic:
            return "kinetic";
        case TracerKind::Interval:
            return "interval";
        case TracerKind::Discrete:
            return "discrete";
        case TracerKind::Hybrid:
            return "hybrid";
    }
    return "";
}

// Seen from the manifest, so that a folder which moves with its project still says where things are.
std::string seen_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return file.string();  // what GDAL alone understands
    const std::filesystem::path relative = std::filesystem::proximate(file, folder, error);
    return error ? file.string() : relative.string();
}

std::string crs_of(const ElevationReport& report) {
    if (report.crs_authority.empty()) return report.crs_name;
    return fmt::format("{} ({})", report.crs_name, report.crs_authority);
}

}  // namespace

ManifestSequence describe_sequence(const ManifestSubjects& subjects) {
    const ShotDocument& shot = subjects.shot;
    const ElevationReport& elevation = subjects.terrain.scene.report;
    ManifestSequence about;
    about.software = fmt::format("overfly {}", kVersion);
    for (const LibraryVersion& library : all_library_versions()) about.libraries[library.name] = library.version;
    about.command.assign(subjects.command.begin(), subjects.command.end());
    for (const InputFile& input : subjects.files) {
        about.files.push_back(
            {input.what, seen_from(shot.output.folder, input.content.file), hex(input.content.sha256)});
    }
    about.crs = crs_of(elevation);
    about.vertical_datum = fmt::format("{} ({})", elevation.vertical.name, text(elevation.vertical.provenance));
    about.scene_origin = subjects.terrain.scene.origin;
    about.width = shot.image.width;
    about.height = shot.image.height;
    about.rate = shot.frames.rate;
    about.first = shot.frames.first;
    about.count = static_cast<int>(subjects.frames.size());
    about.sampling = {name_of(shot.sampling.tracer), shot.sampling.lines, shot.sampling.samples, shot.sampling.drift_px,
                      shot.sampling.error};
    about.mesh = {shot.mesh_pixel_error, subjects.mesh_error_px};
    about.motion = {shot.motion_bound_px, subjects.motion_error_px};
    if (shot.output.layer_files) about.layer_files = shot.layers;
    return about;
}

}  // namespace overfly
