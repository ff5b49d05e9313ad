#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "film/film_frame.h"
#include "shade/ground_nodes.h"
#include "shade/ground_runs.h"
#include "shot/look_facts.h"
#include "shot/pixel_run.h"

namespace overfly {

// What lines of sight tell for layers, on its way to film beside their light (line_deposits.h): at the same nodes,
// straight between them, and integrated in the same way. Objects have no mean: where one ends on the ground a line
// passes the edge between two samples, which is found between two nodes.
class FactDeposits {
  public:
    // All must outlive it. lines: for each pixel.
    FactDeposits(const SceneShader& shader, const MotionPiece& camera, std::span<FilmFrame* const> films, int lines)
        : facts_(shader, camera), camera_(&camera), films_(films), lines_(static_cast<float>(lines)) {}

    [[nodiscard]] bool wanted() const { return facts_.wanted(); }
    [[nodiscard]] const LookFacts& facts() const { return facts_; }

    // Before nodes look through the air, and after.
    void keep_behind(const GroundNodes& nodes, std::size_t count);
    void tell(const GroundRuns& runs, const GroundNodes& nodes, std::size_t count, std::span<const PixelRun> to);
    // Of what there is where there is no triangle.
    void tell(const SceneShader::Look& look, const PixelRun& to);
    // What the nodes from `first` on have told, counted from the last forget().
    void deposit(std::size_t first, std::size_t count, const PixelRun& to);
    void forget();

    // Of one look, for a pixel.
    void deposit(const Told& told, ObjectNumber object, std::size_t film, std::size_t pixel, float weight) const;

  private:
    // One object is seen until then.
    struct Seen {
        float until_v = 1.0F;
        ObjectNumber object = 0;
    };
    [[nodiscard]] const FrameSteps& steps(const PixelRun& to) const { return films_[to.film]->facts().steps(); }
    void deposit_values(const Float4* nodes, int pieces, const PixelRun& to) const;
    void deposit_shares(const Float4* nodes, int pieces, const RunShares& shares, FilmFacts& film) const;
    void find_objects(std::size_t first, std::size_t count);
    void find_between(RasterPlace from, RasterPlace to, float from_v, float to_v);
    void see(ObjectNumber object, float until_v);
    void deposit_objects(const PixelRun& to) const;
    void count(const PixelRun& to) const;

    LookFacts facts_;
    const MotionPiece* camera_;
    std::span<FilmFrame* const> films_;
    float lines_;
    std::array<Rgb, GroundNodes::kSize> behind_{};
    std::vector<Float4> told_;           // of one node after another, as many each as quantities are wanted
    std::vector<RasterPlace> places_;    // of nodes on ground that is told apart
    std::vector<ObjectNumber> objects_;  // of nodes
    std::vector<Seen> seen_;
    std::vector<float> crossings_v_;
};

}  // namespace overfly
