#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "shade/air_views.h"
#include "shade/ground_looks.h"
#include "shot/scene_shader.h"

namespace overfly {

// What SceneShader::radiance says of many looks, in a fraction of the time: looks at the ground find their places, and
// all look through the air, as many at once as a vector unit takes. Holds room for them, so one is made for many calls.
class ManyLooks {
  public:
    // Both must outlive it.
    ManyLooks(const SceneShader& shader, const MotionPiece& camera) : shader_(&shader), camera_(&camera) {}

    // REQUIRES: as many of out.
    void look(std::span<const SceneShader::Look> looks, std::span<Radiance> out);

  private:
    void look_at_ground(std::size_t i);
    void look_at_others(std::size_t i);
    void meet();  // those that look at the ground find their place on it, and its light
    void add_view(std::size_t i, Rgb behind, const AirViews::Path& path);
    void finish();  // those that look through air see what is left

    const SceneShader* shader_;
    const MotionPiece* camera_;
    std::span<const SceneShader::Look> looks_;
    std::span<Radiance> out_;
    std::size_t ground_count_ = 0, view_count_ = 0;
    GroundLooks ground_;
    AirViews views_;
    std::array<std::uint32_t, GroundLooks::kSize> on_ground_{};  // which look each is
    std::array<std::uint32_t, AirViews::kSize> in_air_{};
};

}  // namespace overfly
