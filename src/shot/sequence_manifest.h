#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/manifest_file.h"
#include "shot/frame_plan.h"

namespace overfly {

// One sequence's part of its folder's manifest (io/manifest_file.h), while a run works on it.
// GUARANTEES: what the file lists is on disk as it is listed: a frame that is about to be rendered anew is taken off
// the list before, and put on it when it is complete. A run that is killed leaves a manifest of what was complete when
// it was last saved. Runs that share a folder keep each other's frames and sequences, on file systems that know locks
// of folders; elsewhere one may lose what the other lists, until a later run finds it missing. Not for several threads
// at once.
class SequenceManifest {
  public:
    // Reads what there is. A manifest that can't be read is as none: it is made anew, and was_broken() says so.
    // inputs: shot_inputs_hash. Frames that are listed for other inputs are none of this sequence.
    SequenceManifest(std::filesystem::path folder, std::string name, std::string inputs);

    [[nodiscard]] bool was_broken() const { return was_broken_; }
    // What the file said of a frame when it was read; nothing for one of which it said nothing.
    [[nodiscard]] const ManifestFrame* find(int number) const { return found_.find(number); }

    // What the file is to say of the sequence, all but its inputs and frames. Errors that nobody has looked for stay as
    // they were found before.
    void describe(ManifestSequence about);
    // From the next save() on, until they are added.
    void forget(const std::vector<PlannedFrame>& frames);
    void add(ManifestFrame frame);

    // Whether a frame was added, or one that is listed forgotten, since the last save().
    [[nodiscard]] bool is_changed() const { return is_changed_; }
    // Writes the file if that is so. Throws UserError.
    void save();

  private:
    [[nodiscard]] ManifestSequence merged(const Manifest& on_disk) const;

    std::filesystem::path folder_;
    std::string name_;
    bool was_broken_ = false, lists_other_inputs_ = false, is_changed_ = false;
    ManifestSequence found_, about_;
    std::map<int, ManifestFrame> added_;
    std::set<int> forgotten_;
};

// What the manifest says of a frame whose file holds `digest`.
[[nodiscard]] ManifestFrame manifest_frame(const PlannedFrame& frame, const FrameDigest& digest,
                                           std::optional<double> render_s = {});

}  // namespace overfly
