#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "film/film_frame.h"
#include "shade/air_views.h"
#include "shot/fact_deposits.h"
#include "shot/many_looks.h"

namespace overfly {

// Light on its way to film: what lines of sight see is looked up for many at once, and then added to the pixels in the
// order in which it came.
class LightDeposits {
  public:
    // All must outlive it. camera: SceneShader::radiance's. lines: of sight, or samples, for each pixel.
    LightDeposits(const SceneShader& shader, const MotionPiece& camera, std::span<FilmFrame* const> films, int lines)
        : many_(shader, camera), films_(films), facts_(shader, camera, films, lines) {}
    ~LightDeposits() { flush(); }
    LightDeposits(const LightDeposits&) = delete;
    LightDeposits& operator=(const LightDeposits&) = delete;

    // What the sighting refers to must stay where it is until flush().
    void add(std::size_t film, std::size_t pixel, double weight, const SceneShader::Look& look) {
        this->look(look);
        to(film, pixel, weight);
    }
    // The same for one look and any number of pixels: first the look, then where it goes to.
    void look(const SceneShader::Look& look) {
        if (count_ == kSize) flush();
        looks_[count_++] = look;
    }
    void to(std::size_t film, std::size_t pixel, double weight, bool with_depth = true) {
        whither_.push_back({static_cast<std::uint32_t>(count_ - 1), static_cast<std::uint32_t>(film),
                            static_cast<std::uint32_t>(pixel), static_cast<float>(weight), with_depth});
    }

    void flush() {
        many_.look(std::span(looks_).first(count_), std::span(found_).first(count_));
        for (const Place& p : whither_) {
            Radiance found = found_[p.look];
            if (!p.with_depth) found.depth_m = Frame::kNoDepth;
            films_[p.film]->add(p.pixel, p.weight, found);
        }
        if (facts_.wanted()) tell();
        whither_.clear();
        count_ = 0;
    }

  private:
    static constexpr std::size_t kSize = AirViews::kSize;
    struct Place {
        std::uint32_t look = 0, film = 0, pixel = 0;
        float weight = 0.0F;
        bool with_depth = true;
    };

    void tell() {
        std::size_t told_look = kSize, told_film = 0;
        Told told{};
        ObjectNumber object = 0;
        for (const Place& p : whither_) {
            if (p.look != told_look || p.film != told_film) {
                told = facts_.facts().of(looks_[p.look], films_[p.film]->facts().steps());
                object = facts_.facts().object_of(looks_[p.look]);
                told_look = p.look;
                told_film = p.film;
            }
            facts_.deposit(told, object, p.film, p.pixel, p.weight);
        }
    }

    ManyLooks many_;
    std::span<FilmFrame* const> films_;
    FactDeposits facts_;
    std::size_t count_ = 0;
    std::array<SceneShader::Look, kSize> looks_{};
    std::vector<Place> whither_;
    std::array<Radiance, kSize> found_{};
};

}  // namespace overfly
