#include "shot/frame_writer.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

class FrameWriters : public testing::Test {
  protected:
    [[nodiscard]] PlannedFrame planned(int number) const {
        return {number, 0.0, {}, folder_ / "frames" / frame_file_name("demo", number), 1.0};
    }
    [[nodiscard]] static FrameOnFilm exposed(const PlannedFrame& frame) { return {frame, FilmFrame(64, 32)}; }
    [[nodiscard]] static FinishedFrame finish(const PlannedFrame& frame, FilmFrame film) {
        FrameHeader header;
        header.number = frame.number;
        return {std::move(film).develop().frame, header};
    }
    [[nodiscard]] bool is_complete(int number) const { return is_complete_frame(planned(number).file); }
    // The numbers that the manifest lists.
    [[nodiscard]] std::string listed() const {
        std::string text;
        const auto manifest = read_manifest(folder_ / "frames");
        if (!manifest) return "no manifest";
        for (const ManifestFrame& f : manifest->sequences.at("demo").frames) text += std::to_string(f.number) + ' ';
        return text;
    }

    void SetUp() override { std::filesystem::create_directory(folder_ / "frames"); }

    TemporaryFolder folder_;
    SequenceManifest manifest_{folder_ / "frames", "demo", "inputs"};
    FrameWriter writer_{finish, {}, manifest_};
};

TEST_F(FrameWriters, WriteAllFramesAndListThem) {
    for (int number = 1; number <= 5; ++number) writer_.write(exposed(planned(number)));
    writer_.finish();
    EXPECT_EQ(writer_.in_hand(), 0U);
    EXPECT_EQ(writer_.frames_written(), 5);
    EXPECT_GT(writer_.seconds(), 0.0);
    for (int number = 1; number <= 5; ++number) EXPECT_TRUE(is_complete(number)) << number;
    EXPECT_EQ(listed(), "1 2 3 4 5 ");
}

TEST_F(FrameWriters, KeepWhatIsWrittenWhenAFrameCantBe) {
    writer_.write(exposed(planned(1)));
    writer_.write(exposed(planned(2)));
    writer_.wait();
    PlannedFrame astray = planned(3);
    astray.file = folder_ / "no such folder" / "demo.0003.exr";
    writer_.write(exposed(astray));
    writer_.wait();
    EXPECT_TRUE(writer_.has_failed());
    writer_.write(exposed(planned(4)));
    EXPECT_THROW(writer_.finish(), UserError);
    EXPECT_EQ(writer_.in_hand(), 0U);
    EXPECT_EQ(writer_.frames_written(), 2);
    EXPECT_TRUE(is_complete(1) && is_complete(2));
    EXPECT_FALSE(is_complete(4));
    EXPECT_EQ(listed(), "1 2 ");
}

TEST_F(FrameWriters, LeaveNothingWhereTheFolderVanishes) {
    writer_.write(exposed(planned(1)));
    writer_.wait();
    std::filesystem::remove_all(folder_ / "frames");
    for (int number = 2; number <= 5; ++number) writer_.write(exposed(planned(number)));
    EXPECT_THROW(writer_.discard(), UserError);
    EXPECT_EQ(writer_.frames_written(), 1);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "frames"));
}

// Those that are written are the first ones, so that a sequence has no holes where a run was stopped.
TEST_F(FrameWriters, DiscardFromTheEnd) {
    constexpr int kFrames = 40;
    for (int number = 1; number <= kFrames; ++number) writer_.write(exposed(planned(number)));
    writer_.discard();
    EXPECT_EQ(writer_.in_hand(), 0U);
    const int written = writer_.frames_written();
    EXPECT_LE(written, kFrames);
    for (int number = 1; number <= kFrames; ++number) EXPECT_EQ(is_complete(number), number <= written) << number;
}

}  // namespace
}  // namespace overfly
