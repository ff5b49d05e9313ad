#include "shot/sequence_manifest.h"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/temporary_folder.h"

namespace overfly {
namespace {

class SequenceManifests : public testing::Test {
  protected:
    [[nodiscard]] SequenceManifest open(const std::string& name = "demo", const std::string& inputs = "one") const {
        return {folder_.path(), name, inputs};
    }
    static ManifestFrame frame(int number, const std::string& hash = "hash") {
        return {.number = number, .file = "", .pixels_sha256 = hash, .statistics = {}, .render_s = {}};
    }
    static std::vector<PlannedFrame> planned(const std::vector<int>& numbers) {
        std::vector<PlannedFrame> frames;
        for (const int number : numbers) frames.push_back({.number = number, .exposure = {}, .file = {}});
        return frames;
    }
    // The numbers that the file lists, with their hashes.
    [[nodiscard]] std::string listed(const std::string& name = "demo") const {
        std::string text;
        const auto manifest = read_manifest(folder_.path());
        if (!manifest) return "no manifest";
        for (const ManifestFrame& f : manifest->sequences.at(name).frames)
            text += std::to_string(f.number) + ' ' + f.pixels_sha256 + ", ";
        return text;
    }
    void list(const std::vector<int>& numbers, const std::string& name = "demo") const {
        SequenceManifest manifest = open(name);
        for (const int number : numbers) manifest.add(frame(number));
        manifest.save();
    }

    TemporaryFolder folder_;
};

TEST_F(SequenceManifests, ListsWhatIsAddedByNumber) {
    SequenceManifest manifest = open();
    manifest.add(frame(3));
    manifest.add(frame(1));
    manifest.save();
    EXPECT_EQ(listed(), "1 hash, 3 hash, ");
    manifest.add(frame(2, "new"));
    manifest.add(frame(3, "new"));
    manifest.save();
    EXPECT_EQ(listed(), "1 hash, 2 new, 3 new, ");
    EXPECT_EQ(open().find(2)->pixels_sha256, "new");
    EXPECT_EQ(open().find(4), nullptr);
}

TEST_F(SequenceManifests, WritesNothingWhereNothingChanged) {
    SequenceManifest empty = open();
    empty.describe({});
    empty.forget(planned({1, 2}));
    EXPECT_FALSE(empty.is_changed());
    empty.save();
    EXPECT_EQ(listed(), "no manifest");
}

TEST_F(SequenceManifests, ForgetsWhatIsToBeRenderedAnew) {
    list({1, 2, 3});
    SequenceManifest manifest = open();
    manifest.forget(planned({2, 3, 4}));
    EXPECT_TRUE(manifest.is_changed());
    manifest.save();
    EXPECT_EQ(listed(), "1 hash, ");
    manifest.add(frame(3, "again"));
    manifest.save();
    EXPECT_EQ(listed(), "1 hash, 3 again, ");
}

TEST_F(SequenceManifests, KeepsWhatAnotherRunListsMeanwhile) {
    SequenceManifest one = open(), other = open(), elsewhere = open("close-up");
    one.add(frame(1));
    one.save();
    other.add(frame(2));
    other.save();
    elsewhere.add(frame(7));
    elsewhere.save();
    one.add(frame(3));
    one.save();
    EXPECT_EQ(listed(), "1 hash, 2 hash, 3 hash, ");
    EXPECT_EQ(listed("close-up"), "7 hash, ");
}

TEST_F(SequenceManifests, DropsFramesOfOtherInputs) {
    list({1, 2, 3});
    SequenceManifest changed = open("demo", "other inputs");
    EXPECT_EQ(changed.find(1), nullptr);
    EXPECT_FALSE(changed.is_changed());
    changed.forget(planned({1}));  // the first to be rendered: from now on none of the old ones may be believed
    EXPECT_TRUE(changed.is_changed());
    changed.save();
    EXPECT_EQ(listed(), "");
    changed.add(frame(1, "new"));
    changed.save();
    EXPECT_EQ(listed(), "1 new, ");
}

TEST_F(SequenceManifests, KeepsErrorsThatThisRunDidNotLookFor) {
    SequenceManifest first = open();
    ManifestSequence about;
    about.mesh = {0.5, 0.25};
    about.motion = {0.01, 0.005};
    first.describe(about);
    first.add(frame(1));
    first.save();
    SequenceManifest second = open();
    about.mesh.largest_px.reset();
    about.motion.largest_px.reset();
    second.describe(about);
    second.add(frame(2));
    second.save();
    const ManifestSequence found = read_manifest(folder_.path())->sequences.at("demo");
    EXPECT_EQ(found.mesh.largest_px, 0.25);
    EXPECT_EQ(found.motion.largest_px, 0.005);
    EXPECT_EQ(found.inputs, "one");
}

TEST_F(SequenceManifests, StartAnewWhereTheFileIsBroken) {
    list({1, 2});
    EXPECT_FALSE(open().was_broken());
    std::ofstream(folder_ / kManifestName) << "{";
    SequenceManifest manifest = open();
    EXPECT_TRUE(manifest.was_broken());
    EXPECT_EQ(manifest.find(1), nullptr);
    manifest.add(frame(2));
    manifest.save();
    EXPECT_EQ(listed(), "2 hash, ");
}

}  // namespace
}  // namespace overfly
