#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/colour.h"
#include "core/float4.h"
#include "film/film_facts.h"
#include "film/frame.h"

namespace overfly {

// What comes along a line of sight at one instant; colour is premultiplied with alpha.
struct Radiance {
    Rgb colour;
    float alpha = 1.0F;
    float depth_m = Frame::kNoDepth;
};

// What film is when it is developed: a frame without layers, and the averages that its layers are made of.
struct ExposedFrame {
    Frame frame;
    FilmFacts facts;

    // The mean of both. REQUIRES: as large, of the same kinds; both are of as many lines.
    void join(const ExposedFrame& other);
};

// One frame while it is being exposed. Different pixels may be added to from different threads at once.
class FilmFrame {
  public:
    // Whether the weights that a pixel gets in all add up to 1, or are counted so that the film is developed by them.
    enum class Weights : std::uint8_t { AddUp, AreCounted };
    FilmFrame(int width, int height, Weights weights = Weights::AddUp, const FactKinds& kinds = {},
              const FrameSteps& steps = {});

    void add(std::size_t pixel, float weight, const Radiance& radiance) {
        if (!weights_.empty()) weights_[pixel] += weight;
        std::array<float, 4>& p = frame_.rgba[pixel];
        p[0] += weight * radiance.colour.r;
        p[1] += weight * radiance.colour.g;
        p[2] += weight * radiance.colour.b;
        p[3] += weight * radiance.alpha;
        if (radiance.depth_m < frame_.depth_m[pixel]) frame_.depth_m[pixel] = radiance.depth_m;
    }
    // Light that has its weight already, alpha the last.
    void add(std::size_t pixel, Float4 weighted, float depth_m) {
        Float4 sum;
        std::memcpy(&sum, frame_.rgba[pixel].data(), sizeof sum);
        sum += weighted;
        std::memcpy(frame_.rgba[pixel].data(), &sum, sizeof sum);
        if (depth_m < frame_.depth_m[pixel]) frame_.depth_m[pixel] = depth_m;
    }
    // The same, with the weight that it has.
    void add(std::size_t pixel, float weight, Float4 weighted, float depth_m) {
        if (!weights_.empty()) weights_[pixel] += weight;
        add(pixel, weighted, depth_m);
    }
    // What the layers are made of; nothing, unless it was asked for.
    [[nodiscard]] FilmFacts& facts() { return facts_; }
    [[nodiscard]] bool has_facts() const { return facts_.kinds().any(); }

    [[nodiscard]] ExposedFrame develop() &&;
    [[nodiscard]] std::size_t memory_bytes() const;
    // Of one that is made like this.
    [[nodiscard]] static std::size_t memory_bytes(int width, int height, Weights weights, const FactKinds& kinds);

  private:
    Frame frame_;
    std::vector<float> weights_;  // where they are counted
    FilmFacts facts_;
};

}  // namespace overfly
