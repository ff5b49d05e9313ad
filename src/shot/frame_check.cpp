#include "shot/frame_check.h"

#include <map>
#include <mutex>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/exr_complaint.h"
#include "io/layer_files.h"

namespace overfly {
namespace {

// Collects the first fault; those after it are its consequences or can't be told.
class Verdict {
  public:
    explicit Verdict(CheckedFrame& frame) : frame_(&frame) {}
    void fault_if(bool is_so, FrameFault fault, const std::string& message) {
        if (!is_so || frame_->fault) return;
        frame_->fault = fault;
        frame_->message = message;
    }

  private:
    CheckedFrame* frame_;
};

FrameFault fault_of(const FrameExpectation& expected, const CheckedFrame& frame) {
    // OpenEXR does not always see it as an early end where a file is shorter than it was.
    const bool is_shorter = frame.facts.width > 0 && expected.listed &&
                            size_of_frame(expected.file, frame.facts.layer_files) < expected.listed->size_bytes;
    return is_shorter || frame.message.ends_with(kCutOff) ? FrameFault::Truncated : FrameFault::Unreadable;
}

void judge(const FrameExpectation& expected, CheckedFrame& frame) {
    const FrameDigest& digest = *frame.digest;
    Verdict verdict(frame);
    verdict.fault_if(!expected.inputs.empty() && frame.facts.inputs != expected.inputs, FrameFault::OtherInputs,
                     "it is of another version of the shot");
    verdict.fault_if(expected.width > 0 && (digest.width != expected.width || digest.height != expected.height),
                     FrameFault::Size,
                     fmt::format("it has {} x {} pixels instead of {} x {}", digest.width, digest.height,
                                 expected.width, expected.height));
    verdict.fault_if(frame.facts.number && *frame.facts.number != expected.number, FrameFault::Misplaced,
                     fmt::format("it is frame {} by its header", frame.facts.number.value_or(0)));
    verdict.fault_if(expected.listed && digest.pixels_sha256 != expected.listed->pixels_sha256, FrameFault::Pixels,
                     "its pixels are not those that the manifest lists");
    verdict.fault_if(digest.not_finite > 0, FrameFault::NotFinite,
                     fmt::format("{} of its values are infinite or no numbers, the first of channel {}",
                                 digest.not_finite, digest.not_finite_channel));
    verdict.fault_if(digest.is_black, FrameFault::Black, "it is black or transparent throughout");
}

// Whether the files of its layers are there and belong to it. Their pixels are looked at with the frame's.
void check_layer_files(const FrameExpectation& expected, CheckedFrame& frame) {
    Verdict verdict(frame);
    for (const std::filesystem::path& file : files_of_frame(expected.file, frame.facts.layer_files)) {
        if (file == expected.file) continue;
        std::error_code error;
        const std::string name = file.filename().string();
        if (!std::filesystem::exists(file, error)) {
            verdict.fault_if(true, FrameFault::LayerMissing, fmt::format("{}: missing", name));
            continue;
        }
        const FrameFacts layer = read_frame_facts(file);
        verdict.fault_if(layer.inputs != frame.facts.inputs, FrameFault::OtherInputs,
                         fmt::format("{}: it is of another version of the shot", name));
        verdict.fault_if(layer.number != frame.facts.number, FrameFault::Misplaced,
                         fmt::format("{}: it is frame {} by its header", name, layer.number.value_or(0)));
    }
}

// The user's words for what is wrong; of a layer's file with its name.
std::string message_of(const UserError& error, const FrameExpectation& expected) {
    const Problem& problem = error.problems().front();
    if (problem.place.file == expected.file) return problem.message;
    return fmt::format("{}: {}", problem.place.file.filename().string(), problem.message);
}

CheckedFrame check_frame(const FrameExpectation& expected) {
    CheckedFrame frame;
    std::error_code error;
    if (!std::filesystem::exists(expected.file, error)) {
        frame.fault = FrameFault::Missing;
        frame.message = "missing";
        return frame;
    }
    try {
        frame.facts = read_frame_facts(expected.file);
        check_layer_files(expected, frame);
        if (frame.fault) return frame;
        frame.digest = digest_frame(expected.file);
    } catch (const UserError& unreadable) {
        frame.message = message_of(unreadable, expected);
        frame.fault = fault_of(expected, frame);
        return frame;
    }
    judge(expected, frame);
    return frame;
}

bool camera_moved(const FrameFacts& a, const FrameFacts& b) {
    return a.world_to_camera != b.world_to_camera || a.screen_window_width != b.screen_window_width;
}

// Of frames with the same pixels the first is believed.
void find_duplicates(std::span<const FrameExpectation> expected, std::vector<CheckedFrame>& frames) {
    std::map<std::string, std::size_t> first_with;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames[i].fault || !frames[i].digest) continue;
        const auto [first, is_new] = first_with.try_emplace(frames[i].digest->pixels_sha256, i);
        if (is_new || !camera_moved(frames[i].facts, frames[first->second].facts)) continue;
        frames[i].fault = FrameFault::Duplicate;
        frames[i].message = fmt::format("it has the pixels of {}, though the camera has moved",
                                        expected[first->second].file.filename().string());
    }
}

}  // namespace

const char* name_of(FrameFault fault) {
    switch (fault) {
        case FrameFault::Missing:
            return "missing";
        case FrameFault::LayerMissing:
            return "layer_missing";
        case FrameFault::Truncated:
            return "truncated";
        case FrameFault::Unreadable:
            return "unreadable";
        case FrameFault::OtherInputs:
            return "other_inputs";
        case FrameFault::Size:
            return "size";
        case FrameFault::Misplaced:
            return "misplaced";
        case FrameFault::Pixels:
            return "pixels";
        case FrameFault::NotFinite:
            return "not_finite";
        case FrameFault::Black:
            return "black";
        case FrameFault::Duplicate:
            return "duplicate";
        case FrameFault::Unlisted:
            return "unlisted";
    }
    return "";
}

std::vector<CheckedFrame> check_frames(std::span<const FrameExpectation> expected, const Progress& progress) {
    std::vector<CheckedFrame> frames(expected.size());
    std::mutex mutex;
    double done = 0.0;
    parallel_for(expected.size(), [&](std::size_t i) {
        frames[i] = check_frame(expected[i]);
        const std::scoped_lock lock(mutex);
        if (progress) progress("checking frames", ++done, static_cast<double>(expected.size()));
    });
    find_duplicates(expected, frames);
    return frames;
}

}  // namespace overfly
