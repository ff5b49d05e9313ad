#include "shot/previews.h"

#include <chrono>

#include <gtest/gtest.h>

#include "io/frame_file.h"
#include "io/sample_frame.h"
#include "shot/sample_shot.h"

namespace overfly {
namespace {

class PreviewsOfAShot : public testing::Test {
  protected:
    PreviewsOfAShot() : shot_(sample_shot(folder_.path())) {
        shot_.frames.count = 5;
        shot_.output.movie = false;  // movies are tested through the program
        std::filesystem::create_directories(shot_.output.folder);
        frames_ = plan_frames(shot_, {0.0, 2.0});
    }
    void write(std::size_t i, const std::string& inputs, int width = 32) {
        FrameHeader header = sample_header();
        header.inputs = inputs;
        write_frame(frames_[i].file, sample_frame(width, 18), header);
    }
    Previews make(bool frames_changed) { return make_previews(shot_, look_, frames_, "mine", frames_changed, {}); }
    static std::filesystem::file_time_type time_of(const std::filesystem::path& file) {
        return std::filesystem::last_write_time(file);
    }

    TemporaryFolder folder_;
    ShotDocument shot_;
    PreviewLook look_;
    std::vector<PlannedFrame> frames_;
};

TEST_F(PreviewsOfAShot, AreNotMadeOfNothing) {
    EXPECT_TRUE(make(true).contact_sheet.empty());
    EXPECT_TRUE(std::filesystem::is_empty(shot_.output.folder));
}

TEST_F(PreviewsOfAShot, AreMadeOfTheFramesThatThereAre) {
    write(1, "mine");
    write(3, "mine");
    const Previews previews = make(true);
    EXPECT_EQ(previews.contact_sheet, shot_.output.folder / "sample.contact.png");
    EXPECT_TRUE(std::filesystem::exists(previews.contact_sheet));
    EXPECT_TRUE(previews.movie.empty());
}

TEST_F(PreviewsOfAShot, LeaveOutFramesOfAnotherVersionOfTheShot) {
    write(0, "earlier", 48);
    EXPECT_TRUE(make(true).contact_sheet.empty());
    write(1, "mine");
    EXPECT_FALSE(make(true).contact_sheet.empty());
}

TEST_F(PreviewsOfAShot, AreMadeAgainWithAnotherLook) {
    write(0, "mine");
    const auto sheet = make(true).contact_sheet;
    const auto long_after = time_of(sheet) + std::chrono::hours(1);
    std::filesystem::last_write_time(sheet, long_after);
    static_cast<void>(make(false));
    EXPECT_EQ(time_of(sheet), long_after);
    look_.burn_in.place = true;
    static_cast<void>(make(false));
    EXPECT_NE(time_of(sheet), long_after);
}

TEST_F(PreviewsOfAShot, AreKeptWhenNewerThanTheirFrames) {
    write(0, "mine");
    const auto sheet = make(true).contact_sheet;
    const auto later = time_of(sheet) + std::chrono::hours(1);
    std::filesystem::last_write_time(sheet, later);
    EXPECT_EQ(time_of(make(false).contact_sheet), later);
    EXPECT_NE(time_of(make(true).contact_sheet), later);
}

TEST_F(PreviewsOfAShot, AreMadeAgainWhenOlderThanAFrame) {
    write(0, "mine");
    const auto sheet = make(true).contact_sheet;
    const auto before = time_of(frames_[0].file) - std::chrono::hours(1);
    std::filesystem::last_write_time(sheet, before);
    EXPECT_NE(time_of(make(false).contact_sheet), before);
}

}  // namespace
}  // namespace overfly
