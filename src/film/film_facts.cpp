#include "film/film_facts.h"

namespace overfly {

void FilmFacts::divide(std::size_t pixel, float weight) {
    for (std::size_t slot = 0; slot < kinds_.quantities.count(); ++slot) of(pixel)[slot] /= scale(slot, weight);
    if (!objects_.empty()) objects_.scale(pixel, 1.0F / weight);
}

void FilmFacts::join(const FilmFacts& other) {
    const std::size_t count = kinds_.quantities.count();
    const std::size_t pixels = count > 0 ? sums_.size() / count : 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        for (std::size_t slot = 0; slot < count; ++slot) {
            const bool adds_up = kinds_.quantities.at(slot) == Quantity::Effort;
            of(pixel)[slot] = (adds_up ? 1.0F : 0.5F) * (of(pixel)[slot] + other.of(pixel)[slot]);
        }
    }
    for (std::size_t pixel = 0; pixel < objects_.size(); ++pixel) {
        objects_.scale(pixel, 0.5F);
        for (const ObjectShares::Share& s : other.objects_.of(pixel)) {
            if (s.object != 0) objects_.add(pixel, s.object, 0.5F * s.weight);
        }
    }
}

void FilmFacts::add_from(const FilmFacts& other, std::size_t its_pixel, std::size_t pixel, float weight) {
    for (std::size_t slot = 0; slot < kinds_.quantities.count(); ++slot)
        of(pixel)[slot] += scale(slot, weight) * other.of(its_pixel)[slot];
    if (objects_.empty()) return;
    for (const ObjectShares::Share& s : other.objects_.of(its_pixel)) {
        if (s.object != 0) objects_.add(pixel, s.object, weight * s.weight);
    }
}

}  // namespace overfly
