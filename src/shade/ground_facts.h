#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/float4.h"
#include "shade/lit_ground.h"
#include "terrain/sample_grid.h"

namespace overfly {

// What the full mesh tells of a place beside its light, for layers. Only what is asked for is held: 16 bytes for each
// sample of the raster, of each kind.
class GroundFacts {
  public:
    enum class Kind : std::uint8_t {
        Normal,    // in the scene, a unit vector at each sample
        Geodetic,  // longitude and latitude less the scene origin's, degrees; two heights, metres
        Albedo,    // red, green, blue
        Sunlight,  // GroundLight::sunlight
    };

    GroundFacts() = default;  // nothing
    // Of the full mesh. Places are told as LitGround::corners of the same mesh.
    explicit GroundFacts(const SampleGrid& grid) : columns_(grid.columns), rows_(grid.rows) {}

    // grid: the same. of_vertices: of each vertex of that mesh.
    void add(Kind kind, const SampleGrid& grid, std::span<const Float4> of_vertices);
    // Numbers of what is told apart on the ground, of each vertex as well.
    void add_objects(const SampleGrid& grid, std::span<const std::uint16_t> of_vertices);

    [[nodiscard]] bool has(Kind kind) const { return !samples(kind).empty(); }
    // Linear over each triangle of the full mesh, as light is. REQUIRES: has(kind).
    [[nodiscard]] Float4 at(Kind kind, const LitGround::Corners& c) const {
        const Float4* const s = samples(kind).data() + c.index;
        const Float4* const below = s + columns_;
        return c.first * *s + c.beside * s[1] + c.under * *below + c.opposite * below[1];
    }
    // Of the nearest sample; 0 where no objects are told apart.
    [[nodiscard]] std::uint16_t object_at(RasterPlace place) const;
    [[nodiscard]] bool has_objects() const { return !objects_.empty(); }

  private:
    [[nodiscard]] const std::vector<Float4>& samples(Kind kind) const {
        return samples_[static_cast<std::size_t>(kind)];
    }
    int columns_ = 0, rows_ = 0;
    std::array<std::vector<Float4>, 4> samples_;
    std::vector<std::uint16_t> objects_;
};

}  // namespace overfly
