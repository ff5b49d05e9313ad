#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/float4.h"
#include "film/film_frame.h"
#include "shade/ground_nodes.h"
#include "shade/ground_runs.h"
#include "shade/sky_runs.h"
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
          sky_facts_(shader, camera, films, lines),
          skies_(camera, *shader.daylight_, *shader.light_, Frame::kNoDepth) {}
    ~LineDeposits() { flush(); }
    LineDeposits(const LineDeposits&) = delete;
    LineDeposits& operator=(const LineDeposits&) = delete;

    // REQUIRES: the sighting is of the ground all through `when`. Shares are copied.
    void add_ground(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to);
    // What is seen where there is no triangle. Where the round Earth ends there before the sky nothing is added, as
    // that isn't smooth: such runs are left over. REQUIRES: the sighting is of nothing.
    void add_sky(const SceneShader::Sighting& sighting, TimeRange when, const PixelRun& to);
    void flush();
    // By their numbers among all that add_sky() was called with, ascending. REQUIRES: flush() has been since then.
    [[nodiscard]] std::span<const std::size_t> left_over() const { return left_over_; }

  private:
    // Where the light of runs goes to; each has its own copy of its shares.
    class Targets {
      public:
        void set(std::size_t k, const PixelRun& to);
        [[nodiscard]] const PixelRun& operator[](std::size_t k) const { return to_[k]; }
        [[nodiscard]] std::span<const PixelRun> all() const { return to_; }

      private:
        std::array<PixelRun, GroundRuns::kSize> to_{};
        std::vector<RunShares> shares_;  // of each, where it has some
    };

    void flush_ground();
    void flush_sky();
    void deposit_sky_facts(std::size_t run);
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
    Targets to_;
    std::array<std::uint32_t, GroundRuns::kSize + 1> first_node_{};
    // Red, green, blue and planar depth at the nodes of one run after another.
    std::vector<Float4> nodes_;
    FactDeposits facts_, sky_facts_;
    GroundNodes asked_;  // the last of them, which still have to be looked at
    std::size_t asked_count_ = 0;

    SkyRuns skies_;
    static_assert(SkyRuns::kSize == GroundRuns::kSize);
    Targets to_of_sky_;
    std::array<SceneShader::Sighting, SkyRuns::kSize> sky_sightings_{};
    std::array<TimeRange, SkyRuns::kSize> sky_times_{};
    std::size_t skies_before_ = 0;  // that have been flushed
    std::vector<std::size_t> left_over_;
};

}  // namespace overfly
