#include "film/integrate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace overfly {
namespace {

struct Seen {
    int what = 0;
    TimeRange when;
};
constexpr int kSky = -1;

struct Deposit {
    int what;
    double time_s, share;
};

std::vector<Deposit> integrated(const std::vector<Seen>& segments, TimeRange window, const Exposure& exposure) {
    std::vector<Deposit> deposits;
    const auto deposit = [&](const Seen* s, double time_s, double share) {
        deposits.push_back({s ? s->what : kSky, time_s, share});
    };
    const auto with_stretch = [&](const Seen* s, TimeRange stretch, double all) {
        for_each_look(exposure, stretch, all, [&](double time_s, double share) { deposit(s, time_s, share); });
    };
    integrate(std::span(segments), window, exposure, with_stretch,
              [&](const Seen* s, double time_s) { deposit(s, time_s, 1.0); });
    return deposits;
}

std::map<int, double> share_of_each(const std::vector<Deposit>& deposits) {
    std::map<int, double> shares;
    for (const Deposit& d : deposits) shares[d.what] += d.share;
    return shares;
}

double sum(const std::vector<Deposit>& deposits) {
    double all = 0.0;
    for (const Deposit& d : deposits) all += d.share;
    return all;
}

// Segments in order and without overlap, some touching and some with sky between them.
std::vector<Seen> random_segments(std::mt19937& random, TimeRange window) {
    std::uniform_real_distribution<double> in_window(window.begin_s, window.end_s);
    std::vector<double> times(2 * (random() % 8));
    std::ranges::generate(times, [&] { return in_window(random); });
    std::ranges::sort(times);
    std::vector<Seen> segments;
    for (std::size_t i = 0; i + 1 < times.size(); i += random() % 2 + 1) {
        segments.push_back({static_cast<int>(i), {times[i], times[i + 1]}});
    }
    return segments;
}

constexpr double kRounding = 1e-12;  // of some dozens of sums of numbers up to 1

TEST(Integrate, SharesAreThePartsOfTheExposure) {
    const auto shares = share_of_each(integrated({{1, {0.1, 0.3}}, {2, {0.3, 0.35}}}, {0.0, 1.0}, {{0.0, 0.5}}));
    EXPECT_NEAR(shares.at(1), 0.4, kRounding);
    EXPECT_NEAR(shares.at(2), 0.1, kRounding);
    EXPECT_NEAR(shares.at(kSky), 0.5, kRounding);
}

TEST(Integrate, AnEmptyLineSeesTheSkyAllTheTime) {
    EXPECT_NEAR(share_of_each(integrated({}, {0.0, 1.0}, {{0.2, 0.4}})).at(kSky), 1.0, kRounding);
}

TEST(Integrate, SharesAddUpToOneWithinOneWindow) {
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const TimeRange window{-3.0, 5.0};
        const auto segments = random_segments(random, window);
        std::uniform_real_distribution<double> begin(-3.0, 4.0), duration(1e-6, 1.0);
        const double begin_s = begin(random);
        EXPECT_NEAR(sum(integrated(segments, window, {{begin_s, begin_s + duration(random)}})), 1.0, kRounding) << i;
    }
}

// A frame's exposure may lie across pieces of the motion, each of which is integrated by itself.
TEST(Integrate, SharesAddUpToOneAcrossWindows) {
    std::mt19937 random(2);
    for (int i = 0; i < 2000; ++i) {
        const TimeRange exposure{0.3, 3.1};
        std::vector<double> joints = {0.0, 4.0};
        for (auto j = random() % 5; j > 0; --j)
            joints.push_back(std::uniform_real_distribution<double>(0.0, 4.0)(random));
        std::ranges::sort(joints);
        double all = 0.0;
        for (std::size_t j = 0; j + 1 < joints.size(); ++j) {
            const TimeRange window{joints[j], joints[j + 1]};
            all += sum(integrated(random_segments(random, window), window, {exposure}));
        }
        EXPECT_NEAR(all, 1.0, kRounding) << i;
    }
}

TEST(Integrate, CountsNothingOfSegmentsOutsideTheExposure) {
    const auto shares =
        share_of_each(integrated({{1, {0.0, 0.2}}, {2, {0.2, 0.8}}, {3, {0.8, 1.0}}}, {0.0, 1.0}, {{0.2, 0.8}}));
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_NEAR(shares.at(2), 1.0, kRounding);
}

TEST(Integrate, LooksAtEachStretchInsideOfIt) {
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        const TimeRange window{0.0, 1.0};
        const auto segments = random_segments(random, window);
        for (const Deposit& d : integrated(segments, window, {{0.1, 0.9}})) {
            EXPECT_GT(d.share, 0.0);
            EXPECT_GT(d.time_s, 0.1);
            EXPECT_LT(d.time_s, 0.9);
            const auto seen = std::ranges::find_if(segments, [&](const Seen& s) { return s.when.contains(d.time_s); });
            EXPECT_EQ(seen == segments.end() ? kSky : seen->what, d.what) << i;
        }
    }
}

// A Gauss rule of n points is exact for polynomials up to degree 2 n - 1.
TEST(Integrate, IsAGaussRuleOfAsManyPointsAsTheStretchIsLongFor) {
    const auto mean_of_power = [](double end_s, int power) {
        double mean = 0.0;
        for (const Deposit& d : integrated({{1, {0.0, end_s}}}, {0.0, 1.0}, {{0.0, 1.0}})) {
            if (d.what == 1) mean += d.share * std::pow(d.time_s, power);
        }
        return mean;
    };
    const auto exact = [](double end_s, int power) { return std::pow(end_s, power + 1) / (power + 1); };
    struct Rule {
        double end_s;
        int degree;
    };
    for (const Rule rule : {Rule{0.15, 1}, Rule{0.5, 3}, Rule{1.0, 5}}) {
        for (int power = 0; power <= rule.degree; ++power) {
            EXPECT_NEAR(mean_of_power(rule.end_s, power), exact(rule.end_s, power), kRounding)
                << "t^" << power << " to " << rule.end_s;
        }
        const int beyond = rule.degree + 1;
        EXPECT_GT(std::abs(mean_of_power(rule.end_s, beyond) - exact(rule.end_s, beyond)), 1e-6);
    }
}

// Shares and looks are by the light that comes through, whatever the shutter's shape: against thousands of samples.
TEST(Integrate, TheShutterWeighsStretches) {
    constexpr int kSamples = 20'000;
    for (const ShutterCurve::Shape shape : {ShutterCurve::Shape::Trapezoid, ShutterCurve::Shape::Smooth}) {
        const Exposure exposure = {{0.1, 0.9}, {shape, 0.3}};
        const std::vector<Seen> segments = {{1, {0.0, 0.2}}, {2, {0.25, 0.8}}, {3, {0.8, 1.0}}};
        std::map<int, double> shares, times;
        for (int k = 0; k < kSamples; ++k) {
            const double part = (k + 0.5) / kSamples, time_s = 0.1 + 0.8 * part;
            const auto seen = std::ranges::find_if(segments, [&](const Seen& s) { return s.when.contains(time_s); });
            const int what = seen == segments.end() ? kSky : seen->what;
            shares[what] += exposure.curve.openness(part) / kSamples;
            times[what] += time_s * exposure.curve.openness(part) / kSamples;
        }
        std::map<int, double> looked;
        const auto deposits = integrated(segments, {0.0, 1.0}, exposure);
        for (const Deposit& d : deposits) looked[d.what] += d.share * d.time_s;
        for (const auto& [what, share] : share_of_each(deposits)) {
            EXPECT_NEAR(share, shares.at(what), 1e-4);
            EXPECT_NEAR(looked.at(what) / share, times.at(what) / shares.at(what), 0.01);
        }
        EXPECT_NEAR(sum(deposits), 1.0, kRounding);
    }
}

TEST(Integrate, AnInstantCountsWhollyInOneOfTheWindowsThatMeetThere) {
    const std::vector<Seen> before = {{1, {0.0, 0.5}}}, after = {{2, {0.5, 1.0}}};
    const TimeRange instant{0.5, 0.5};
    EXPECT_TRUE(integrated(before, {0.0, 0.5}, {instant}).empty());
    const auto shares = share_of_each(integrated(after, {0.5, 1.0}, {instant}));
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_EQ(shares.at(2), 1.0);
}

TEST(Integrate, AnInstantBetweenSegmentsSeesTheSky) {
    const auto shares = share_of_each(integrated({{1, {0.0, 0.4}}, {2, {0.6, 1.0}}}, {0.0, 1.0}, {{0.5, 0.5}}));
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_EQ(shares.at(kSky), 1.0);
}

TEST(IntegrateInstants, EachInstantStandsForTheExposureItLiesIn) {
    const std::vector<Seen> instants = {{1, {0.1, 0.1}}, {2, {1.3, 1.3}}, {4, {3.5, 3.5}}};
    const std::vector<TimeRange> exposures = {{0.0, 0.5}, {1.0, 1.5}, {2.0, 2.5}, {3.0, 3.5}};
    std::map<int, std::size_t> exposure_of;
    integrate_instants(std::span(instants), std::span(exposures), [&](const Seen& s, std::size_t e, double time_s) {
        EXPECT_EQ(time_s, s.when.begin_s);
        exposure_of[s.what] = e;
    });
    EXPECT_EQ(exposure_of, (std::map<int, std::size_t>{{1, 0}, {2, 1}, {4, 3}}));
}

}  // namespace
}  // namespace overfly
