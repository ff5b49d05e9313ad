#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "film/frame_storage.h"

namespace overfly {

// What a frame may tell beside R, G, B, A and Z. All layers are integrated over the exposure and the pixel with the
// weights of the beauty. docs/layers.md says how each is defined.
enum class Layer : std::uint8_t {
    Range,         // distance of the nearest surface along the ray, metres
    Mean,          // mean.Z, mean.range: of all surfaces in the pixel, by the time and area that they are seen
    Coverage,      // share of the pixel and the exposure in which a surface is seen: ground of the data, or a body
    Normal,        // N, a unit vector in the scene before it is averaged
    Position,      // P, scene metres
    Motion,        // forward, backward: what is seen, to where it is at the next and the previous frame, pixels
    Albedo,        // of surfaces
    Direct,        // light of the sun as it would be without shadows
    Shadow,        // what shadows take of it: not above 0
    Sky,           // light of the sky and of the ground around
    Haze,          // that the air adds before surfaces
    Background,    // the sky itself, and the Earth beyond the data
    Reflection,    // what mirrors send instead of their own light
    Longitude,     // degrees
    Latitude,      // degrees
    Elevation,     // elevation.ellipsoid, elevation.sea_level: metres
    Slope,         // of the mean normal to the vertical, degrees
    Aspect,        // where the mean normal points to, degrees clockwise from north
    SunIncidence,  // of the mean normal to the sun, degrees
    Id,            // what is seen most in the pixel: the number by which Cryptomatte calls it
    Cryptomatte,   // the six objects that are seen most, and how much of each
    Density,       // lines of sight, or samples, for each pixel
    Cost,          // how many surfaces they meet there, one after another
};
inline constexpr int kLayers = static_cast<int>(Layer::Cost) + 1;

class LayerSet {
  public:
    constexpr LayerSet() = default;
    constexpr LayerSet(std::initializer_list<Layer> layers) {
        for (const Layer layer : layers) add(layer);
    }
    constexpr void add(Layer layer) { bits_ |= bit(layer); }
    constexpr void add(LayerSet others) { bits_ |= others.bits_; }
    [[nodiscard]] constexpr bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
    [[nodiscard]] constexpr bool has_any(LayerSet others) const { return (bits_ & others.bits_) != 0; }
    [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
    friend constexpr bool operator==(LayerSet, LayerSet) = default;

  private:
    static constexpr std::uint32_t bit(Layer layer) { return std::uint32_t{1} << static_cast<unsigned>(layer); }
    std::uint32_t bits_ = 0;
};

// As what type a file holds a channel. Half has 11 binary digits and ends at 65504: good for light and directions only.
enum class StoredAs : std::uint8_t { Half, Float, Uint };

// How a layer is called, and how a file holds it.
struct LayerKind {
    Layer layer;
    std::string_view name;  // as a shot asks for it
    StoredAs type;
    LayerGroup group;
    std::span<const std::string_view> channels;  // their names in a file
    std::string_view meaning;                    // one line, with the unit
};

// All of them, in the order of Layer.
[[nodiscard]] std::span<const LayerKind> layer_kinds();
[[nodiscard]] inline const LayerKind& kind_of(Layer layer) { return layer_kinds()[static_cast<std::size_t>(layer)]; }

// Those in a set, in the order of Layer, and how they are called.
[[nodiscard]] std::vector<LayerKind> kinds_of(LayerSet layers);
[[nodiscard]] std::vector<std::string> names_of(LayerSet layers);
// Of such names. Those that are none are of a later version, and passed over.
[[nodiscard]] LayerSet layers_of(std::span<const std::string> names);

// The one that has a channel of this name; nothing for R, G, B, A, Z and what else is none.
[[nodiscard]] std::optional<Layer> layer_of_channel(std::string_view channel);

// Several layers under one name: "light" (those that add up to the beauty), "geo", "all".
[[nodiscard]] std::optional<LayerSet> layers_named(std::string_view name);

}  // namespace overfly
