#include "shot/previews.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include "io/contact_sheet.h"
#include "io/frame_file.h"
#include "io/movie.h"

namespace overfly {

namespace {

// Whether a preview is missing, or older than a frame: an earlier run may have been stopped before it made this one.
bool is_outdated(const std::filesystem::path& preview, std::span<const std::filesystem::path> frames) {
    std::error_code error;
    const auto made = std::filesystem::last_write_time(preview, error);
    if (error) return true;
    return std::ranges::any_of(frames, [&](const std::filesystem::path& frame) {
        return std::filesystem::last_write_time(frame, error) > made && !error;
    });
}

}  // namespace

PreviewLook preview_look_of(const ShotDocument& shot) {
    if (!makes_previews(shot)) return {};
    return {ViewTransform(shot.output.preview.view), shot.output.preview.burn_in};
}

Previews make_previews(const ShotDocument& shot, const PreviewLook& look, std::span<const PlannedFrame> frames,
                       const std::string& inputs, bool frames_changed, const Progress& progress) {
    const OutputDocument& output = shot.output;
    std::vector<std::filesystem::path> files;
    for (const PlannedFrame& f : frames) {
        // Frames of an earlier version of the shot may even have another size.
        if (!std::filesystem::exists(f.file) || frame_inputs(f.file) != inputs) continue;
        files.push_back(f.file);
    }
    Previews previews;
    if (files.empty()) return previews;
    const auto is_due = [&](const std::filesystem::path& file) {
        return frames_changed || is_outdated(file, files) || !carries_remark(file, look.remark());
    };
    if (output.contact_sheet) {
        previews.contact_sheet = output.folder / (output.name + ".contact.png");
        if (progress) progress("making the contact sheet", 0.0, 0.0);
        if (is_due(previews.contact_sheet)) write_contact_sheet(previews.contact_sheet, files, {.look = look});
    }
    if (output.movie) {
        previews.movie = output.folder / (output.name + ".mp4");
        if (is_due(previews.movie)) write_movie(previews.movie, files, shot.frames.rate, progress, look);
    }
    return previews;
}

}  // namespace overfly
