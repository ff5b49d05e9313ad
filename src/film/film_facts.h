#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "film/object_shares.h"
#include "film/quantities.h"

namespace overfly {

// What film is told beside light.
struct FactKinds {
    Quantities quantities;
    bool objects = false;

    FactKinds() = default;
    explicit FactKinds(LayerSet layers)
        : quantities(layers), objects(layers.has_any({Layer::Id, Layer::Cryptomatte})) {}
    [[nodiscard]] bool any() const { return objects || quantities.count() > 0; }
};

// How far away the frames beside one are, in the flight's time.
struct FrameSteps {
    double next_s = 0.0, previous_s = 0.0;  // both positive
    std::optional<double> instant_s{};      // of a frame that has no other time
};

// What lines of sight have told of the pixels of a frame, added up by the weights that their light has. Different
// pixels may be added to from different threads at once.
class FilmFacts {
  public:
    FilmFacts() = default;
    FilmFacts(std::size_t pixels, const FactKinds& kinds, const FrameSteps& steps = {})
        : kinds_(kinds),
          steps_(steps),
          sums_(pixels * kinds.quantities.count()),
          objects_(kinds.objects ? pixels : 0) {}

    [[nodiscard]] const FactKinds& kinds() const { return kinds_; }
    [[nodiscard]] const FrameSteps& steps() const { return steps_; }
    [[nodiscard]] ObjectShares& objects() { return objects_; }
    [[nodiscard]] const ObjectShares& objects() const { return objects_; }

    // Of a pixel, one after another as kinds().quantities has them.
    [[nodiscard]] Float4* of(std::size_t pixel) { return sums_.data() + pixel * kinds_.quantities.count(); }
    [[nodiscard]] const Float4* of(std::size_t pixel) const { return sums_.data() + pixel * kinds_.quantities.count(); }
    [[nodiscard]] Float4 value(std::size_t pixel, Quantity q) const { return of(pixel)[kinds_.quantities.slot(q)]; }

    // All that is told at an instant, with a weight.
    void add(std::size_t pixel, float weight, const Told& told) {
        for (std::size_t slot = 0; slot < kinds_.quantities.count(); ++slot) of(pixel)[slot] += weight * told[slot];
    }
    // Counts are not averaged: `lines` meet one more surface there.
    void count_surface(std::size_t pixel, float weight, float lines) {
        if (kinds_.quantities.has(Quantity::Effort)) {
            of(pixel)[kinds_.quantities.slot(Quantity::Effort)] += Float4{weight * lines, 1.0F, 0.0F, 0.0F};
        }
    }

    // A pixel's averages, in place of the sums of as much weight.
    void divide(std::size_t pixel, float weight);
    // The same as both pictures together. REQUIRES: as large, of the same kinds; both are averages of as many lines.
    void join(const FilmFacts& other);
    // Adds a pixel of another picture. REQUIRES: the same kinds.
    void add_from(const FilmFacts& other, std::size_t its_pixel, std::size_t pixel, float weight);

    [[nodiscard]] std::size_t memory_bytes() const { return sums_.size() * sizeof(Float4) + objects_.memory_bytes(); }

  private:
    [[nodiscard]] Float4 scale(std::size_t slot, float by) const {
        if (kinds_.quantities.at(slot) == Quantity::Effort) return Float4{by, 1.0F, 1.0F, 1.0F};
        return Float4{by, by, by, by};
    }

    FactKinds kinds_;
    FrameSteps steps_;
    std::vector<Float4> sums_;
    ObjectShares objects_;
};

}  // namespace overfly
