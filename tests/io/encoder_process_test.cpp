#include "io/encoder_process.h"

#include <vector>

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(EncoderProcess, GetsEveryByteAndItsArgumentsUnchanged) {
    const auto process = EncoderProcess::start({"sh", "-c", "wc -c >&2; echo \"$0\" >&2", "it's \"one\" $argument"});
    ASSERT_TRUE(process);
    const std::vector<std::uint8_t> bytes(1'000'000, 7);
    EXPECT_TRUE(process->write(bytes));
    EXPECT_TRUE(process->finish());
    EXPECT_EQ(process->complaints(), "1000000\nit's \"one\" $argument");
}

TEST(EncoderProcess, TellsOfAProgramThatFails) {
    const auto process = EncoderProcess::start({"sh", "-c", "echo broken >&2; cat >/dev/null; exit 3"});
    ASSERT_TRUE(process);
    EXPECT_FALSE(process->finish());
    EXPECT_EQ(process->complaints(), "broken");
}

TEST(EncoderProcess, TellsOfAProgramThatStopsReading) {
    const auto process = EncoderProcess::start({"true"});
    ASSERT_TRUE(process);
    const std::vector<std::uint8_t> more_than_any_buffer(100'000'000, 7);
    EXPECT_FALSE(process->write(more_than_any_buffer));
    EXPECT_TRUE(process->finish());
}

TEST(EncoderProcess, EndsAProgramThatIsNotWaitedFor) {
    const auto process = EncoderProcess::start({"sleep", "1000"});
    EXPECT_TRUE(process);
}  // the test would run into its time limit here

// A user who wants to stop must be heard while the program neither reads nor ends.
TEST(EncoderProcess, AsksWhileItWaits) {
    struct Stopped {};
    const auto stop = [] { throw Stopped(); };
    const std::vector<std::uint8_t> more_than_any_buffer(100'000'000, 7);
    const auto deaf = EncoderProcess::start({"sleep", "1000"}, stop);
    ASSERT_TRUE(deaf);
    EXPECT_THROW(static_cast<void>(deaf->write(more_than_any_buffer)), Stopped);
    const auto slow = EncoderProcess::start({"sleep", "1000"}, stop);
    ASSERT_TRUE(slow);
    EXPECT_THROW(static_cast<void>(slow->finish()), Stopped);
}

TEST(EncoderProcess, IsNothingWhereTheProgramIsNotInstalled) {
    EXPECT_FALSE(EncoderProcess::start({"no-program-of-this-name"}));
}

}  // namespace
}  // namespace overfly
