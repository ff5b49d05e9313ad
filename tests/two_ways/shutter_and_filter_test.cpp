#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "two_ways/frame_laws.h"

namespace overfly {
namespace {

using namespace testing;
using Shape = ShutterCurve::Shape;

constexpr PictureSize kWhole = {160, 90};
constexpr PictureSize kMiddle = {96, 54};  // of a picture of kWhole, where the border is not the matter
constexpr TimeRange kExposure = half_a_frame(1.0);
constexpr FilterKind kKinds[] = {FilterKind::Tent, FilterKind::BlackmanHarris, FilterKind::Mitchell};

class ShutterAndFilter : public ::testing::Test {
  protected:
    [[nodiscard]] static FrameMaker with(FrameMaker make, double drift_px, const ShutterCurve& curve,
                                         FilterKind filter) {
        make.drift_px = drift_px;
        make.shot.shutter.curve = curve;
        make.shot.image.filter = filter;
        return make;
    }
    [[nodiscard]] FrameMaker maker(double drift_px, const ShutterCurve& curve,
                                   FilterKind filter = FilterKind::Box) const {
        return with(middle_, drift_px, curve, filter);
    }
    [[nodiscard]] FrameMaker of_whole(double drift_px, FilterKind filter = FilterKind::Box,
                                      PictureSize size = kWhole) const {
        FrameMaker make = with(whole_, drift_px, {}, filter);
        make.size = size;
        return make;
    }

  private:
    SampleFlight flight_{diving_flight()};
    Sight sight_ = flight_.sight(kWhole);
    Sight sight_of_middle_ = flight_.sight_of_middle(kMiddle, kMiddle.width / 160.0);
    FrameMaker whole_{flight_.stage, sight_, kWhole, kExposure};
    FrameMaker middle_{flight_.stage,       sight_of_middle_, kMiddle,     kExposure, {},
                       FrameMaker::kNobody, whole_.day,       whole_.light};  // the ground is lit once
};

void expect_covered(const Frame& frame) {
    for (const auto& pixel : frame.rgba) ASSERT_NEAR(pixel[3], 1.0F, 2e-5F);
}

double largest_difference(const Frame& a, const Frame& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(a.rgba[i][1] - b.rgba[i][1])));
    return largest;
}

Frame weighed_sum(const std::vector<Frame>& frames, const std::vector<double>& weights) {
    Frame sum = frames.front();
    for (std::size_t i = 0; i < sum.rgba.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            double value = 0.0;
            for (std::size_t k = 0; k < frames.size(); ++k)
                value += weights[k] * static_cast<double>(frames[k].rgba[i][c]);
            sum.rgba[i][c] = static_cast<float>(value);
        }
    }
    return sum;
}

// The same lines at rest, in 48 short exposures that each count for what the shutter lets through meanwhile.
TEST_F(ShutterAndFilter, AShutterWeighsTheExposure) {
    constexpr int kParts = 48;
    std::vector<TimeRange> parts;
    const auto time_at = [](int k) { return kExposure.begin_s + kExposure.duration_s() * k / kParts; };
    for (int k = 0; k < kParts; ++k) parts.push_back({time_at(k), time_at(k + 1)});
    const std::vector<Frame> frames = maker(0.0, {}).expose_some(TracerKind::Interval, 1, 1, parts, parts);
    for (const ShutterCurve& curve : {ShutterCurve{Shape::Trapezoid}, {Shape::Smooth}, {Shape::Smooth, 0.5}}) {
        const Exposure exposure = {kExposure, curve};
        std::vector<double> weights;
        for (const TimeRange& part : parts) weights.push_back(exposure.share_of(part));
        const Frame expected = weighed_sum(frames, weights);
        const Frame box = weighed_sum(frames, std::vector<double>(kParts, 1.0 / kParts));
        const double apart = root_mean_square(box, expected);
        for (const TracerKind kind : {TracerKind::Interval, TracerKind::Kinetic}) {
            const Frame frame = maker(0.0, curve).expose(kind, 1, 1);
            expect_covered(frame);
            const double error = root_mean_square(frame, expected);
            std::cout << "RMS from short exposures " << error << ", a box is " << apart << " away\n";
            EXPECT_LT(error, 1e-3);
            EXPECT_GT(apart, 5.0 * error);
        }
    }
}

// Samples are placed where as much light has come through.
TEST_F(ShutterAndFilter, AllTracersSeeTheSameThroughEveryShutter) {
    for (const Shape shape : {Shape::Trapezoid, Shape::Smooth}) {
        const FrameMaker make = maker(8.0, {shape});
        const Frame reference = make.by_samples(1024);
        expect_covered(reference);
        const Frame drifting = make.by_kinetic_lines(4);
        expect_covered(drifting);
        const Frame box = maker(8.0, {}).by_kinetic_lines(4);
        const double error = root_mean_square(drifting, reference);
        std::cout << "RMSE of 4 drifting lines " << error << ", through a box " << root_mean_square(box, reference)
                  << "\n";
        EXPECT_LT(error, 0.005);
        EXPECT_LT(error, 0.7 * root_mean_square(box, reference));
    }
}

TimeRange whole_frames(int first, int count) { return {1.0 + first / 24.0, 1.0 + (first + count) / 24.0}; }

// Adjacent frames at 360 degrees are the frame of twice the exposure: for lines at rest the same lines, so that only
// the pieces differ in which light is followed.
TEST_F(ShutterAndFilter, AdjacentWholeFramesAverageToTheFrameOfTwiceTheExposure) {
    const std::vector<TimeRange> single = {whole_frames(0, 1), whole_frames(1, 1)}, both = {whole_frames(0, 2)};
    for (const TracerKind kind : {TracerKind::Interval, TracerKind::Kinetic}) {
        const FrameMaker make = maker(0.0, {});
        const Frame mean = weighed_sum(make.expose_some(kind, 2, 1, single, single), {0.5, 0.5});
        const Frame twice = make.expose_some(kind, 2, 1, both, both).front();
        std::cout << "at rest: RMS " << root_mean_square(mean, twice) << ", at most " << largest_difference(mean, twice)
                  << "\n";
        EXPECT_LT(root_mean_square(mean, twice), 5e-4);
        EXPECT_LT(largest_difference(mean, twice), 0.02);
    }
    // Lines that drift are others; both pictures are as near to the truth as each other.
    const FrameMaker make = of_whole(8.0);
    const Frame mean = weighed_sum(make.expose_some(TracerKind::Kinetic, 4, 1, single, single), {0.5, 0.5});
    const Frame twice = make.expose_some(TracerKind::Kinetic, 4, 1, both, both).front();
    const Frame reference = make.expose_some(TracerKind::Discrete, 1, 1024, both, both).front();
    const double error = root_mean_square(twice, reference), error_of_mean = root_mean_square(mean, reference);
    const double apart = root_mean_square(mean, twice);
    std::cout << "drifting: RMSE " << error << " and " << error_of_mean << ", apart " << apart << "\n";
    EXPECT_LT(error, 0.006);
    EXPECT_LT(error_of_mean, 0.003);
    EXPECT_LT(apart, error + error_of_mean);
}

// The filter's weights over the pixels of a picture that is so many times finer.
Frame filtered(const Frame& fine, int times, const PixelFilter& filter) {
    Frame out;
    out.width = fine.width / times;
    out.height = fine.height / times;
    out.rgba.assign(static_cast<std::size_t>(out.width * out.height), {});
    const auto weight = [&](int at, int pixel) {
        const double begin_px = static_cast<double>(at) / times - (pixel + 0.5);
        return filter.until(begin_px + 1.0 / times) - filter.until(begin_px);
    };
    const int reach = static_cast<int>(std::ceil(filter.margin_px())) * times;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            std::array<double, 4> sum{};
            for (int v = std::max(0, y * times - reach); v < std::min(fine.height, (y + 1) * times + reach); ++v) {
                for (int u = std::max(0, x * times - reach); u < std::min(fine.width, (x + 1) * times + reach); ++u) {
                    const double w = weight(u, x) * weight(v, y);
                    const auto& pixel = fine.rgba[fine.index(u, v)];
                    for (std::size_t c = 0; c < 4; ++c) sum[c] += w * static_cast<double>(pixel[c]);
                }
            }
            for (std::size_t c = 0; c < 4; ++c) out.rgba[out.index(x, y)][c] = static_cast<float>(sum[c]);
        }
    }
    return out;
}

// But for the pixels along the border.
double root_mean_square_inside(const Frame& a, const Frame& b) {
    constexpr int kBorder = 2;
    return root_mean_square(a, b, [&](int x, int y) {
        return x >= kBorder && y >= kBorder && x < a.width - kBorder && y < a.height - kBorder;
    });
}

// Bands with sharp edges, six times as fine and summed up by the filter.
TEST_F(ShutterAndFilter, EveryFilterIsAFinePictureSummedUp) {
    constexpr int kTimes = 6;
    constexpr PictureSize kSmall = {96, 54};
    const Frame fine =
        of_whole(8.0, FilterKind::Box, {kTimes * kSmall.width, kTimes * kSmall.height}).by_kinetic_lines(2);
    const Frame box = of_whole(8.0, FilterKind::Box, kSmall).by_kinetic_lines(8);
    for (const FilterKind kind : kKinds) {
        const Frame expected = filtered(fine, kTimes, PixelFilter(kind, usual_width_px(kind)));
        const FrameMaker drifting = of_whole(8.0, kind, kSmall), at_rest = of_whole(0.0, kind, kSmall);
        const double apart = root_mean_square_inside(box, expected);
        for (const Frame& frame : {drifting.by_kinetic_lines(8), at_rest.by_lines(64), at_rest.by_samples(256)}) {
            expect_covered(frame);
            const double error = root_mean_square_inside(frame, expected);
            std::cout << "filter " << static_cast<int>(kind) << ": RMSE " << error << ", a box is " << apart
                      << " away\n";
            EXPECT_LT(error, 0.01);
            EXPECT_LT(error, 0.6 * apart);
        }
    }
}

// Pixels at the border see beyond it. With 1,024 samples the errors are a quarter less, and their ratio is the same.
TEST_F(ShutterAndFilter, ABorderIsAsGoodAsTheMiddle) {
    for (const FilterKind kind : kKinds) {
        const FrameMaker make = of_whole(8.0, kind);
        const Frame reference = make.by_samples(512), frame = make.by_kinetic_lines(4);
        const auto is_border = [](int x, int y) {
            return x == 0 || y == 0 || x == kWhole.width - 1 || y == kWhole.height - 1;
        };
        const double at_border = root_mean_square(frame, reference, is_border);
        const double inside = root_mean_square_inside(frame, reference);
        std::cout << "RMSE at the border " << at_border << ", inside " << inside << "\n";
        EXPECT_LT(at_border, 1.5 * inside);
    }
}

// A cut exposure, or an error to be reached, weighs all the same.
TEST_F(ShutterAndFilter, CoverWhateverIsAskedFor) {
    for (const FilterKind kind : kKinds) {
        for (const double drift_px : {0.0, 1.0, 8.0}) {
            for (const int lines : {1, 3})
                expect_covered(maker(drift_px, {Shape::Smooth}, kind).by_kinetic_lines(lines));
        }
        FrameMaker make = maker(8.0, {Shape::Trapezoid}, kind);
        make.error = 0.01;
        expect_covered(make.by_kinetic_lines(1));
        make.error = 0.0;
        make.exposure = {1.0, 1.0};
        expect_covered(make.by_kinetic_lines(2));
        // Over the joint of two pieces.
        make.exposure = {7.0 / 6.0 - 0.004, 7.0 / 6.0 + 0.007};
        expect_covered(make.by_kinetic_lines(2));
        expect_covered(make.expose(TracerKind::Hybrid, 2, 8));
    }
}

TEST_F(ShutterAndFilter, MakeTheSamePixelsForAnyNumberOfThreads) {
    expect_the_same_for_any_number_of_threads(
        [&] { return maker(8.0, {Shape::Smooth}, FilterKind::Mitchell).by_kinetic_lines(2); });
}

TEST_F(ShutterAndFilter, MakeAFrameTheSameWhicheverOthersAreAskedFor) {
    expect_the_same_whichever_frames_are_asked_for(
        1.0, [&](const std::vector<TimeRange>& asked, const std::vector<TimeRange>& all) {
            return maker(8.0, {Shape::Trapezoid}, FilterKind::Tent).expose_some(TracerKind::Kinetic, 2, 1, asked, all);
        });
}

// A ramp of speeds: no two are equally long, and one is so short that lines would drift over all of the picture.
TEST_F(ShutterAndFilter, ExposuresOfAllLengthsAreAsGood) {
    const std::vector<TimeRange> all = {{1.0, 1.02}, {1.03, 1.04}, {1.05, 1.0504}, {1.06, 1.06001}};
    const FrameMaker make = maker(8.0, {});
    const std::vector<Frame> frames = make.expose_some(TracerKind::Kinetic, 4, 1, all, all);
    const std::vector<Frame> references = make.expose_some(TracerKind::Discrete, 1, 1024, all, all);
    for (std::size_t k = 0; k < all.size(); ++k) {
        expect_covered(frames[k]);
        const double error = root_mean_square(frames[k], references[k]);
        std::cout << "an exposure of " << all[k].duration_s() << " s: RMSE " << error << "\n";
        EXPECT_LT(error, 0.006);
        EXPECT_TRUE(make.expose_some(TracerKind::Kinetic, 4, 1, {all[k]}, all).front() == frames[k]);
    }
}

}  // namespace
}  // namespace overfly
