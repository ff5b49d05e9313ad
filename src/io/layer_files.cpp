#include "io/layer_files.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "io/frame_facts.h"

namespace overfly {

std::filesystem::path layer_file(const std::filesystem::path& frame, Layer layer) {
    std::filesystem::path name = frame.stem().stem();
    name += '.' + std::string(kind_of(layer).name);
    name += frame.stem().extension();
    name += frame.extension();
    return frame.parent_path() / name;
}

std::optional<LayerSequence> layer_sequence(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return std::nullopt;
    const auto kind = std::ranges::find(layer_kinds(), std::string_view(name).substr(dot + 1), &LayerKind::name);
    if (kind == layer_kinds().end()) return std::nullopt;
    return LayerSequence{name.substr(0, dot), kind->layer};
}

std::vector<std::filesystem::path> files_of_frame(const std::filesystem::path& frame, LayerSet own_files) {
    std::vector<std::filesystem::path> files;
    for (const LayerKind& kind : kinds_of(own_files)) files.push_back(layer_file(frame, kind.layer));
    files.push_back(frame);
    return files;
}

std::uint64_t size_of_frame(const std::filesystem::path& frame, LayerSet own_files) {
    std::uint64_t bytes = 0;
    for (const std::filesystem::path& file : files_of_frame(frame, own_files)) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        if (!error) bytes += size;
    }
    return bytes;
}

FrameChannels read_all_channels(const std::filesystem::path& frame) {
    FrameChannels all = read_channels(frame);
    const LayerSet own_files = read_frame_facts(frame).layer_files;
    if (own_files.empty()) return all;
    for (const std::filesystem::path& file : files_of_frame(frame, own_files)) {
        if (file == frame) continue;
        FrameChannels layer = read_channels(file);
        if (layer.width != all.width || layer.height != all.height)
            throw UserError(Place{file}, "it differs in size from the frame that it is a layer of");
        std::ranges::move(layer.channels, std::back_inserter(all.channels));
    }
    std::ranges::sort(all.channels, {}, &FrameChannel::name);
    return all;
}

std::vector<FrameContent> contents_of(const std::filesystem::path& frame, const StoredPixels& pixels,
                                      const FrameHeader& header) {
    std::vector<FrameContent> contents;
    for (const LayerKind& kind : kinds_of(header.layer_files)) {
        FrameHeader own = header;
        own.layers = {kind.layer};
        own.layer_files = {};
        own.is_of_a_layer = true;
        contents.push_back({layer_file(frame, kind.layer), pixels.of(kind.layer), std::move(own)});
        check(!contents.back().pixels.channels.empty(), "a frame has the layers that its header says");
    }
    contents.push_back({frame, pixels.without(header.layer_files), header});
    return contents;
}

}  // namespace overfly
