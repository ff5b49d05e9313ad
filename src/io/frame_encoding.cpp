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

Imf::PixelType imf(ChannelType type) {
    return type == ChannelType::Half ? Imf::HALF : type == ChannelType::Float ? Imf::FLOAT : Imf::UINT;
}

// Of a part of the file.
struct PartLayers {
    const char* name;
    Compression compression;
    std::vector<const StoredChannel*> channels;
};

std::vector<PartLayers> parts_of(const StoredChannels& pixels, const FrameStorage& storage) {
    std::vector<PartLayers> parts = {{"beauty", storage.beauty, {}}, {"data", storage.data, {}}};
    const bool is_one = storage.beauty == storage.data;
    for (const StoredChannel& channel : pixels.channels)
        parts[is_one || channel.group == LayerGroup::Beauty ? 0 : 1].channels.push_back(&channel);
    std::erase_if(parts, [](const PartLayers& part) { return part.channels.empty(); });
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
    for (const StoredChannel* channel : layers.channels)
        part.channels().insert(channel->name, Imf::Channel(imf(channel->type)));
    return part;
}

Imf::FrameBuffer frame_buffer(const PartLayers& layers, const Imath::Box2i& window) {
    Imf::FrameBuffer buffer;
    for (const StoredChannel* channel : layers.channels)
        buffer.insert(channel->name, Imf::Slice::Make(imf(channel->type), channel->first, window, channel->stride));
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

void encode_frame(const StoredChannels& pixels, const FrameHeader& header, const FrameStorage& storage,
                  ByteSink& sink) {
    check(!is_lossy(storage.data), "what is not for the eye is stored without loss");
    const Imf::Header whole = exr_header(header, pixels.width, pixels.height);
    const std::vector<PartLayers> parts = parts_of(pixels, storage);
    std::vector<Imf::Header> headers;
    for (const PartLayers& layers : parts) headers.push_back(part_header(whole, layers, storage.quality));
    if (parts.size() == 1) return write_single(headers.front(), parts.front(), pixels.height, sink);
    write_parts(std::move(headers), parts, pixels.height, sink);
}

}  // namespace overfly
