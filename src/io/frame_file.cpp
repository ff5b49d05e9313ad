#include "io/frame_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRationalAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTimeCodeAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/frame_attributes.h"
#include "io/output_file.h"

namespace overfly {
namespace {

// Frames are written and read in parallel by whoever calls; lines within one frame are not.
constexpr int kThreadsWithinFrame = 0;

constexpr std::array<const char*, 4> kColourChannels{"R", "G", "B", "A"};
constexpr float kLargestHalf = 65504.0F;

using HalfPixel = std::array<Imath::half, 4>;

// OpenEXR writes through this into a file that remembers its errors: the library's own stream does not notice a disk
// that fills up while its last bytes are flushed, and its destructor swallows what goes wrong with the table of lines.
class ExrStream : public Imf::OStream {
  public:
    explicit ExrStream(const std::filesystem::path& file) : OStream(file.c_str()), file_(file) {}

    void write(const char bytes[], int count) override {
        file_.write(std::as_bytes(std::span(bytes, static_cast<std::size_t>(count))));
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t offset) override { file_.seek(offset); }
    void commit() { file_.commit(); }

  private:
    OutputFile file_;
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

Imf::Header exr_header(const FrameHeader& frame_header, int width, int height) {
    // The screen window is the picture at depth 1.
    const auto screen_window_width = static_cast<float>(2.0 * frame_header.camera.tan_half_fov);
    Imf::Header header(width, height, 1.0F, Imath::V2f(0.0F, 0.0F), screen_window_width, Imf::INCREASING_Y,
                       Imf::ZIP_COMPRESSION);
    for (const char* channel : kColourChannels) header.channels().insert(channel, Imf::Channel(Imf::HALF));
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709 and D65 are the type's default
    for (const auto& [name, value] : frame_attributes(frame_header, width, height)) {
        std::visit(InsertAttribute{header, name}, value);
    }
    return header;
}

// A pixel that is not a number is a bug of ours, and would spread through every filter that touches it.
std::vector<HalfPixel> half_pixels(const Frame& frame) {
    std::vector<HalfPixel> pixels;
    pixels.reserve(frame.rgba.size());
    for (const auto& rgba : frame.rgba) {
        HalfPixel& pixel = pixels.emplace_back();
        for (std::size_t channel = 0; channel < 4; ++channel) {
            check(std::isfinite(rgba[channel]), "a frame's colours are finite");
            pixel[channel] = Imath::half(std::clamp(rgba[channel], -kLargestHalf, kLargestHalf));
        }
    }
    return pixels;
}

// `rgba` is the first pixel's red; the four channels follow each other.
template <class Channel>
Imf::FrameBuffer frame_buffer(Imf::PixelType type, const Channel* rgba, const float* depth_m,
                              const Imath::Box2i& window) {
    Imf::FrameBuffer buffer;
    for (std::size_t channel = 0; channel < 4; ++channel) {
        buffer.insert(kColourChannels[channel], Imf::Slice::Make(type, rgba + channel, window, 4 * sizeof(Channel)));
    }
    buffer.insert("Z", Imf::Slice::Make(Imf::FLOAT, depth_m, window));
    return buffer;
}

// Throws whatever OpenEXR throws when the file is not there, not OpenEXR, cut off or damaged.
Frame load(const std::filesystem::path& file) {
    Imf::InputFile input(file.c_str(), kThreadsWithinFrame);
    for (const char* channel : {"R", "G", "B", "A", "Z"}) {
        if (!input.header().channels().findChannel(channel)) {
            throw std::invalid_argument(fmt::format("it has no channel {}", channel));
        }
    }
    // Before memory is taken: a header that promises more lines than the file has is found here.
    if (!input.isComplete()) throw std::invalid_argument("it is incomplete");

    const Imath::Box2i window = input.header().dataWindow();
    Frame frame;
    frame.width = window.max.x - window.min.x + 1;
    frame.height = window.max.y - window.min.y + 1;
    const std::size_t pixel_count = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    frame.rgba.resize(pixel_count);
    frame.depth_m.resize(pixel_count);
    input.setFrameBuffer(frame_buffer(Imf::FLOAT, frame.rgba.data()->data(), frame.depth_m.data(), window));
    input.readPixels(window.min.y, window.max.y);
    return frame;
}

}  // namespace

void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameHeader& header) {
    const std::size_t pixel_count = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    check(frame.width > 0 && frame.height > 0, "a frame has pixels");
    check(frame.rgba.size() == pixel_count && frame.depth_m.size() == pixel_count, "a frame has all its pixels");
    check(std::ranges::all_of(frame.depth_m, [](float z) { return std::isfinite(z); }), "a frame's depths are finite");
    const std::vector<HalfPixel> pixels = half_pixels(frame);

    ExrStream stream(file);
    {
        const Imf::Header exr = exr_header(header, frame.width, frame.height);
        Imf::OutputFile output(stream, exr, kThreadsWithinFrame);
        output.setFrameBuffer(frame_buffer(Imf::HALF, pixels.data()->data(), frame.depth_m.data(), exr.dataWindow()));
        output.writePixels(frame.height);
    }  // OpenEXR writes the table of lines as it closes
    stream.commit();
}

bool is_complete_frame(const std::filesystem::path& file) {
    // Decoding every line is the only test that a cut at any byte and a damaged block both fail.
    try {
        static_cast<void>(load(file));
        return true;
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
