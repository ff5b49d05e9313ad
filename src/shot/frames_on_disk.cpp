#include "shot/frames_on_disk.h"

#include <optional>

#include <fmt/format.h>

#include "shot/frame_check.h"

namespace overfly {
namespace {

std::vector<FrameExpectation> expectations(std::span<const PlannedFrame> wanted, const Resuming& resuming,
                                           const SequenceManifest& manifest) {
    std::vector<FrameExpectation> expected;
    for (const PlannedFrame& frame : wanted) {
        FrameExpectation& e = expected.emplace_back();
        e.number = frame.number;
        e.file = frame.file;
        e.inputs = resuming.inputs;
        e.width = resuming.shot.image.width;
        e.height = resuming.shot.image.height;
        if (const ManifestFrame* const listed = manifest.find(frame.number)) e.listed = *listed;
    }
    return expected;
}

// Who does not repair takes pixels as they are.
bool is_kept(const CheckedFrame& frame, bool repairing) {
    if (!frame.fault) return true;
    if (repairing || !frame.digest) return false;
    return frame.fault == FrameFault::Pixels || frame.fault == FrameFault::Black ||
           frame.fault == FrameFault::Duplicate;
}

std::vector<std::string> news_of(const FramesOnDisk& found, int outdated) {
    std::vector<std::string> news;
    if (found.kept > 0) news.push_back(fmt::format("{} frames are complete already", found.kept));
    if (outdated > 0) {
        news.push_back(fmt::format("{} frames are of an earlier version of the shot and are rendered again", outdated));
    }
    return news;
}

}  // namespace

FramesOnDisk look_at_frames(std::span<const PlannedFrame> wanted, const Resuming& resuming,
                            SequenceManifest& manifest) {
    const std::vector<FrameExpectation> expected = expectations(wanted, resuming, manifest);
    const std::vector<CheckedFrame> checked = check_frames(expected, resuming.progress);
    FramesOnDisk found;
    std::vector<std::string> repairs;
    int outdated = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const CheckedFrame& frame = checked[i];
        if (is_kept(frame, resuming.repairing)) {
            ++found.kept;
            if (!expected[i].listed) manifest.add(manifest_frame(wanted[i], *frame.digest));
            continue;
        }
        found.to_render.push_back(wanted[i]);
        if (frame.fault == FrameFault::OtherInputs) {
            ++outdated;
        } else if (resuming.repairing && frame.fault != FrameFault::Missing) {
            repairs.push_back(fmt::format("{}: {}; it is rendered again", wanted[i].file.string(), frame.message));
        }
    }
    manifest.forget(found.to_render);
    found.news = news_of(found, outdated);
    found.news.insert(found.news.end(), repairs.begin(), repairs.end());
    return found;
}

}  // namespace overfly
