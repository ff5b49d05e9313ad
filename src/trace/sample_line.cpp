#include "trace/sample_line.h"

#include <algorithm>

#include "core/polynomial_roots.h"
#include "trace/edge_function.h"
#include "trace/nearest_records.h"
#include "trace/plane_depth.h"

namespace overfly {
namespace {

constexpr std::size_t kCell = 0;

// As in IntervalTracer: a gap of rounding.
constexpr double kGap = 1e-12;  // of the piece

// By axis: those of the film point's line, x * right + y * down + view.
std::array<Bernstein<4>, 3> combined(const ImageSample& sample, const QuarticVectors& right, const QuarticVectors& down,
                                     const QuarticVectors& view) {
    std::array<Bernstein<4>, 3> line{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t j = 0; j < 5; ++j) {
            line[axis][j] = (sample.x * right[axis][j][kCell] + sample.y * down[axis][j][kCell]) + view[axis][j][kCell];
        }
    }
    return line;
}

// Whether the line may be on one hand of all sides at some time: no side has it on the left all through while another
// has it on the right.
bool perhaps_inside(const std::array<Bernstein<4>, 3>& sides) {
    bool any_front = true;
    bool any_back = true;
    for (const Bernstein<4>& side : sides) {
        const auto [least, most] = std::minmax_element(side.begin(), side.end());
        any_front = any_front && *most >= 0.0;
        any_back = any_back && *least <= 0.0;
    }
    return any_front || any_back;
}

}  // namespace

SampleLine::SampleLine(const TriangleMesh& mesh, const MotionPiece& piece, const ImageSample& sample, TimeRange when)
    : mesh_(&mesh), sample_(sample), cells_(piece, std::span(&when, 1)) {
    direction_ = combined(sample, cells_.right.direction, cells_.down.direction, cells_.view.direction);
    moment_ = combined(sample, cells_.right.moment, cells_.down.moment, cells_.view.moment);
}

std::array<Bernstein<4>, 3> SampleLine::sides(TriangleId triangle) const {
    const std::array<EdgeFunction, 3> edges = edge_functions(*mesh_, triangle, cells_.piece->reference);
    std::array<Bernstein<4>, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 5; ++j) {
            sides[k][j] = edges[k].at({direction_[0][j], direction_[1][j], direction_[2][j]},
                                      {moment_[0][j], moment_[1][j], moment_[2][j]});
        }
    }
    return sides;
}

bool SampleLine::add_records(TriangleId triangle, std::vector<CellRecord>& records) const {
    LineInCell line;
    line.side = sides(triangle);
    if (!perhaps_inside(line.side)) return false;
    const PlaneDepth depth(*mesh_, triangle, *cells_.piece, sample_.x, sample_.y);
    line.depth_numerator = depth.numerator_in(cells_, kCell);
    bool hit = false;
    for (const Stretch& s : inside_stretches(line)) {
        const double s0 = depth.at(cells_.piece_u(kCell, s.begin));
        const double s1 = depth.at(cells_.piece_u(kCell, 0.5 * (s.begin + s.end)));
        const double s2 = depth.at(cells_.piece_u(kCell, s.end));
        if (!(s1 > 0.0)) continue;
        const double low = std::min({s0, s1, s2});
        const double high = std::max({s0, s1, s2});
        const double margin = 0.5 * (high - low) + 1e-9 * high;
        records.push_back({s.begin, s.end, low - margin, high + margin, triangle});
        hit = true;
    }
    return hit;
}

std::vector<CellRecord> SampleLine::nearest(std::vector<CellRecord> records) const {
    const StaticBvh none;
    const SweptRays rays(*mesh_, none, cells_, std::span(&sample_, 1));
    std::vector<CellRecord> scratch;
    return nearest_records(rays, kCell, records, scratch);
}

TimeRange SampleLine::when(const CellRecord& record) const {
    return {cells_.time_s(kCell, record.begin), cells_.time_s(kCell, record.end)};
}

void SampleLine::append_segments(std::span<const CellRecord> nearest, std::vector<VisibleSegment>& segments) const {
    const std::size_t first = segments.size();
    double last = 0.0;  // end of the latest record, in the cell's u
    for (const CellRecord& record : nearest) {
        const double gap = (record.begin - last) * (cells_.to[kCell] - cells_.from[kCell]);
        const bool touches = segments.size() > first && gap <= kGap;
        TimeRange seen = when(record);
        if (touches) seen.begin_s = segments.back().when.end_s;
        if (touches && segments.back().triangle == record.triangle) {
            segments.back().when.end_s = seen.end_s;
        } else if (seen.duration_s() > 0.0) {
            segments.push_back({record.triangle, seen});
        } else {
            continue;  // shorter than time can tell
        }
        last = record.end;
    }
}

std::vector<SampleLine::Crossing> SampleLine::crossings(TriangleId triangle) const {
    const std::array<Bernstein<4>, 3> side = sides(triangle);
    std::vector<Crossing> out;
    for (std::size_t k = 0; k < 3; ++k) {
        for (const double u : sign_change_roots<4>(side[k])) {
            const double next = value_at<4>(side[(k + 1) % 3], u);
            const double last = value_at<4>(side[(k + 2) % 3], u);
            out.push_back({cells_.time_s(kCell, u), (next >= 0.0) == (last >= 0.0)});
        }
    }
    return out;
}

}  // namespace overfly
