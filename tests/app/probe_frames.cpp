#include "probe_frames.h"

#include <cstdlib>
#include <filesystem>
#include <map>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>
#include <half.h>

namespace overfly::probe {
namespace {

// A file as numbers: what half holds, float holds too.
class Picture {
  public:
    explicit Picture(const std::string& file) {
        Imf::InputFile input(file.c_str());
        header_ = input.header();
        const Imath::Box2i window = header_.dataWindow();
        width_ = window.max.x - window.min.x + 1;
        height_ = window.max.y - window.min.y + 1;
        Imf::FrameBuffer buffer;
        for (auto c = header_.channels().begin(); c != header_.channels().end(); ++c) {
            std::vector<float>& values = channels_[c.name()];
            values.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
            buffer.insert(c.name(), Imf::Slice::Make(Imf::FLOAT, values.data(), window));
        }
        input.setFrameBuffer(buffer);
        input.readPixels(window.min.y, window.max.y);
    }

    std::vector<float>& operator[](const std::string& channel) { return channels_.at(channel); }
    [[nodiscard]] const std::map<std::string, std::vector<float>>& channels() const { return channels_; }
    [[nodiscard]] bool is_half(const std::string& channel) const {
        return header_.channels()[channel.c_str()].type == Imf::HALF;
    }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    void take_pixels(const Picture& from) { channels_ = from.channels_; }

    void write(const std::string& file) const {
        std::map<std::string, std::vector<half>> halves;
        Imf::FrameBuffer buffer;
        for (const auto& [name, values] : channels_) {
            std::vector<half>& rounded = halves[name];
            for (const float v : values) rounded.emplace_back(v);
            buffer.insert(name, is_half(name) ? Imf::Slice::Make(Imf::HALF, rounded.data(), header_.dataWindow())
                                              : Imf::Slice::Make(Imf::FLOAT, values.data(), header_.dataWindow()));
        }
        Imf::OutputFile output(file.c_str(), header_);
        output.setFrameBuffer(buffer);
        output.writePixels(height_);
    }

  private:
    Imf::Header header_;
    int width_ = 0, height_ = 0;
    std::map<std::string, std::vector<float>> channels_;
};

template <class Value>
void print_bytes(const Value& value) {
    std::fwrite(&value, sizeof(value), 1, stdout);
}

}  // namespace

bool change(const Arguments& a) {
    Picture picture(a.at(0));
    for (float& v : picture[a.at(1)]) v *= std::strtof(a.at(2).c_str(), nullptr);
    picture.write(a.at(0));
    return true;
}

bool pixels_of(const Arguments& a) {
    Picture to(a.at(1));
    to.take_pixels(Picture(a.at(0)));
    to.write(a.at(1));
    return true;
}

bool print_hashed_bytes(const Arguments& a) {
    const Picture picture(a.at(0));
    fmt::print("{}x{}\n", picture.width(), picture.height());
    for (const auto& [name, values] : picture.channels()) {
        const bool is_half = picture.is_half(name);
        fmt::print("{} {}\n", name, is_half ? "half" : "float");
        for (const float v : values) {
            if (is_half) {
                print_bytes(half(v).bits());
            } else {
                print_bytes(v);
            }
        }
    }
    return true;
}

bool print_centroid(const Arguments& a) {
    Picture one(a.at(0)), other(a.at(1));
    double sum = 0.0, x_px = 0.0, y_px = 0.0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x) {
            const auto i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(one.width()) + static_cast<std::size_t>(x);
            const double difference = one[a.at(2)][i] - other[a.at(2)][i];
            sum += difference;
            x_px += difference * (x + 0.5);
            y_px += difference * (y + 0.5);
        }
    }
    if (sum == 0.0) return false;
    fmt::print("{:.5f} {:.5f}\n", x_px / sum, y_px / sum);
    return true;
}

}  // namespace overfly::probe
