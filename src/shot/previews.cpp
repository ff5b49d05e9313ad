#include "shot/previews.h"

#include <vector>

#include "io/contact_sheet.h"
#include "io/movie.h"

namespace overfly {

Previews make_previews(const ShotDocument& shot, std::span<const PlannedFrame> frames, bool frames_changed,
                       const Progress& progress) {
    const OutputDocument& output = shot.output;
    std::vector<NumberedFrame> numbered;
    std::vector<std::filesystem::path> files;
    for (const PlannedFrame& f : frames) {
        if (!std::filesystem::exists(f.file)) continue;
        numbered.push_back({f.number, f.file});
        files.push_back(f.file);
    }
    Previews previews;
    if (files.empty()) return previews;
    const auto is_due = [&](const std::filesystem::path& file) {
        return frames_changed || !std::filesystem::exists(file);
    };
    if (output.contact_sheet) {
        previews.contact_sheet = output.folder / (output.name + ".contact.png");
        if (progress) progress("making the contact sheet", 0.0, 0.0);
        if (is_due(previews.contact_sheet)) write_contact_sheet(previews.contact_sheet, numbered);
    }
    if (output.movie) {
        previews.movie = output.folder / (output.name + ".mp4");
        if (is_due(previews.movie)) write_movie(previews.movie, files, shot.frames.rate, progress);
    }
    return previews;
}

}  // namespace overfly
