#include "config/nearest_word.h"

#include <gtest/gtest.h>

#include <vector>

namespace overfly::config {
namespace {

TEST(EditDistance, OfTextbookPairs) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("widht", "width"), 1U);
    EXPECT_EQ(edit_distance("saturday", "sunday"), 3U);
    EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // 2 if a swapped pair could be edited again
}

TEST(EditDistance, IsSymmetric) {
    const std::vector<std::string> words = {"", "a", "width", "widht", "height", "lon_deg", "lat_deg", "time_s"};
    for (const auto& a : words) {
        for (const auto& b : words) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << ' ' << b;
    }
}

TEST(NearestWord, IsTheOneMeant) {
    const std::vector<std::string> known = {"lon_deg", "lat_deg", "height_m", "height_above"};
    EXPECT_EQ(nearest_word("lon_dge", known), "lon_deg");
    EXPECT_EQ(nearest_word("heigth_m", known), "height_m");
    EXPECT_EQ(nearest_word("hight_above", known), "height_above");
    EXPECT_EQ(nearest_word("ln_deg", known), "lon_deg");
}

TEST(NearestWord, IsNoneWhereNothingIsNear) {
    const std::vector<std::string> known = {"dem", "crs", "band"};
    EXPECT_EQ(nearest_word("colour", known), std::nullopt);
    EXPECT_EQ(nearest_word("", known), std::nullopt);
    EXPECT_EQ(nearest_word(std::string(100'000'000, 'd'), known), std::nullopt);
    EXPECT_EQ(nearest_word("dem", {}), std::nullopt);
}

}  // namespace
}  // namespace overfly::config
