// The kinetic tracer beside discrete rays on a shot, one line or ray a pixel and frame, visibility alone, one thread.
// usage: overfly_kinetic_bench SHOT.yaml [KEY=VALUE...]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "config/read.h"
#include "flight/motion.h"
#include "shot/expose_piece.h"
#include "shot/flight_scene.h"
#include "shot/frame_plan.h"
#include "shot/pixel_tile.h"
#include "shot/prepare_scene.h"
#include "shot/processor_time.h"
#include "shot/stage.h"
#include "trace/film_distance.h"
#include "trace/kinetic.h"

namespace overfly {
namespace {

constexpr std::size_t kPlaces = 3;  // of the shot that are measured
constexpr std::size_t kInARow = 4;  // pieces in each
constexpr std::size_t kEveryTile = 8;
constexpr double kLongestPiece_s = 1.0 / 3.0;  // whatever the frame rate is

Motion motion_of(const ShotDocument& shot, const CameraPath& path, const Stage& stage) {
    MotionOptions options;
    options.bound_px = shot.motion_bound_px;
    options.width_px = shot.image.width;
    options.height_px = shot.image.height;
    options.longest_piece_s = kLongestPiece_s;
    return fit_motion(path, path.times(), stage.surroundings(), options);
}

// The same number of packets as the discrete tracer's, and nothing but packets: what Embree alone costs.
double embree_seconds(const RayScene& scene, const MotionPiece& piece, const std::vector<TileSamples>& tiles,
                      std::span<const TimeRange> exposures) {
    double seconds = 0.0;
    const Vector<Scene> reference = piece.reference - scene.float_centre();
    std::vector<RayPacket> packets;
    for (const TileSamples& tile : tiles) {
        packets.clear();
        for (const TimeRange& exposure : exposures) {
            for (std::size_t first = 0; first + RayPacket::kSize <= tile.samples.size(); first += RayPacket::kSize) {
                RayPacket& packet = packets.emplace_back();
                for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
                    const ImageSample& s = tile.samples[first + i];
                    const double u = piece.u_at(exposure.begin_s + s.phase * exposure.duration_s());
                    packet.aim(i, reference + piece.origin.at(u), piece.direction_at(u, s.x, s.y), true);
                }
            }
        }
        const double start_s = processor_seconds();
        for (RayPacket& packet : packets) scene.first_hits(packet);
        seconds += processor_seconds() - start_s;
    }
    return seconds;
}

struct Totals {
    int width_px = 0;
    long by_edge = 0;  // of those that differ, within a thousandth of a pixel of an edge
    double furthest_px = 0.0;
    double pixel_frames = 0.0;
    double discrete_s = 0.0, embree_s = 0.0, prepare_s = 0.0, kinetic_s = 0.0;
    long pairs = 0, same = 0;
    TraceCounters discrete, kinetic;
};

void count_same(const TriangleMesh& mesh, const MotionPiece& piece, const TileSamples& tile,
                const SegmentLists& instants, const SegmentLists& lists, Totals& totals) {
    for (std::size_t i = 0; i < lists.ends.size(); ++i) {
        std::size_t at = 0;
        const auto walked = lists.of(i);
        for (const VisibleSegment& instant : instants.of(i)) {
            while (at < walked.size() && walked[at].when.end_s < instant.when.begin_s) ++at;
            const bool any = at < walked.size() && walked[at].when.begin_s <= instant.when.begin_s;
            const TriangleId found = any ? walked[at].triangle : kNone;
            ++totals.pairs;
            if (found == instant.triangle) {
                ++totals.same;
                continue;
            }
            double pixels = std::numeric_limits<double>::infinity();
            for (const TriangleId t : {found, instant.triangle}) {
                if (t == kNone) continue;
                const double u = piece.u_at(instant.when.begin_s);
                const double film = film_distance_to_sides(mesh, t, piece, tile.samples[i], u);
                pixels = std::min(pixels, film * 0.5 * totals.width_px);
            }
            if (pixels <= 1e-3) ++totals.by_edge;
            totals.furthest_px = std::max(totals.furthest_px, pixels);
        }
    }
}

void time_piece(const Stage& stage, const MotionPiece& piece, std::span<const TimeRange> exposures,
                const std::vector<TileSamples>& tiles, const FilmBounds& picture, Totals& totals) {
    const DiscreteTracer discrete(stage.rays());
    const KineticTracer kinetic(stage.rays());
    double start_s = processor_seconds();
    const KineticPiece prepared = kinetic.prepare(piece, picture);
    totals.prepare_s += processor_seconds() - start_s;
    SegmentLists instants;
    SegmentLists lists;
    for (const TileSamples& tile : tiles) {
        const std::vector<ImageSample>& samples = tile.samples;
        instants.clear();
        lists.clear();
        start_s = processor_seconds();
        discrete.trace(piece, samples, exposures, instants, totals.discrete);
        const double discrete_end_s = processor_seconds();
        kinetic.trace(prepared, samples, exposures, lists, totals.kinetic);
        const double kinetic_end_s = processor_seconds();
        totals.discrete_s += discrete_end_s - start_s;
        totals.kinetic_s += kinetic_end_s - discrete_end_s;
        totals.pixel_frames += static_cast<double>(samples.size() * exposures.size());
        count_same(stage.mesh(), piece, tile, instants, lists, totals);
    }
    totals.embree_s += embree_seconds(stage.rays(), piece, tiles, exposures);
}

void print(const Totals& t) {
    const auto ns = [&](double seconds) { return 1e9 * seconds / t.pixel_frames; };
    const auto per = [&](std::uint64_t count) { return static_cast<double>(count) / t.pixel_frames; };
    // Only every so many tiles were traced, but the whole mesh was prepared.
    const double prepare_s = t.prepare_s / static_cast<double>(kEveryTile);
    std::printf("ns per pixel and frame: embree %.1f  discrete %.1f  kinetic %.1f  prepare %.1f\n", ns(t.embree_s),
                ns(t.discrete_s), ns(t.kinetic_s), ns(prepare_s));
    std::printf("per pixel and frame: crossings %.3f occlusions %.5f disocclusions %.5f lost %.2e segments %.3f\n",
                per(t.kinetic.crossings), per(t.kinetic.occlusions), per(t.kinetic.disocclusions), per(t.kinetic.lost),
                per(t.kinetic.segments));
    std::printf("same triangle: %.5f %% of %ld; of the other %ld at an edge %ld, furthest %.1e px\n",
                100.0 * static_cast<double>(t.same) / static_cast<double>(t.pairs), t.pairs, t.pairs - t.same,
                t.by_edge, t.furthest_px);
}

void run(const std::string& file, const std::vector<std::string>& assignments) {
    const ShotDocument shot = read_shot_document(file, assignments);
    Stage stage(prepare_terrain(shot.terrain, default_cache_folder()), middle_of(shot.flight));
    const CameraPath path = make_path(shot.flight, stage);
    const std::vector<PlannedFrame> frames = plan_frames(shot, path.times());
    const Motion motion = motion_of(shot, path, stage);
    fit_mesh_to_flight(stage, shot, path, default_cache_folder());
    const PictureSize size = {shot.image.width, shot.image.height};
    const std::vector<PixelTile> all = tiles_of(size);
    std::vector<TileSamples> tiles;
    for (std::size_t i = 0; i < all.size(); i += kEveryTile) tiles.push_back(samples_of(all[i], size, 1));
    const FilmBounds picture = {-1.0, 1.0, size.film_y(0.0), size.film_y(size.height)};
    Totals totals;
    totals.width_px = size.width;
    std::printf("%d x %d, %zu triangles, %zu frames in %zu pieces\n", size.width, size.height,
                stage.mesh().triangles.size(), frames.size(), motion.pieces.size());
    for (std::size_t k = 0; k < kPlaces; ++k) {
        const std::size_t first = (2 * k + 1) * motion.pieces.size() / (2 * kPlaces);
        for (std::size_t i = first; i < std::min(first + kInARow, motion.pieces.size()); ++i) {
            const MotionPiece& piece = motion.pieces[i];
            std::vector<TimeRange> exposures;
            for (const PlannedFrame& f : frames) {
                if (is_exposed_in(f, piece)) exposures.push_back(intersection(f.exposure, piece.when));
            }
            time_piece(stage, piece, exposures, tiles, picture, totals);
        }
    }
    print(totals);
}

}  // namespace
}  // namespace overfly

int main(int argc, char** argv) {
    try {
        if (argc < 2) throw std::runtime_error("usage: overfly_kinetic_bench SHOT.yaml [KEY=VALUE...]");
        overfly::run(argv[1], {argv + 2, argv + argc});
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return 0;
}
