#include "shot/line_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/low_discrepancy.h"

namespace overfly {
namespace {

constexpr int kGroupRows = 4, kGroupHomes = 4;  // of sixteen lines that are followed together

double unit_interval(std::uint32_t bits) { return 0x1p-32 * bits; }

// The homes of one row of pixels: number k at (k + phase) / per_pixel.
struct Row {
    int row;
    double phase, px_per_line;
    std::uint32_t seed;
    int next, end;  // numbers

    Row(const LinePattern& pattern, int of, const HomeRange& range) : row(of), px_per_line(1.0 / pattern.per_pixel) {
        const std::uint64_t row_and_axis = 2 * static_cast<std::uint64_t>(of) + (pattern.axis == DriftAxis::X ? 0 : 1);
        const std::uint64_t hash = mixed(row_and_axis ^ (static_cast<std::uint64_t>(pattern.set) << 32U));
        phase = unit_interval(static_cast<std::uint32_t>(hash >> 32U));
        seed = static_cast<std::uint32_t>(hash);
        next = static_cast<int>(std::ceil(range.from_px * pattern.per_pixel - phase));
        end = static_cast<int>(std::ceil(range.to_px * pattern.per_pixel - phase));
    }
    [[nodiscard]] DriftingLine line(int k) const {
        const auto number = static_cast<std::uint32_t>(k);
        const std::uint32_t across = owen_scrambled(sobol(number, 0), seed);
        return {row, (k + phase) * px_per_line, unit_interval(across), number, seed};
    }
};

}  // namespace

double DriftingLine::phase() const { return unit_interval(owen_scrambled(sobol(number, 1), ~seed)); }

std::vector<DriftingLine> lines_of(const LinePattern& pattern, const HomeRange& range) {
    std::vector<DriftingLine> lines;
    for (int first = range.first_row; first < range.end_row; first += kGroupRows) {
        std::vector<Row> rows;
        for (int row = first; row < std::min(first + kGroupRows, range.end_row); ++row)
            rows.emplace_back(pattern, row, range);
        std::size_t count = lines.size();
        for (const Row& r : rows) count += static_cast<std::size_t>(std::max(r.end - r.next, 0));
        lines.reserve(count);
        while (std::ranges::any_of(rows, [](const Row& r) { return r.next < r.end; })) {
            for (Row& r : rows) {
                for (int i = 0; i < kGroupHomes && r.next < r.end; ++i) lines.push_back(r.line(r.next++));
            }
        }
    }
    return lines;
}

ImageSample sample_of(const LinePattern& pattern, const DriftingLine& line, double shift_px) {
    const double along = line.home_px - shift_px;
    const double across = line.row + line.across_px;
    if (pattern.axis == DriftAxis::X) return {pattern.size.film_x(along), pattern.size.film_y(across), 0.0};
    return {pattern.size.film_x(across), pattern.size.film_y(along), 0.0};
}

}  // namespace overfly
