#include "io/frame_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/frame_attributes.h"
#include "io/frame_encoding.h"
#include "io/layer_files.h"
#include "io/output_file.h"

namespace overfly {
namespace {

// Frames are read in parallel by whoever calls; lines within one frame are not.
constexpr int kThreadsWithinFrame = 0;

// That every frame has.
constexpr std::array<const char*, 5> kBeautyChannels{"R", "G", "B", "A", "Z"};

// A file that remembers its errors: OpenEXR's own stream does not notice a disk that fills up while its last bytes are
// flushed, and its destructor swallows what goes wrong with the table of lines.
class FileSink : public ByteSink {
  public:
    explicit FileSink(const std::filesystem::path& file) : file_(file) {}

    void write(std::span<const std::byte> bytes) override { file_.write(bytes); }
    void seek(std::uint64_t offset) override { file_.seek(offset); }
    [[nodiscard]] std::uint64_t position() const override { return file_.position(); }
    void close() { file_.close(); }
    void commit() { file_.commit(); }

  private:
    OutputFile file_;
};

Frame empty_frame(const Imath::Box2i& window) {
    Frame frame;
    frame.width = window.max.x - window.min.x + 1;
    frame.height = window.max.y - window.min.y + 1;
    const std::size_t pixel_count = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    frame.rgba.resize(pixel_count);
    frame.depth_m.resize(pixel_count);
    return frame;
}

// For those of a frame's channels that are among `channels`.
Imf::FrameBuffer frame_buffer(Frame& frame, const Imf::ChannelList& channels, const Imath::Box2i& window) {
    Imf::FrameBuffer buffer;
    const auto insert = [&](const char* name, float* first, std::size_t stride) {
        if (channels.findChannel(name)) buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, first, window, stride));
    };
    float* const red = frame.rgba.front().data();
    constexpr std::size_t kPixel = 4 * sizeof(float);
    insert("R", red, kPixel);
    insert("G", red + 1, kPixel);
    insert("B", red + 2, kPixel);
    insert("A", red + 3, kPixel);
    insert("Z", frame.depth_m.data(), sizeof(float));
    return buffer;
}

bool has_channel(const Imf::MultiPartInputFile& file, const char* channel) {
    for (int part = 0; part < file.parts(); ++part) {
        if (file.header(part).channels().findChannel(channel)) return true;
    }
    return false;
}

// Throws whatever OpenEXR throws when the file is not there, not OpenEXR, cut off or damaged.
Frame load(const std::filesystem::path& file) {
    Imf::MultiPartInputFile input(file.c_str(), kThreadsWithinFrame);
    for (const char* channel : kBeautyChannels) {
        if (!has_channel(input, channel)) throw std::invalid_argument(fmt::format("it has no channel {}", channel));
    }
    const Imath::Box2i window = input.header(0).dataWindow();
    for (int part = 0; part < input.parts(); ++part) {
        // Before memory is taken: a header that promises more lines than the file has is found here.
        if (!input.partComplete(part)) throw std::invalid_argument("it is incomplete");
        if (input.header(part).dataWindow() != window) throw std::invalid_argument("its parts differ in size");
    }
    Frame frame = empty_frame(window);
    for (int number = 0; number < input.parts(); ++number) {
        Imf::InputPart part(input, number);
        part.setFrameBuffer(frame_buffer(frame, part.header().channels(), window));
        part.readPixels(window.min.y, window.max.y);
    }
    return frame;
}

// No file gets its name before all are complete, and the frame's own is the last: whoever finds it finds all. Says how
// large they are.
std::uint64_t write(const std::filesystem::path& file, const StoredPixels& pixels, const FrameHeader& header,
                    const FrameStorage& storage) {
    std::deque<FileSink> sinks;
    for (const FrameContent& content : contents_of(file, pixels, header)) {
        FileSink& sink = sinks.emplace_back(content.file);
        encode_frame(content.pixels, content.header, storage, sink);
        sink.close();
    }
    for (FileSink& sink : sinks) sink.commit();
    return size_of_frame(file, header.layer_files);
}

}  // namespace

void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameHeader& header,
                 const FrameStorage& storage) {
    write(file, StoredPixels(frame), header, storage);
}

FrameDigest write_digested_frame(const std::filesystem::path& file, const Frame& frame, const FrameHeader& header,
                                 const FrameStorage& storage) {
    const StoredPixels pixels(frame);
    const std::uint64_t size_bytes = write(file, pixels, header, storage);
    if (is_lossy(storage.beauty)) return digest_frame(file);
    FrameDigest digest = digest_of(pixels.all());
    digest.size_bytes = size_bytes;
    return digest;
}

bool is_complete_frame(const std::filesystem::path& file) {
    // Decoding every line is the only test that a cut at any byte and a damaged block both fail.
    try {
        const FrameChannels all = read_all_channels(file);
        return std::ranges::all_of(kBeautyChannels, [&](const char* name) { return all.find(name) != nullptr; });
    } catch (const std::exception&) {
        return false;
    }
}

std::optional<std::string> frame_inputs(const std::filesystem::path& file) {
    try {
        const Imf::InputFile input(file.c_str(), kThreadsWithinFrame);
        const auto* inputs = input.header().findTypedAttribute<Imf::StringAttribute>(kInputsAttribute);
        if (inputs == nullptr) return std::nullopt;
        return inputs->value();
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

Frame read_frame_with_layers(const std::filesystem::path& file) {
    Frame frame = read_frame(file);
    for (const FrameChannel& channel : read_all_channels(file).channels) {
        const std::optional<Layer> layer = layer_of_channel(channel.name);
        if (!layer) continue;
        const LayerKind& kind = kind_of(*layer);
        LayerChannel& own = frame.layers.emplace_back(LayerChannel{channel.name, kind.type, kind.group, {}});
        if (channel.type == ChannelType::Uint) {
            own.values.resize(frame.rgba.size());
            std::memcpy(own.values.data(), channel.values.data(), channel.values.size());
        } else {
            own.values = numbers_of(channel);
        }
    }
    return frame;
}

Frame read_frame(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw UserError(Place{file}, "no such frame");
    try {
        return load(file);
    } catch (const std::exception& e) {
        throw UserError(Place{file}, fmt::format("can't be read as a frame: {}", e.what()));
    }
}

}  // namespace overfly
