#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/frame_channels.h"
#include "io/frame_file.h"
#include "io/stored_pixels.h"

namespace overfly {

// Frames whose layers have files of their own. These lie beside the frame's file, not in folders of their own, so that
// a sequence can be moved, verified and deleted as what it is, one folder; and their names end in the number, so that
// every program sees a sequence in each layer.

// The file of a layer of the frame in `frame`: of NAME.0001.exr it is NAME.LAYER.0001.exr.
[[nodiscard]] std::filesystem::path layer_file(const std::filesystem::path& frame, Layer layer);

// The other way round: "NAME.LAYER" of a sequence of such files, in parts; nothing where it does not end in a layer.
struct LayerSequence {
    std::string frames;  // NAME
    Layer layer = Layer::Range;
};
[[nodiscard]] std::optional<LayerSequence> layer_sequence(const std::string& name);

// All files of a frame whose layers `own_files` have one: theirs by the order of Layer, and as the last one `frame`.
[[nodiscard]] std::vector<std::filesystem::path> files_of_frame(const std::filesystem::path& frame, LayerSet own_files);

// How large they are together; one that is not there counts nothing.
[[nodiscard]] std::uint64_t size_of_frame(const std::filesystem::path& frame, LayerSet own_files);

// What all of these files hold together, whatever of it is where; the frame's header says which there are. Throws
// UserError as read_channels does, for the file that is amiss; also where one differs in size from `frame`.
[[nodiscard]] FrameChannels read_all_channels(const std::filesystem::path& frame);

// One of the files of a frame.
struct FrameContent {
    std::filesystem::path file;
    StoredChannels pixels;
    FrameHeader header;
};

// What to write into each of files_of_frame(frame, header.layer_files). REQUIRES: the frame has these layers.
[[nodiscard]] std::vector<FrameContent> contents_of(const std::filesystem::path& frame, const StoredPixels& pixels,
                                                    const FrameHeader& header);

}  // namespace overfly
