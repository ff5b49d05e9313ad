#include "shot/fact_deposits.h"

#include <algorithm>
#include <cmath>

#include "shot/chain_integral.h"

namespace overfly {

void FactDeposits::keep_behind(const GroundNodes& nodes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) behind_[i] = nodes.views.seen(i);
}

void FactDeposits::tell(const GroundRuns& runs, const GroundNodes& nodes, std::size_t count,
                        std::span<const PixelRun> to) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(nodes.run[i]);
        const double u = runs.from_u[k] + static_cast<double>(nodes.v[i]) * (runs.to_u[k] - runs.from_u[k]);
        const RasterPlace place = {runs.triangles.column[0][k] + static_cast<double>(nodes.from_column[i]),
                                   runs.triangles.row[0][k] + static_cast<double>(nodes.from_row[i])};
        if (facts_.sources().kinds.quantities.count() > 0) {
            const Told told =
                facts_.of_ground({runs.x[k], runs.y[k], camera_->time_at(u), static_cast<double>(nodes.depth_m[i]),
                                  place, behind_[i], nodes.views.share_left(i), nodes.views.seen(i)},
                                 steps(to[k]));
            told_.insert(told_.end(), told.begin(), told.begin() + facts_.sources().kinds.quantities.count());
        }
        objects_.push_back(facts_.object_on_ground(place));
        places_.push_back(place);
    }
}

void FactDeposits::tell(const SceneShader::Look& look, const PixelRun& to) {
    const Told told = facts_.of(look, steps(to));
    told_.insert(told_.end(), told.begin(), told.begin() + facts_.sources().kinds.quantities.count());
    objects_.push_back(0);
    places_.emplace_back();
}

void FactDeposits::forget() {
    told_.clear();
    objects_.clear();
    places_.clear();
}

void FactDeposits::deposit(std::size_t first, std::size_t count, const PixelRun& to) {
    const std::size_t stride = facts_.sources().kinds.quantities.count();
    if (stride > 0) {
        deposit_values(told_.data() + first * stride, static_cast<int>(count) - 1, to);
        this->count(to);
    }
    if (!facts_.sources().kinds.objects || objects_[first] == 0) return;
    find_objects(first, count);
    deposit_objects(to);
}

void FactDeposits::deposit(const Told& told, ObjectNumber object, std::size_t film, std::size_t pixel,
                           float weight) const {
    FilmFacts& facts = films_[film]->facts();
    facts.add(pixel, weight, told);
    facts.count_surface(pixel, weight, lines_);
    if (object != 0 && facts.kinds().objects) facts.objects().add(pixel, object, weight);
}

void FactDeposits::deposit_values(const Float4* nodes, int pieces, const PixelRun& to) const {
    FilmFacts& film = films_[to.film]->facts();
    const std::size_t slots = facts_.sources().kinds.quantities.count();
    const auto length = static_cast<float>(pieces);
    if (to.shares != nullptr) return deposit_shares(nodes, pieces, *to.shares, film);
    const float per_piece = static_cast<float>(to.weight) / length;
    for_each_pixel(to, [&](std::uint32_t pixel, float begin, float end) {
        Float4* const sums = film.of(pixel);
        for_each_node(begin * length, end * length, pieces, [&](std::size_t node, float weight) {
            const Float4* const told = nodes + node * slots;
            for (std::size_t slot = 0; slot < slots; ++slot) sums[slot] += (per_piece * weight) * told[slot];
        });
    });
}

void FactDeposits::deposit_shares(const Float4* nodes, int pieces, const RunShares& shares, FilmFacts& film) const {
    const std::size_t slots = facts_.sources().kinds.quantities.count();
    const auto length = static_cast<float>(pieces);
    const auto value_at = [&](float t, std::size_t slot) {
        const auto piece = static_cast<std::size_t>(std::clamp(static_cast<int>(t), 0, pieces - 1));
        const Float4 &from = nodes[piece * slots + slot], &to = nodes[(piece + 1) * slots + slot];
        return from + (t - static_cast<float>(piece)) * (to - from);
    };
    Told mean{}, growth{};
    float reached = 0.0F;
    std::size_t next = 0;
    for (const RunShares::Cell& cell : shares.cells) {
        const float begin = reached * length, end = cell.end_v * length;
        for (std::size_t slot = 0; slot < slots; ++slot) {
            growth[slot] = value_at(end, slot) - value_at(begin, slot);
            mean[slot] = end > begin ? Float4{} : value_at(begin, slot);
        }
        for_each_node(begin, end, pieces, [&](std::size_t node, float weight) {
            for (std::size_t slot = 0; slot < slots; ++slot)
                mean[slot] += (weight / (end - begin)) * nodes[node * slots + slot];
        });
        for (; next < cell.end_share; ++next) {
            const RunShares::Share& share = shares.shares[next];
            for (const RunShares::Row& row : shares.rows) {
                Float4* const sums = film.of(share.pixel + static_cast<std::uint32_t>(row.offset));
                for (std::size_t slot = 0; slot < slots; ++slot)
                    sums[slot] += row.weight * (share.whole * mean[slot] + share.growth * growth[slot]);
            }
        }
        reached = cell.end_v;
    }
}

void FactDeposits::count(const PixelRun& to) const {
    FilmFacts& film = films_[to.film]->facts();
    if (!film.kinds().quantities.has(Quantity::Effort)) return;
    if (to.shares == nullptr) {
        const auto weight = static_cast<float>(to.weight);
        for_each_pixel(to, [&](std::uint32_t pixel, float begin, float end) {
            film.count_surface(pixel, weight * (end - begin), lines_);
        });
        return;
    }
    for (const RunShares::Share& share : to.shares->shares) {
        for (const RunShares::Row& row : to.shares->rows)
            film.count_surface(share.pixel + static_cast<std::uint32_t>(row.offset), row.weight * share.whole, lines_);
    }
}

// Which objects a run sees, one after another.
void FactDeposits::find_objects(std::size_t first, std::size_t count) {
    seen_.clear();
    if (!facts_.sources().ground->has_objects()) return see(objects_[first], 1.0F);
    const float step = 1.0F / static_cast<float>(count - 1);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const float from_v = static_cast<float>(i) * step;
        const float to_v = i + 2 == count ? 1.0F : static_cast<float>(i + 1) * step;
        find_between(places_[first + i], places_[first + i + 1], from_v, to_v);
    }
}

// The nearest sample changes half way between two of them, along columns and along rows.
void FactDeposits::find_between(RasterPlace from, RasterPlace to, float from_v, float to_v) {
    crossings_v_.clear();
    const auto cross = [&](double begin, double end) {
        const double low = std::min(begin, end), high = std::max(begin, end);
        for (double edge = std::floor(low - 0.5) + 1.5; edge < high; edge += 1.0) {
            const auto part = static_cast<float>((edge - begin) / (end - begin));
            crossings_v_.push_back(from_v + part * (to_v - from_v));
        }
    };
    cross(from.column, to.column);
    cross(from.row, to.row);
    std::ranges::sort(crossings_v_);
    crossings_v_.push_back(to_v);
    float begin_v = from_v;
    for (const float end_v : crossings_v_) {
        const double part = static_cast<double>(0.5F * (begin_v + end_v) - from_v) / static_cast<double>(to_v - from_v);
        see(facts_.object_on_ground(
                {from.column + part * (to.column - from.column), from.row + part * (to.row - from.row)}),
            end_v);
        begin_v = end_v;
    }
}

void FactDeposits::see(ObjectNumber object, float until_v) {
    if (!seen_.empty() && seen_.back().object == object) {
        seen_.back().until_v = until_v;
    } else {
        seen_.push_back({until_v, object});
    }
}

void FactDeposits::deposit_objects(const PixelRun& to) const {
    ObjectShares& film = films_[to.film]->facts().objects();
    // What is seen from one v to another, in parts of that stretch.
    const auto for_each_part = [&](float begin, float end, const auto& with_part) {
        float reached = begin;
        for (const Seen& s : seen_) {
            if (s.until_v <= reached) continue;
            const float until = std::min(s.until_v, end);
            if (until > reached) with_part(s.object, (until - reached) / (end - begin));
            reached = until;
            if (reached >= end) return;
        }
    };
    if (to.shares == nullptr) {
        const auto weight = static_cast<float>(to.weight);
        for_each_pixel(to, [&](std::uint32_t pixel, float begin, float end) {
            for_each_part(begin, end, [&](ObjectNumber object, float part) {
                film.add(pixel, object, weight * (end - begin) * part);
            });
        });
        return;
    }
    float reached = 0.0F;
    std::size_t next = 0;
    for (const RunShares::Cell& cell : to.shares->cells) {
        for (std::size_t share = next; share < cell.end_share; ++share) {
            const RunShares::Share& s = to.shares->shares[share];
            for (const RunShares::Row& row : to.shares->rows) {
                for_each_part(reached, cell.end_v, [&](ObjectNumber object, float part) {
                    film.add(s.pixel + static_cast<std::uint32_t>(row.offset), object, row.weight * s.whole * part);
                });
            }
        }
        next = cell.end_share;
        reached = cell.end_v;
    }
}

}  // namespace overfly
