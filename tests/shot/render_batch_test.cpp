#include "shot/render_batch.h"

#include <fstream>

#include <gtest/gtest.h>

#include "io/temporary_folder.h"

namespace overfly {
namespace {

// A shot of two tiny frames over a hill of a few posts.
std::filesystem::path write_shot(const TemporaryFolder& folder, const std::string& name) {
    std::ofstream(folder / "hill.asc") << "ncols 4\nnrows 3\nxllcorner 450000\nyllcorner 4150000\ncellsize 75\n"
                                       << "100 100 100 100\n100 150 150 100\n100 100 100 100\n";
    std::ofstream(folder / "hill.yaml") << "dem: hill.asc\ncrs: EPSG:32613\nvertical_datum: ellipsoid\n";
    std::ofstream(folder / "flight.yaml") << "height_above: ellipsoid\nlens: {hfov_deg: 60}\nkeyframes:\n"
                                             "  - {time_s: 0, lon_deg: -105.5681, lat_deg: 37.4945, height_m: 600, "
                                             "heading_deg: 0, pitch_deg: -80}\n";
    std::ofstream(folder / name) << "terrain: hill.yaml\nflight: flight.yaml\nframes: {count: 2}\n"
                                    "image: {width: 8, height: 6}\nsampling: {lines: 1}\n"
                                    "output: {contact_sheet: false, movie: false, folder: out}\n";
    return folder / name;
}

RenderOptions options_in(const TemporaryFolder& folder) {
    RenderOptions options;
    options.cache_folder = folder / "cache";
    return options;
}

TEST(RenderBatch, GoesOnPastAShotThatFails) {
    const TemporaryFolder folder;
    const std::vector shots = {write_shot(folder, "a.yaml"), folder / "missing.yaml", write_shot(folder, "c.yaml")};
    const auto outcomes = render_batch(shots, {}, options_in(folder));
    ASSERT_EQ(outcomes.size(), 3U);
    ASSERT_TRUE(outcomes[0].result);
    EXPECT_EQ(outcomes[0].result->frames_rendered, 2);
    EXPECT_FALSE(outcomes[1].result);
    EXPECT_FALSE(outcomes[1].our_fault);
    ASSERT_EQ(outcomes[1].problems.size(), 1U);
    EXPECT_EQ(outcomes[1].problems[0].text(), (folder / "missing.yaml").string() + ": no such file");
    ASSERT_TRUE(outcomes[2].result);
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / "c.0002.exr"));
}

TEST(RenderBatch, PutsOverridesIntoEveryShot) {
    const TemporaryFolder folder;
    const std::vector shots = {write_shot(folder, "a.yaml"), write_shot(folder, "b.yaml")};
    const std::vector<std::string> overrides = {"frames.count=1"};
    for (const ShotOutcome& outcome : render_batch(shots, overrides, options_in(folder))) {
        ASSERT_TRUE(outcome.result);
        EXPECT_EQ(outcome.result->frames_in_shot, 1);
    }
}

TEST(RenderBatch, EndsWhenAskedToStop) {
    const TemporaryFolder folder;
    RenderOptions options = options_in(folder);
    options.should_stop = [] { return true; };
    const std::vector shots = {write_shot(folder, "a.yaml")};
    EXPECT_THROW(static_cast<void>(render_batch(shots, {}, options)), Interrupted);
    EXPECT_FALSE(std::filesystem::exists(folder / "out" / "a.0001.exr"));
}

}  // namespace
}  // namespace overfly
