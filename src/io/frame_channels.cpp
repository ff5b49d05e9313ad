#include "io/frame_channels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <system_error>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompressionAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/exr_complaint.h"

namespace overfly {
namespace {

static_assert(std::endian::native == std::endian::little, "values are hashed as they lie in memory");

// Frames are read in parallel by whoever calls; lines within one frame are not.
constexpr int kThreadsWithinFrame = 0;

std::size_t bytes_of(ChannelType type) { return type == ChannelType::Half ? 2 : 4; }

ChannelType type_of(Imf::PixelType type) {
    switch (type) {
        case Imf::HALF:
            return ChannelType::Half;
        case Imf::FLOAT:
            return ChannelType::Float;
        case Imf::UINT:
            return ChannelType::Uint;
        default:
            throw std::invalid_argument("it has a channel of an unknown type");
    }
}

std::string compression_name(Imf::Compression compression) {
    switch (compression) {
        case Imf::NO_COMPRESSION:
            return "none";
        case Imf::RLE_COMPRESSION:
            return "rle";
        case Imf::ZIPS_COMPRESSION:
            return "zips";
        case Imf::ZIP_COMPRESSION:
            return "zip";
        case Imf::PIZ_COMPRESSION:
            return "piz";
        case Imf::PXR24_COMPRESSION:
            return "pxr24";
        case Imf::B44_COMPRESSION:
            return "b44";
        case Imf::B44A_COMPRESSION:
            return "b44a";
        case Imf::DWAA_COMPRESSION:
            return "dwaa";
        case Imf::DWAB_COMPRESSION:
            return "dwab";
        default:
            return "unknown";
    }
}

Imf::PixelType imf(ChannelType type) {
    return type == ChannelType::Half ? Imf::HALF : type == ChannelType::Float ? Imf::FLOAT : Imf::UINT;
}

void read_part(Imf::MultiPartInputFile& file, int number, FrameChannels& frame) {
    Imf::InputPart part(file, number);
    const Imf::Header& header = part.header();
    const Imath::Box2i window = header.dataWindow();
    const std::size_t pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    const std::string compression = compression_name(header.compression());
    std::vector<FrameChannel> channels;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1) {
            throw std::invalid_argument(fmt::format("channel {} has fewer values than pixels", c.name()));
        }
        const ChannelType type = type_of(c.channel().type);
        const std::string name =
            frame.find(c.name()) == nullptr ? c.name() : fmt::format("{}/{}", header.name(), c.name());
        channels.push_back({name, type, compression, std::vector<std::byte>(pixels * bytes_of(type))});
    }
    Imf::FrameBuffer buffer;
    std::size_t i = 0;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c, ++i) {
        const ChannelType type = channels[i].type;
        buffer.insert(c.name(), Imf::Slice::Make(imf(type), channels[i].values.data(), window, bytes_of(type)));
    }
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    std::ranges::move(channels, std::back_inserter(frame.channels));
}

// Throws whatever OpenEXR throws when the file is not OpenEXR, cut off or damaged.
FrameChannels load(const std::filesystem::path& file) {
    Imf::MultiPartInputFile input(file.c_str(), kThreadsWithinFrame);
    const Imath::Box2i window = input.header(0).dataWindow();
    for (int part = 0; part < input.parts(); ++part) {
        // Before memory is taken: a header that promises more lines than the file has is found here.
        if (!input.partComplete(part)) throw std::invalid_argument(kCutOff);
        if (input.header(part).dataWindow() != window) throw std::invalid_argument("its parts differ in size");
    }
    FrameChannels frame;
    frame.width = window.max.x - window.min.x + 1;
    frame.height = window.max.y - window.min.y + 1;
    for (int part = 0; part < input.parts(); ++part) read_part(input, part, frame);
    std::ranges::sort(frame.channels, {}, &FrameChannel::name);
    return frame;
}

template <class Values>
ChannelStatistics statistics_of_values(const Values& values) {
    ChannelStatistics s;
    s.least = std::numeric_limits<double>::infinity();
    s.most = -s.least;
    double sum = 0.0;
    std::size_t finite = 0;
    for (const auto v : values) {
        if (std::isnan(v)) ++s.not_a_number;
        if (std::isinf(v)) ++s.infinite;
        if (!std::isfinite(v)) continue;
        ++finite;
        sum += v;
        s.least = std::min(s.least, static_cast<double>(v));
        s.most = std::max(s.most, static_cast<double>(v));
    }
    if (finite == 0) return {0.0, 0.0, 0.0, s.not_a_number, s.infinite};
    s.mean = sum / static_cast<double>(finite);
    return s;
}

}  // namespace

const char* name_of(ChannelType type) {
    return type == ChannelType::Half ? "half" : type == ChannelType::Float ? "float" : "uint";
}

const FrameChannel* FrameChannels::find(std::string_view name) const {
    const auto found = std::ranges::find(channels, name, &FrameChannel::name);
    return found == channels.end() ? nullptr : &*found;
}

FrameChannels read_channels(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw UserError(Place{file}, "no such frame");
    try {
        return load(file);
    } catch (const std::exception& e) {
        throw UserError(Place{file}, fmt::format("can't be read as a frame: {}", exr_complaint(e)));
    }
}

PixelHash::PixelHash(int width, int height) { add_text(fmt::format("{}x{}\n", width, height)); }

void PixelHash::add(const FrameChannel& channel) {
    add_text(fmt::format("{} {}\n", channel.name, name_of(channel.type)));
    hash_.add(channel.values);
}

void PixelHash::add_text(const std::string& text) { hash_.add(std::as_bytes(std::span(text))); }

Sha256Digest pixel_hash(const FrameChannels& frame) {
    PixelHash hash(frame.width, frame.height);
    for (const FrameChannel& channel : frame.channels) hash.add(channel);
    return hash.digest();
}

std::vector<float> numbers_of(const FrameChannel& channel) {
    std::vector<float> numbers(channel.values.size() / bytes_of(channel.type));
    const std::byte* from = channel.values.data();
    if (channel.type == ChannelType::Float) {
        std::memcpy(numbers.data(), from, channel.values.size());
        return numbers;
    }
    for (float& number : numbers) {
        if (channel.type == ChannelType::Half) {
            std::uint16_t bits = 0;
            std::memcpy(&bits, from, sizeof(bits));
            number = imath_half_to_float(bits);
        } else {
            std::uint32_t id = 0;
            std::memcpy(&id, from, sizeof(id));
            number = static_cast<float>(id);
        }
        from += bytes_of(channel.type);
    }
    return numbers;
}

ChannelStatistics statistics_of(std::span<const float> values) { return statistics_of_values(values); }

ChannelStatistics statistics_of(const FrameChannel& channel) {
    if (channel.type != ChannelType::Uint) return statistics_of(numbers_of(channel));
    std::vector<std::uint32_t> values(channel.values.size() / sizeof(std::uint32_t));
    std::memcpy(values.data(), channel.values.data(), channel.values.size());
    return statistics_of_values(std::vector<double>(values.begin(), values.end()));
}

}  // namespace overfly
