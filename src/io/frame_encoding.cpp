#include "io/frame_encoding.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <variant>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRationalAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTimeCodeAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include "core/error.h"
#include "io/frame_attributes.h"

namespace overfly {
namespace {

// Frames are written in parallel by whoever calls; lines within one frame are not.
constexpr int kThreadsWithinFrame = 0;

constexpr float kLargestHalf = 65504.0F;

class ExrStream : public Imf::OStream {
  public:
    explicit ExrStream(ByteSink& sink) : OStream("a frame"), sink_(sink) {}

    void write(const char bytes[], int count) override {
        sink_.write(std::as_bytes(std::span(bytes, static_cast<std::size_t>(count))));
    }
    std::uint64_t tellp() override { return sink_.position(); }
    void seekp(std::uint64_t offset) override { sink_.seek(offset); }

  private:
    ByteSink& sink_;
};

template <class Scalar>
Imath::Matrix44<Scalar> imath(const std::array<std::array<Scalar, 4>, 4>& rows) {
    Imath::Matrix44<Scalar> m;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            m[row][column] = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
        }
    }
    return m;
}

// One conversion for each alternative of FrameAttribute::Value.
struct InsertAttribute {
    Imf::Header& header;
    const std::string& name;

    void operator()(int v) const { header.insert(name, Imf::IntAttribute(v)); }
    void operator()(float v) const { header.insert(name, Imf::FloatAttribute(v)); }
    void operator()(double v) const { header.insert(name, Imf::DoubleAttribute(v)); }
    void operator()(const std::string& v) const { header.insert(name, Imf::StringAttribute(v)); }
    void operator()(const FrameAttribute::Vector2f& v) const {
        header.insert(name, Imf::V2fAttribute(Imath::V2f(v[0], v[1])));
    }
    void operator()(const FrameAttribute::Vector3d& v) const {
        header.insert(name, Imf::V3dAttribute(Imath::V3d(v[0], v[1], v[2])));
    }
    void operator()(const FrameAttribute::Matrix44f& m) const { header.insert(name, Imf::M44fAttribute(imath(m))); }
    void operator()(const RowMatrix& m) const { header.insert(name, Imf::M44dAttribute(imath(m))); }
    void operator()(FrameRate v) const {
        const Imf::Rational rational(v.numerator, static_cast<unsigned>(v.denominator));
        header.insert(name, Imf::RationalAttribute(rational));
    }
    void operator()(const SmpteTime& v) const {
        Imf::TimeCode code(v.hours, v.minutes, v.seconds, v.frame);
        code.setFieldPhase(v.second_of_pair);
        header.insert(name, Imf::TimeCodeAttribute(code));
    }
};

// Without channels.
Imf::Header exr_header(const FrameHeader& frame_header, int width, int height) {
    // The screen window is the picture at depth 1.
    const auto screen_window_width = static_cast<float>(2.0 * frame_header.camera.tan_half_fov);
    Imf::Header header(width, height, 1.0F, Imath::V2f(0.0F, 0.0F), screen_window_width, Imf::INCREASING_Y,
                       Imf::ZIP_COMPRESSION);
    Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709 and D65 are the type's default
    for (const auto& [name, value] : frame_attributes(frame_header, width, height)) {
        std::visit(InsertAttribute{header, name}, value);
    }
    return header;
}

// A channel, where its first value is in memory, and how many bytes further the next one.
struct Plane {
    const char* channel;
    Imf::PixelType type;
    const void* first;
    std::size_t stride;
};

// Of a part of the file.
struct PartLayers {
    const char* name;
    Compression compression;
    std::vector<Plane> planes;
};

std::vector<Plane> beauty_planes(const StoredPixels& pixels) {
    constexpr std::array<const char*, 4> kColours{"R", "G", "B", "A"};
    std::vector<Plane> planes;
    for (std::size_t c = 0; c < kColours.size(); ++c)
        planes.push_back({kColours[c], Imf::HALF, pixels.rgba.data()->data() + c, sizeof(pixels.rgba[0])});
    return planes;
}

std::vector<Plane> data_planes(const StoredPixels& pixels) {
    return {{"Z", Imf::FLOAT, pixels.depth_m.data(), sizeof(float)}};
}

std::vector<PartLayers> parts_of(const StoredPixels& pixels, const FrameStorage& storage) {
    std::vector<PartLayers> parts = {{"beauty", storage.beauty, beauty_planes(pixels)},
                                     {"data", storage.data, data_planes(pixels)}};
    if (storage.beauty != storage.data) return parts;
    parts[0].planes.insert(parts[0].planes.end(), parts[1].planes.begin(), parts[1].planes.end());
    parts.pop_back();
    return parts;
}

Imf::Compression imf(Compression compression) {
    switch (compression) {
        case Compression::Zip:
            return Imf::ZIP_COMPRESSION;
        case Compression::Zips:
            return Imf::ZIPS_COMPRESSION;
        case Compression::Piz:
            return Imf::PIZ_COMPRESSION;
        case Compression::Dwaa:
            return Imf::DWAA_COMPRESSION;
    }
    throw InternalError("a compression has a name");
}

Imf::Header part_header(const Imf::Header& whole, const PartLayers& layers, double quality) {
    Imf::Header part = whole;
    part.compression() = imf(layers.compression);
    if (layers.compression == Compression::Dwaa) part.dwaCompressionLevel() = static_cast<float>(quality);
    for (const Plane& plane : layers.planes) part.channels().insert(plane.channel, Imf::Channel(plane.type));
    return part;
}

Imf::FrameBuffer frame_buffer(const PartLayers& layers, const Imath::Box2i& window) {
    Imf::FrameBuffer buffer;
    for (const Plane& plane : layers.planes)
        buffer.insert(plane.channel, Imf::Slice::Make(plane.type, plane.first, window, plane.stride));
    return buffer;
}

void write_single(const Imf::Header& header, const PartLayers& layers, int height, ByteSink& sink) {
    ExrStream stream(sink);
    Imf::OutputFile file(stream, header, kThreadsWithinFrame);
    file.setFrameBuffer(frame_buffer(layers, header.dataWindow()));
    file.writePixels(height);
}  // OpenEXR writes the table of lines as it closes

void write_parts(std::vector<Imf::Header> headers, const std::vector<PartLayers>& parts, int height, ByteSink& sink) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        headers[i].setName(parts[i].name);
        headers[i].setType(Imf::SCANLINEIMAGE);
    }
    ExrStream stream(sink);
    Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()), false, kThreadsWithinFrame);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Imf::OutputPart part(file, static_cast<int>(i));
        part.setFrameBuffer(frame_buffer(parts[i], headers[i].dataWindow()));
        part.writePixels(height);
    }
}

}  // namespace

StoredPixels stored_pixels(const Frame& frame) {
    const std::size_t pixel_count = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    check(frame.width > 0 && frame.height > 0, "a frame has pixels");
    check(frame.rgba.size() == pixel_count && frame.depth_m.size() == pixel_count, "a frame has all its pixels");
    // What is not a number is a bug of ours, and would spread through every filter that touches it.
    check(std::ranges::all_of(frame.depth_m, [](float z) { return std::isfinite(z); }), "a frame's depths are finite");
    StoredPixels pixels{.width = frame.width, .height = frame.height, .rgba = {}, .depth_m = frame.depth_m};
    pixels.rgba.reserve(pixel_count);
    for (const auto& rgba : frame.rgba) {
        std::array<std::uint16_t, 4>& pixel = pixels.rgba.emplace_back();
        for (std::size_t channel = 0; channel < 4; ++channel) {
            check(std::isfinite(rgba[channel]), "a frame's colours are finite");
            pixel[channel] = Imath::half(std::clamp(rgba[channel], -kLargestHalf, kLargestHalf)).bits();
        }
    }
    return pixels;
}

FrameChannels channels_of(const StoredPixels& pixels) {
    FrameChannels frame{pixels.width, pixels.height, {}};
    for (const std::vector<Plane>& planes : {beauty_planes(pixels), data_planes(pixels)}) {
        for (const Plane& plane : planes) {
            const bool is_half = plane.type == Imf::HALF;
            const std::size_t bytes = is_half ? sizeof(std::uint16_t) : sizeof(float);
            FrameChannel& channel = frame.channels.emplace_back();
            channel.name = plane.channel;
            channel.type = is_half ? ChannelType::Half : ChannelType::Float;
            channel.values.resize(pixels.rgba.size() * bytes);
            const auto* value = static_cast<const std::byte*>(plane.first);
            for (std::size_t i = 0; i < pixels.rgba.size(); ++i, value += plane.stride)
                std::memcpy(channel.values.data() + i * bytes, value, bytes);
        }
    }
    std::ranges::sort(frame.channels, {}, &FrameChannel::name);
    return frame;
}

void encode_frame(const StoredPixels& pixels, const FrameHeader& header, const FrameStorage& storage, ByteSink& sink) {
    check(!is_lossy(storage.data), "what is not for the eye is stored without loss");
    const Imf::Header whole = exr_header(header, pixels.width, pixels.height);
    const std::vector<PartLayers> parts = parts_of(pixels, storage);
    std::vector<Imf::Header> headers;
    for (const PartLayers& layers : parts) headers.push_back(part_header(whole, layers, storage.quality));
    if (parts.size() == 1) return write_single(headers.front(), parts.front(), pixels.height, sink);
    write_parts(std::move(headers), parts, pixels.height, sink);
}

void encode_group(const StoredPixels& pixels, const FrameHeader& header, LayerGroup group, const FrameStorage& storage,
                  ByteSink& sink) {
    const PartLayers layers = group == LayerGroup::Beauty ? PartLayers{"beauty", storage.beauty, beauty_planes(pixels)}
                                                          : PartLayers{"data", storage.data, data_planes(pixels)};
    const Imf::Header whole = exr_header(header, pixels.width, pixels.height);
    write_single(part_header(whole, layers, storage.quality), layers, pixels.height, sink);
}

}  // namespace overfly
