#include "shot/line_deposits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "film/integrate.h"
#include "shot/glider_shot.h"

namespace overfly {
namespace {

using namespace testing;

// A film of one row for the pixels that one line passes.
constexpr int kPixels = 4;
constexpr double kFirstEnd = 0.1, kPerPixel = 0.3;
constexpr PixelRun kRun = {.count = kPixels, .first_end = kFirstEnd, .v_per_pixel = kPerPixel};

// What a line sees for a while.
struct SeenRun {
    SceneShader::Sighting sighting;
    TimeRange when;

    [[nodiscard]] TimeRange in_pixel(int i) const {
        const auto time_at = [&](double v) { return when.begin_s + v * when.duration_s(); };
        return {time_at(begin_of(i)), time_at(begin_of(i + 1))};
    }
    static double begin_of(int pixel) { return std::clamp(kFirstEnd + (pixel - 1) * kPerPixel, 0.0, 1.0); }
};

std::vector<SeenRun> runs_of(const std::vector<ImageSample>& lines, const SurfaceSegmentLists& lists, TimeRange when) {
    std::vector<SeenRun> runs;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for_each_stretch(lists.of(i), when, [&](const SurfaceSegment* seen, TimeRange stretch) {
            runs.push_back({{lines[i].x, lines[i].y, seen, lists.reflected}, stretch});
        });
    }
    return runs;
}

// All that lines through the picture see in a tenth of a second, which is long for an exposure.
struct GliderView {
    explicit GliderView(double pixel_error) : shot(pixel_error) {}

    GliderShot shot;
    SceneShader shader = shot.shader();
    const MotionPiece& piece = shot.piece(0.5);
    std::vector<ImageSample> lines = lines_through_all_pixels();
    SurfaceSegmentLists lists = shot.traced(lines, piece);
    std::vector<SeenRun> runs = runs_of(lines, lists, {piece.when.begin_s, piece.when.begin_s + 0.1});

    // As one film after another; those that aren't smooth stay dark.
    [[nodiscard]] std::vector<Frame> deposited() const {
        std::vector<FilmFrame> films(runs.size(), FilmFrame(kPixels, 1));
        std::vector<FilmFrame*> to;
        for (FilmFrame& film : films) to.push_back(&film);
        LineDeposits deposits(shader, piece, to, 1);
        for (std::uint32_t i = 0; i < runs.size(); ++i) {
            PixelRun run = kRun;
            run.film = i;
            if (runs[i].sighting.is_of_ground()) deposits.add_ground(runs[i].sighting, runs[i].when, run);
            if (runs[i].sighting.seen == nullptr) deposits.add_sky(runs[i].sighting, runs[i].when, run);
        }
        deposits.flush();
        std::vector<Frame> frames;
        for (FilmFrame& film : films) frames.push_back(std::move(film).develop().frame);
        return frames;
    }
};

// Green light, the mean of many looks.
double looked_at_often(const GliderView& seen, const SeenRun& run, TimeRange when) {
    constexpr int kLooks = 40;
    double sum = 0.0;
    for (int k = 0; k < kLooks; ++k) {
        const double time_s = when.begin_s + when.duration_s() * (k + 0.5) / kLooks;
        sum += static_cast<double>(seen.shader.radiance(seen.piece, {run.sighting, time_s}).colour.g);
    }
    return sum / kLooks;
}

void expect_the_mean_of_many_looks(double pixel_error) {
    const GliderView seen(pixel_error);
    const std::vector<Frame> frames = seen.deposited();
    double squares = 0.0, largest = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < frames.size(); i += 7) {
        const SeenRun& run = seen.runs[i];
        if (run.sighting.seen != nullptr && !run.sighting.is_of_ground()) continue;
        if (frames[i].rgba[1][3] == 0.0F) continue;
        for (int px = 0; px < kPixels; ++px) {
            const double share = SeenRun::begin_of(px + 1) - SeenRun::begin_of(px);
            const auto& [r, g, b, alpha] = frames[i].rgba[static_cast<std::size_t>(px)];
            EXPECT_NEAR(alpha, share, 1e-5);
            const double error = static_cast<double>(g) / share - looked_at_often(seen, run, run.in_pixel(px));
            squares += error * error;
            largest = std::max(largest, std::abs(error));
            ++count;
        }
    }
    const double rms = std::sqrt(squares / count);
    std::cout << count << " pixels of runs: RMS " << rms << ", at most " << largest << "\n";
    EXPECT_GT(count, 1000);
    EXPECT_LT(rms, 2e-4);
    EXPECT_LT(largest, 0.005);
}

TEST(LineDeposits, AreTheMeanOfManyLooksOnTheFullMesh) { expect_the_mean_of_many_looks(0.0); }
TEST(LineDeposits, AreTheMeanOfManyLooksOnFewTriangles) { expect_the_mean_of_many_looks(0.5); }

// Near the horizon the air thickens so quickly that nodes at fixed distances miss more than half a thousandth of it.
TEST(LineDeposits, FollowTheSkyDownToTheHorizon) {
    const GliderView seen(0.5);
    double largest = 0.0;
    int count = 0;
    for (const ImageSample& line : seen.lines) {
        const SeenRun run{{line.x, line.y, nullptr, seen.lists.reflected}, seen.piece.when};
        FilmFrame film(kPixels, 1);
        FilmFrame* const to = &film;
        LineDeposits deposits(seen.shader, seen.piece, {&to, 1}, 1);
        deposits.add_sky(run.sighting, run.when, kRun);
        deposits.flush();
        if (!deposits.left_over().empty()) continue;
        const Frame frame = std::move(film).develop().frame;
        if (frame.rgba[0][3] == 0.0F) continue;  // looks down at the round Earth
        for (int px = 0; px < kPixels; ++px) {
            const double share = SeenRun::begin_of(px + 1) - SeenRun::begin_of(px);
            const double green = static_cast<double>(frame.rgba[static_cast<std::size_t>(px)][1]) / share;
            largest = std::max(largest, std::abs(green / looked_at_often(seen, run, run.in_pixel(px)) - 1.0));
            ++count;
        }
    }
    std::cout << count << " pixels of sky: at most " << largest << " of their light\n";
    EXPECT_GT(count, 10'000);
    EXPECT_LT(largest, 3e-4);
}

TEST(LineDeposits, AreTheSameOnEveryVectorUnit) {
    const GliderView seen(0.5);
    const std::vector<Frame> best = seen.deposited();
    for_each_vector_unit([&](const char* name) { EXPECT_TRUE(seen.deposited() == best) << name; });
}

// The edge of the round Earth is left to those who look at each pixel.
TEST(LineDeposits, LeaveTheHorizonOver) {
    const GliderView seen(0.5);
    std::vector<SeenRun> runs;
    for (const ImageSample& line : seen.lines) runs.push_back({{line.x, line.y, nullptr, {}}, seen.piece.when});
    std::vector<FilmFrame> films(runs.size(), FilmFrame(kPixels, 1));
    std::vector<FilmFrame*> to;
    for (FilmFrame& film : films) to.push_back(&film);
    LineDeposits deposits(seen.shader, seen.piece, to, 1);
    for (std::uint32_t i = 0; i < runs.size(); ++i) {
        PixelRun run = kRun;
        run.film = i;
        deposits.add_sky(runs[i].sighting, runs[i].when, run);
    }
    deposits.flush();
    const std::span<const std::size_t> left = deposits.left_over();
    EXPECT_FALSE(left.empty());
    EXPECT_LT(left.size(), runs.size() / 2);
    const auto sees_earth = [&](const SeenRun& run, double time_s) {
        return seen.shader.describe(seen.piece, {run.sighting, time_s}).distance_m > 0.0;
    };
    std::size_t next = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const bool is_left = next < left.size() && left[next] == i;
        if (is_left) ++next;
        if (sees_earth(runs[i], runs[i].when.begin_s) != sees_earth(runs[i], runs[i].when.end_s)) {
            EXPECT_TRUE(is_left) << i;
        }
        const Frame frame = std::move(films[i]).develop().frame;
        EXPECT_NEAR(frame.rgba[1][3], is_left ? 0.0 : kPerPixel, 1e-5) << i;
    }
    EXPECT_EQ(next, left.size());
}

// A run's light is the same to the bit whichever others are looked at with it.
TEST(LineDeposits, OfTheSkyDoNotMindCompany) {
    const GliderView seen(0.5);
    const std::vector<Frame> together = seen.deposited();
    for (std::size_t i = 0; i < seen.runs.size(); i += 11) {
        const SeenRun& run = seen.runs[i];
        if (run.sighting.seen != nullptr) continue;
        FilmFrame film(kPixels, 1);
        FilmFrame* const to = &film;
        LineDeposits(seen.shader, seen.piece, {&to, 1}, 1).add_sky(run.sighting, run.when, kRun);
        EXPECT_TRUE(std::move(film).develop().frame == together[i]) << i;
    }
}

}  // namespace
}  // namespace overfly
