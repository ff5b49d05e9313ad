#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/float4.h"
#include "film/film_frame.h"
#include "shade/ground_nodes.h"
#include "shade/ground_runs.h"
#include "shot/fact_deposits.h"
#include "shot/pixel_run.h"
#include "shot/scene_shader.h"

namespace overfly {

// Light that lines of sight collect for a while, on its way to film: what comes along one is followed as a chain of
// straight pieces, which is integrated exactly over every pixel that the line passes meanwhile. Where a line sees one
// triangle of the ground, the joints (nodes) are so close that between two of them it moves by no more than a part of a
// cell of the raster. What layers are to be told goes the same way.
class LineDeposits {
  public:
    // All must outlive it. camera: SceneShader::radiance's. lines: of sight, for each pixel.
    LineDeposits(const SceneShader& shader, const MotionPiece& camera, std::span<FilmFrame* const> films, int lines)
        : shader_(&shader),
          camera_(&camera),
          films_(films),
          facts_(shader, camera, films, lines),
          sky_facts_(shader, camera, films, lines) {}
    ~LineDeposits() { flush(); }
    LineDeposits(const LineDeposits&) = delete;
    LineDeposits& operator=(const LineDeposits&) = delete;

    // REQUIRES: the sighting is of the ground all through `when`. Shares are copied.
    void add_ground(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to);
    // What is seen where there is no triangle. false: the round Earth ends there before the sky, so that nothing has
    // been added, as what is seen isn't smooth. REQUIRES: the sighting is of nothing.
    [[nodiscard]] bool add_sky(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to);
    void flush();

  private:
    void add_sky_facts(const SceneShader::Sighting& sighting, TimeRange when, int pieces, const PixelRun& to);
    void ask_nodes(std::size_t run);
    void look();
    void deposit(std::span<const Float4> nodes, float alpha, const PixelRun& to) const;
    void deposit_evenly(std::span<const Float4> nodes, float alpha, const PixelRun& to) const;
    void deposit_shares(std::span<const Float4> nodes, float alpha, const PixelRun& to) const;

    const SceneShader* shader_;
    const MotionPiece* camera_;
    std::span<FilmFrame* const> films_;
    std::size_t count_ = 0;  // of runs
    GroundRuns runs_;
    std::array<PixelRun, GroundRuns::kSize> to_{};
    std::vector<RunShares> shares_;  // of each, where it has some
    std::array<std::uint32_t, GroundRuns::kSize + 1> first_node_{};
    // Red, green, blue and planar depth at the nodes of one run after another.
    std::vector<Float4> nodes_;
    FactDeposits facts_, sky_facts_;
    GroundNodes asked_;  // the last of them, which still have to be looked at
    std::size_t asked_count_ = 0;
};

}  // namespace overfly
