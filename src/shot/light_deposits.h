#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "film/film_frame.h"
#include "shade/air_views.h"
#include "shot/many_looks.h"

namespace overfly {

// Light on its way to film: what lines of sight see is looked up for many at once, and then added to the pixels in the
// order in which it came.
class LightDeposits {
  public:
    // All must outlive it. camera: SceneShader::radiance's.
    LightDeposits(const SceneShader& shader, const MotionPiece& camera, std::span<FilmFrame* const> films)
        : many_(shader, camera), films_(films) {}
    ~LightDeposits() { flush(); }
    LightDeposits(const LightDeposits&) = delete;
    LightDeposits& operator=(const LightDeposits&) = delete;

    // What the sighting refers to must stay where it is until flush().
    void add(std::size_t film, std::size_t pixel, double weight, const SceneShader::Look& look) {
        looks_[count_] = look;
        whither_[count_] = {static_cast<std::uint32_t>(film), static_cast<std::uint32_t>(pixel),
                            static_cast<float>(weight)};
        if (++count_ == kSize) flush();
    }

    void flush() {
        many_.look(std::span(looks_).first(count_), std::span(found_).first(count_));
        for (std::size_t i = 0; i < count_; ++i)
            films_[whither_[i].film]->add(whither_[i].pixel, whither_[i].weight, found_[i]);
        count_ = 0;
    }

  private:
    static constexpr std::size_t kSize = AirViews::kSize;
    struct Place {
        std::uint32_t film = 0, pixel = 0;
        float weight = 0.0F;
    };

    ManyLooks many_;
    std::span<FilmFrame* const> films_;
    std::size_t count_ = 0;
    std::array<SceneShader::Look, kSize> looks_{};
    std::array<Place, kSize> whither_{};
    std::array<Radiance, kSize> found_{};
};

}  // namespace overfly
