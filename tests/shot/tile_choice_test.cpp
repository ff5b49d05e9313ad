#include "shot/tile_choice.h"

#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/moving_scene.h"

namespace overfly {
namespace {

using testing::HandMotion;
using testing::MovingScene;

// Half a frame, and another one of the same piece.
const std::vector<TimeRange> kExposures = {{0.1, 0.3}, {0.6, 0.8}};
constexpr PictureSize kSize = {64, 64};

std::vector<testing::Thing> ground() {
    std::vector<testing::Thing> things;
    things.push_back({testing::heightfield(120, 120, 40.0, testing::rough_ground)});
    return things;
}

// Rough ground, and a tile of the picture that looks at it from one place.
class TileChoice : public ::testing::Test {
  protected:
    [[nodiscard]] static Sight sight_of(const HandMotion& motion) {
        Motion one;
        one.pieces = {motion.piece()};
        Sight sight;
        sight.motions = {one};
        return sight;
    }
    [[nodiscard]] bool takes_lines(const HandMotion& motion, TraceCounters& counters, int lines = 4,
                                   int samples = 64) const {
        const Sight sight = sight_of(motion);
        const SightTracer continuous(followed_.surfaces(), sight), discrete(sampled_.surfaces(), sight);
        const PreparedSight prepared = continuous.prepare({0.0, 1.0}, kSize.film_bounds());
        const TileSamples tile = samples_of({24, 24, 40, 40}, kSize, lines);
        return lines_are_cheaper({&continuous, lines, &discrete, samples}, prepared, tile.samples, kExposures,
                                 counters);
    }
    [[nodiscard]] bool takes_lines(const HandMotion& motion) const {
        TraceCounters counters;
        return takes_lines(motion, counters);
    }

    const MovingScene followed_{ground()};
    const MovingScene sampled_{ground(), true};
};

// Forty metres to a triangle, two kilometres away and more: a hover sees one at a time.
const HandMotion kHover = {{0, -2000, 1500}, {}, 0.1, -0.5, 0.0};
const HandMotion kFastPan = {{0, -2000, 1500}, {}, 0.1, -0.5, 1.5};
const HandMotion kPanAcrossTheSky = {{0, -2000, 1500}, {}, 0.1, 0.6, 1.5};

TEST_F(TileChoice, FollowsLinesWhereLittleChanges) { EXPECT_TRUE(takes_lines(kHover)); }

TEST_F(TileChoice, FollowsLinesThroughTheSky) { EXPECT_TRUE(takes_lines(kPanAcrossTheSky)); }

TEST_F(TileChoice, SamplesWhereTrianglesRushPast) { EXPECT_FALSE(takes_lines(kFastPan)); }

TEST_F(TileChoice, ChoosesTheSameEachTimeByTheSameWork) {
    TraceCounters first, second;
    EXPECT_EQ(takes_lines(kFastPan, first), takes_lines(kFastPan, second));
    EXPECT_GT(first.triangle_tests, 0U);
    EXPECT_EQ(first.triangle_tests, second.triangle_tests);
    EXPECT_EQ(first.box_tests, second.box_tests);
    EXPECT_EQ(first.segments, second.segments);
}

// Whoever asks for more samples than lines can be worth gets lines, and the other way round.
TEST_F(TileChoice, GoesByTheNumbersThatTheUserTakesForEquallyGood) {
    TraceCounters counters;
    EXPECT_TRUE(takes_lines(kFastPan, counters, 1, 65536));
    EXPECT_FALSE(takes_lines(kHover, counters, 16, 1));
}

}  // namespace
}  // namespace overfly
