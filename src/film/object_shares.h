#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace overfly {

// A thing that is told apart from others in a picture: the terrain, a class of it, a body. 0: nothing, the sky.
using ObjectNumber = std::uint16_t;

// Which objects are seen in each pixel of a frame, and how much of each: the exact share of time and area as long as
// there are no more than eight in a pixel; of more, those that came first and those that have more than the least.
class ObjectShares {
  public:
    static constexpr std::size_t kMost = 8;
    struct Share {
        ObjectNumber object = 0;
        float weight = 0.0F;
        friend bool operator==(const Share&, const Share&) = default;
    };
    using Pixel = std::array<Share, kMost>;

    ObjectShares() = default;
    explicit ObjectShares(std::size_t pixels) : pixels_(pixels) {}

    [[nodiscard]] bool empty() const { return pixels_.empty(); }
    [[nodiscard]] std::size_t size() const { return pixels_.size(); }
    // REQUIRES: an object.
    void add(std::size_t pixel, ObjectNumber object, float weight) {
        Pixel& shares = pixels_[pixel];
        for (Share& s : shares) {
            if (s.object != object && s.object != 0) continue;
            s.object = object;
            s.weight += weight;
            return;
        }
        Share& least = *std::ranges::min_element(shares, {}, &Share::weight);
        if (least.weight < weight) least = {object, weight};
    }
    void scale(std::size_t pixel, float by) {
        for (Share& s : pixels_[pixel]) s.weight *= by;
    }
    [[nodiscard]] const Pixel& of(std::size_t pixel) const { return pixels_[pixel]; }
    // Those that are seen, most first; of equals the one with the lesser number.
    [[nodiscard]] Pixel ranked(std::size_t pixel) const {
        Pixel shares = pixels_[pixel];
        std::ranges::sort(shares, [](const Share& a, const Share& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.object < b.object;
        });
        return shares;
    }
    [[nodiscard]] std::size_t memory_bytes() const { return pixels_.size() * sizeof(Pixel); }

  private:
    std::vector<Pixel> pixels_;
};

}  // namespace overfly
