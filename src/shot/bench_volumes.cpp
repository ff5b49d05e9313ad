#include "shot/bench_volumes.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/stopwatch.h"
#include "trace/film_box.h"
#include "trace/inflated.h"

namespace overfly {
namespace {

// Enough of the picture for three digits: more than 30,000 lines of sight a piece at 960 x 540.
constexpr std::size_t kEveryTile = 16;

std::vector<ImageSample> some_samples(PictureSize size) {
    std::vector<ImageSample> out;
    const std::vector<PixelTile> tiles = tiles_of(size);
    for (std::size_t i = 0; i < tiles.size(); i += kEveryTile) {
        const TileSamples tile = samples_of(tiles[i], size, 1);
        out.insert(out.end(), tile.samples.begin(), tile.samples.end());
    }
    return out;
}

FilmBox hull(const FilmBox& a, const FilmBox& b) {
    FilmBox both = a;
    for (std::size_t k = 0; k < both.low.size(); ++k) {
        both.low[k] = std::min(a.low[k], b.low[k]);
        both.high[k] = std::max(a.high[k], b.high[k]);
    }
    return both;
}

// A piece cut into equal parts.
std::vector<TimeRange> parts_of(const MotionPiece& piece) {
    std::vector<TimeRange> parts;
    for (std::size_t k = 0; k < kVolumeParts; ++k) {
        const auto at = [&](std::size_t i) { return piece.time_at(static_cast<double>(i) / kVolumeParts); };
        parts.push_back({at(k), at(k + 1)});
    }
    return parts;
}

}  // namespace

VolumeComparison compare_volumes(const TriangleMesh& mesh, const IntervalTracer& swept,
                                 std::span<const MotionPiece> pieces, PictureSize size, const Progress& progress) {
    VolumeComparison result;
    const std::vector<ImageSample> samples = some_samples(size);
    SegmentLists of_inflated;
    SegmentLists of_swept;
    SegmentLists of_parts;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const MotionPiece& piece = pieces[k];
        if (progress) progress("comparing the volumes", static_cast<double>(k), static_cast<double>(pieces.size()));
        const Stopwatch watch;  // of all threads
        const InflatedTracer inflated(mesh, piece, {1.0, size.film_y(size.height)});
        result.inflated_build_s += watch.seconds() / static_cast<double>(pieces.size());
        const std::vector<TimeRange> parts = parts_of(piece);
        for (const ImageSample& sample : samples) {
            const std::span one(&sample, 1);
            of_inflated.clear();
            of_swept.clear();
            of_parts.clear();
            inflated.trace(one, of_inflated, result.inflated);
            swept.trace(piece, one, std::span(&piece.when, 1), of_swept, result.swept);
            swept.trace(piece, one, parts, of_parts, result.swept_in_parts);
            result.differing += of_inflated.segments == of_swept.segments ? 0 : 1;
        }
    }
    return result;
}

SwollenBoxes swollen_boxes(const TriangleMesh& mesh, std::span<const MotionPiece> pieces, PictureSize size) {
    const FilmReach picture = {1.0, size.film_y(size.height)};
    std::vector<std::optional<FilmBox>> boxes(mesh.triangles.size());
    for (const MotionPiece& piece : pieces) {
        const FilmBoxes of_piece(mesh, piece, picture);
        for (TriangleId t = 0; t < boxes.size(); ++t) {
            const auto box = of_piece.of(t);
            if (box) boxes[t] = boxes[t] ? hull(*boxes[t], *box) : *box;
        }
    }
    double area = 0.0;
    for (const auto& box : boxes) {
        if (box) area += (box->high[0] - box->low[0]) * (box->high[1] - box->low[1]);
    }
    const double lasting_s = pieces.back().when.end_s - pieces.front().when.begin_s;
    return {pieces.size(), lasting_s, area / (4.0 * picture.x * picture.y)};
}

}  // namespace overfly
