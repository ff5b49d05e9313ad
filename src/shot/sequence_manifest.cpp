#include "shot/sequence_manifest.h"

#include <utility>

#include "core/error.h"
#include "io/folder_lock.h"

namespace overfly {
namespace {

// What can't be read is as nothing.
std::optional<Manifest> readable_manifest(const std::filesystem::path& folder, bool& is_broken) {
    try {
        return read_manifest(folder);
    } catch (const UserError&) {
        is_broken = true;
        return std::nullopt;
    }
}

}  // namespace

SequenceManifest::SequenceManifest(std::filesystem::path folder, std::string name, std::string inputs)
    : folder_(std::move(folder)), name_(std::move(name)) {
    if (std::optional<Manifest> manifest = readable_manifest(folder_, was_broken_)) {
        const auto found = manifest->sequences.find(name_);
        if (found != manifest->sequences.end()) {
            lists_other_inputs_ = found->second.inputs != inputs;
            if (!lists_other_inputs_) found_ = std::move(found->second);
        }
    }
    about_.inputs = std::move(inputs);
}

void SequenceManifest::describe(ManifestSequence about) {
    about.inputs = about_.inputs;
    about_ = std::move(about);
    if (!about_.mesh.largest_px) about_.mesh.largest_px = found_.mesh.largest_px;
    if (!about_.motion.largest_px) about_.motion.largest_px = found_.motion.largest_px;
}

void SequenceManifest::forget(const std::vector<PlannedFrame>& frames) {
    for (const PlannedFrame& frame : frames) {
        forgotten_.insert(frame.number);
        added_.erase(frame.number);
        if (lists_other_inputs_ || found_.find(frame.number) != nullptr) is_changed_ = true;
    }
}

void SequenceManifest::add(ManifestFrame frame) {
    is_changed_ = true;
    added_.insert_or_assign(frame.number, std::move(frame));
}

void SequenceManifest::save() {
    if (!is_changed_) return;
    const FolderLock lock(folder_);
    // Another run may have written it since.
    bool is_broken = false;
    Manifest manifest = readable_manifest(folder_, is_broken).value_or(Manifest{});
    manifest.sequences.insert_or_assign(name_, merged(manifest));
    write_manifest(folder_, manifest);
    forgotten_.clear();
    is_changed_ = false;
}

ManifestSequence SequenceManifest::merged(const Manifest& on_disk) const {
    std::map<int, ManifestFrame> frames = added_;
    const auto found = on_disk.sequences.find(name_);
    if (found != on_disk.sequences.end() && found->second.inputs == about_.inputs) {
        for (const ManifestFrame& frame : found->second.frames) {
            if (!forgotten_.contains(frame.number)) frames.try_emplace(frame.number, frame);
        }
    }
    ManifestSequence sequence = about_;
    for (auto& [number, frame] : frames) sequence.frames.push_back(std::move(frame));
    return sequence;
}

ManifestFrame manifest_frame(const PlannedFrame& frame, const FrameDigest& digest, std::optional<double> render_s) {
    return {.number = frame.number,
            .file = frame.file.filename().string(),
            .time_s = frame.time_s,
            .size_bytes = digest.size_bytes,
            .pixels_sha256 = digest.pixels_sha256,
            .statistics = digest.statistics,
            .render_s = render_s};
}

}  // namespace overfly
