#pragma once

#include <array>
#include <cstddef>

namespace overfly {

// A part of a cell of time, [begin, end] within [0, 1].
struct Stretch {
    double begin = 0.0, end = 1.0;
};

// Ascending and apart; kMost at most.
template <std::size_t kMost>
struct Stretches {
    std::array<Stretch, kMost> at;
    std::size_t count = 0;

    [[nodiscard]] const Stretch* begin() const { return at.data(); }
    [[nodiscard]] const Stretch* end() const { return at.data() + count; }
};

// Cuts a stretch where something may change, and keeps the parts that count.
template <std::size_t kMostCuts>
class StretchCuts {
  public:
    explicit StretchCuts(Stretch whole) : whole_(whole) { at_[count_++] = whole.begin; }

    // In any order; what lies outside the stretch cuts nothing.
    void add(double u) {
        if (!(whole_.begin < u && u < whole_.end)) return;
        std::size_t i = count_++;
        for (; at_[i - 1] > u; --i) at_[i] = at_[i - 1];
        at_[i] = u;
    }

    // The parts in whose middle `counts` holds, put together where they touch. Of n cuts come n + 1 parts, of which
    // every other can stand alone.
    template <class Counts>
    [[nodiscard]] Stretches<kMostCuts / 2 + 1> where(const Counts& counts) {
        at_[count_] = whole_.end;
        Stretches<kMostCuts / 2 + 1> kept;
        bool goes_on = false;
        for (std::size_t i = 0; i < count_; ++i) {
            if (at_[i + 1] <= at_[i]) continue;
            const bool is_kept = counts(0.5 * (at_[i] + at_[i + 1]));
            if (is_kept && !goes_on) kept.at[kept.count++].begin = at_[i];
            if (is_kept) kept.at[kept.count - 1].end = at_[i + 1];
            goes_on = is_kept;
        }
        return kept;
    }

  private:
    Stretch whole_;
    std::array<double, kMostCuts + 2> at_;  // ascending
    std::size_t count_ = 0;
};

}  // namespace overfly
