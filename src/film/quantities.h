#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/colour.h"
#include "core/float4.h"
#include "core/geometry.h"
#include "film/layers.h"

namespace overfly {

// What a line of sight tells at one instant beside colour and depth, in four numbers each; layers are made of their
// averages. Those of surfaces are 0 where the line meets none.
enum class Quantity : std::uint8_t {
    Surface,   // 1 (coverage), planar depth and distance in metres
    Effort,    // lines for each pixel; and a count, which is not averaged: surfaces met
    Position,  // in the scene, metres
    Normal,    // in the scene
    Geodetic,  // longitude and latitude less the scene origin's, degrees; height above the ellipsoid, and the sea
    Motion,    // to the next frame, right and down, pixels; and to the previous one
    Albedo,    // this and all below: red, green, blue
    Direct,    // as the layers of that name
    Shadow,
    Sky,
    Haze,
    Background,
    Reflection,
};
inline constexpr std::size_t kQuantities = static_cast<std::size_t>(Quantity::Reflection) + 1;

// Some of them, one after another.
class Quantities {
  public:
    constexpr Quantities() = default;
    // All that these layers are made of.
    explicit Quantities(LayerSet layers);

    [[nodiscard]] bool has(Quantity q) const { return slot_of(q) >= 0; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] Quantity at(std::size_t slot) const { return wanted_[slot]; }
    // Where it is among those that are wanted. REQUIRES: it is.
    [[nodiscard]] std::size_t slot(Quantity q) const { return static_cast<std::size_t>(slot_of(q)); }

    friend bool operator==(const Quantities&, const Quantities&) = default;

  private:
    [[nodiscard]] int slot_of(Quantity q) const { return slots_[static_cast<std::size_t>(q)] - 1; }
    void add(Quantity q);

    std::size_t count_ = 0;
    std::array<Quantity, kQuantities> wanted_{};
    std::array<std::int8_t, kQuantities> slots_{};  // from 1 on; 0: not wanted
};

// As a quantity holds it.
[[nodiscard]] inline Float4 four(Rgb c) { return Float4{c.r, c.g, c.b, 0.0F}; }
template <class Frame>
[[nodiscard]] Float4 four(Vector<Frame> v) {
    return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F};
}

// All that is told at one instant, in the order of some Quantities.
using Told = std::array<Float4, kQuantities>;

}  // namespace overfly
