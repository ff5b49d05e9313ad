#pragma once

#include <functional>
#include <vector>

#include "film/film_facts.h"
#include "flight/motion.h"
#include "shade/ground_facts.h"
#include "shot/scene_shader.h"
#include "trace/sight.h"

namespace overfly {

// What the layers of a shot are told from, beside light. All must outlive whoever has it.
struct FactSources {
    FactKinds kinds;
    const GroundFacts* ground = nullptr;
    // The camera's, from the frame before the first until the one after the last; where Quantity::Motion is wanted.
    const Sight* sight = nullptr;
    double px_per_film = 1.0;
    std::function<Float4(Point<Scene>)> geodetic;  // GroundFacts::Kind::Geodetic of any place
    std::vector<ObjectNumber> surfaces;            // which object each surface is, where the ground says no other
};

// Tells of looks what layers want to know.
class LookFacts {
  public:
    // Both must outlive it, and so must the shader's facts. camera: SceneShader::radiance's.
    LookFacts(const SceneShader& shader, const MotionPiece& camera)
        : shader_(&shader), sources_(shader.facts()), camera_(&camera) {}

    [[nodiscard]] bool wanted() const { return sources_ != nullptr && sources_->kinds.any(); }
    [[nodiscard]] const FactSources& sources() const { return *sources_; }

    // A look at the ground whose light has been found.
    struct GroundLook {
        double x = 0.0, y = 0.0, time_s = 0.0;
        double depth_m = 0.0;
        RasterPlace place;
        Rgb behind, left, seen;  // behind the air, the share that comes through it, and what is seen
    };
    [[nodiscard]] Told of_ground(const GroundLook& look, const FrameSteps& steps) const;
    [[nodiscard]] Told of(const SceneShader::Look& look, const FrameSteps& steps) const;

    // Which object a look sees; 0: none.
    [[nodiscard]] ObjectNumber object_of(const SceneShader::Look& look) const;
    [[nodiscard]] ObjectNumber object_on_ground(RasterPlace place) const;

  private:
    // Where a fixed place of a surface is seen.
    struct Mark {
        std::uint32_t surface = 0;
        Point<Scene> own;  // in that surface's frame
        double time_s = 0.0;
    };
    struct Lit;
    [[nodiscard]] Told told(const Lit& lit, const Mark& mark, const FrameSteps& steps) const;
    [[nodiscard]] Float4 motion(const Mark& mark, const FrameSteps& steps) const;

    const SceneShader* shader_;
    const FactSources* sources_;
    const MotionPiece* camera_;
};

}  // namespace overfly
