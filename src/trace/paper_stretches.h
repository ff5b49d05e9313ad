#pragma once

#include <algorithm>
#include <vector>

namespace overfly {

// The times during which something holds that so far held always: apart, in order.
class PaperStretches {
  public:
    struct Stretch {
        double begin = 0.0, end = 1.0;
    };

    void hold_always() { stretches_.assign(1, Stretch{}); }
    [[nodiscard]] const std::vector<Stretch>& get() const { return stretches_; }

    // It does not hold between `begin` and `end`.
    void cut_out(double begin, double end) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            const Stretch s = stretches_[i];
            const Stretch before = {s.begin, std::min(s.end, begin)};
            const Stretch after = {std::max(s.begin, end), s.end};
            const bool is_before = before.begin < before.end;
            const bool is_after = after.begin < after.end;
            if (is_before) stretches_[kept++] = before;
            if (is_before && is_after) {
                // Only one of them is split: those that follow are whole.
                stretches_.insert(stretches_.begin() + static_cast<std::ptrdiff_t>(kept++), after);
                return;
            }
            if (is_after) stretches_[kept++] = after;
        }
        stretches_.resize(kept);
    }

  private:
    std::vector<Stretch> stretches_;
};

}  // namespace overfly
