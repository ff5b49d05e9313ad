#include "core/local_time.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

using namespace std::chrono_literals;

TEST(LocalTime, IsReadWithItsDistanceFromUtc) {
    const auto time = parse_local_time("2026-06-21T09:30:00-06:00");
    ASSERT_TRUE(time);
    EXPECT_EQ(time->ahead_of_utc, -6h);
    EXPECT_EQ(time->utc, std::chrono::sys_days(2026y / 6 / 21) + 15h + 30min);
    EXPECT_EQ(time->clock(), std::chrono::sys_days(2026y / 6 / 21) + 9h + 30min);
}

TEST(LocalTime, IsReadInItsOtherSpellings) {
    const auto noon = parse_local_time("2024-02-29T12:00:00+00:00");
    ASSERT_TRUE(noon);
    for (const char* text :
         {"2024-02-29T12:00:00Z", "2024-02-29 12:00:00Z", "2024-02-29T12:00:00.000Z", "2024-02-29T12:00:00-00:00"}) {
        EXPECT_EQ(parse_local_time(text), noon) << text;
    }
    EXPECT_EQ(parse_local_time("2024-02-29T17:45:00.25+05:45")->utc, noon->utc + 250ms);
}

TEST(LocalTime, IsRefusedWhereItIsNone) {
    for (const char* text :
         {"", "2026-06-21", "2026-06-21T09:30:00", "2026-06-21T09:30-06:00", "2026-06-31T09:30:00Z",
          "2025-02-29T09:30:00Z", "2026-13-01T09:30:00Z", "2026-06-21T24:00:00Z", "2026-06-21T09:60:00Z",
          "2026-06-21T09:30:60Z", "2026-06-21T09:30:00.Z", "2026-06-21T09:30:00.1234567Z", "2026-06-21T09:30:00-15:00",
          "2026-06-21T09:30:00-06", "2026-06-21T09:30:00Z ", "0000-06-21T09:30:00Z", "2026-+6-21T09:30:00Z", "09:30"}) {
        EXPECT_FALSE(parse_local_time(text)) << text;
    }
}

TEST(LocalTime, IsWrittenAsItIsRead) {
    for (const char* text : {"2026-06-21T09:30:00-06:00", "2026-12-31T23:59:59.041667+05:45",
                             "0001-01-01T00:00:00+00:00", "9999-12-31T00:00:00.000001-14:00"}) {
        const auto time = parse_local_time(text);
        ASSERT_TRUE(time) << text;
        EXPECT_EQ(iso_text(*time), text);
    }
}

TEST(LocalTime, GoesOnAcrossMidnightAndBackwards) {
    const LocalTime late = *parse_local_time("2026-12-31T23:59:59-06:00");
    EXPECT_EQ(iso_text(later(late, 1.0 + 1.0 / 24.0)), "2027-01-01T00:00:00.041667-06:00");
    EXPECT_EQ(iso_text(later(late, -0.25)), "2026-12-31T23:59:58.750000-06:00");
    EXPECT_EQ(later(late, 0.0), late);
}

}  // namespace
}  // namespace overfly
