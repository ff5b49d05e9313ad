#include "io/colour_relief_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

using Entry = ColourRelief::Entry;

ColourRelief read(const std::string& text, const std::string& name = "a.txt") {
    const TemporaryFolder folder;
    std::ofstream(folder / name) << text;
    return read_colour_relief(folder / name);
}

std::vector<std::string> problems(const std::string& text, const std::string& name = "a.txt") {
    std::vector<std::string> said;
    try {
        (void)read(text, name);
    } catch (const UserError& error) {
        for (const Problem& p : error.problems())
            said.push_back(std::to_string(p.place.line) + ":" + std::to_string(p.place.column) + ": " + p.message);
    }
    return said;
}

// The example of gdaldem's own page.
TEST(ColourRelief, ReadsGdalsExample) {
    const ColourRelief relief = read(
        "3500   white\n2500   235:220:175\n50%   190 185 135\n700    240 250 150\n"
        "0      50  180  50\nnv     0   0   0   0\n");
    EXPECT_EQ(relief.entries, (std::vector<Entry>{{3500, false, {255, 255, 255}},
                                                  {2500, false, {235, 220, 175}},
                                                  {50, true, {190, 185, 135}},
                                                  {700, false, {240, 250, 150}},
                                                  {0, false, {50, 180, 50}}}));
    EXPECT_EQ(relief.no_data, (ColourRelief::Srgb{0, 0, 0}));
}

TEST(ColourRelief, TakesAllSeparatorsAndComments) {
    const ColourRelief relief = read("# heights\r\n-10,1,2,3\r\n\r\n0:4:5:6:255\n+1.5e1\t7 8,9 # end\n 20  Aqua");
    EXPECT_EQ(relief.entries,
              (std::vector<Entry>{
                  {-10, false, {1, 2, 3}}, {0, false, {4, 5, 6}}, {15, false, {7, 8, 9}}, {20, false, {0, 191, 191}}}));
    EXPECT_FALSE(relief.no_data.has_value());
}

TEST(ColourRelief, ReadsCptTables) {
    const ColourRelief relief = read(
        "# COLOR_MODEL = RGB\n0 0 97 71 50 16 122 47\n50 16 122 47 500 232/215/125\n"
        "500 130 30 30 1200 161 67 0 L\nB 0 0 0\nF 255 255 255\nN 128 128 128\n",
        "a.cpt");
    EXPECT_EQ(relief.entries, (std::vector<Entry>{{0, false, {0, 97, 71}},
                                                  {50, false, {16, 122, 47}},
                                                  {500, false, {232, 215, 125}},
                                                  {500, false, {130, 30, 30}},
                                                  {1200, false, {161, 67, 0}}}));
    EXPECT_EQ(relief.no_data, (ColourRelief::Srgb{128, 128, 128}));
}

TEST(ColourRelief, SaysEverythingThatIsWrongAndWhere) {
    EXPECT_EQ(problems("low 1 2 3\n100 1 2\n200 1 256 x\n300 mauve\n400 1 2 3\n"),
              (std::vector<std::string>{"1:1: \"low\" is no elevation; a number, a percentage or nv",
                                        "2:1: 2 colour values; there are three, R G B, or four with opacity, or a name",
                                        "3:7: \"256\" is no colour value; 0 to 255",
                                        "3:11: \"x\" is no colour value; 0 to 255",
                                        "4:5: \"mauve\" is no colour that is known by name"}));
    EXPECT_EQ(problems("# nothing\n"), std::vector<std::string>{"0:0: has no line with an elevation and a colour"});
    EXPECT_EQ(problems("# COLOR_MODEL = HSV\n0 0 1 1 9 90 1 1\n", "a.cpt"),
              std::vector<std::string>{"1:1: only RGB tables are understood"});
    EXPECT_EQ(problems("0 1 2 3\n", "a.cpt"),
              std::vector<std::string>{"1:1: a slice is two elevations, each with R G B"});
    EXPECT_THROW((void)read_colour_relief("no such file"), UserError);
}

TEST(ColourRelief, BecomesARampInLinearLight) {
    const ColourRelief relief = read("100% white\n1000 188 0 0\n0% black\n");
    const ColourRamp ramp = colour_ramp(relief, {500, 2500});
    ASSERT_EQ(ramp.stops.size(), 3U);
    EXPECT_EQ(ramp.stops[0], (ColourRamp::Stop{500, {0, 0, 0}}));
    EXPECT_EQ(ramp.stops[1].elevation_m, 1000);
    EXPECT_NEAR(ramp.stops[1].colour.r, 0.5F, 0.005F) << "display 188 is half of the light";
    EXPECT_EQ(ramp.stops[2].elevation_m, 2500);
    EXPECT_NEAR(ramp.stops[2].colour.g, 1.0F, 1e-6F);
}

TEST(ColourRelief, KeepsTheOrderOfAStep) {
    const ColourRamp ramp = colour_ramp(read("0 blue\n0 white\n100 white\n"), {0, 100});
    EXPECT_EQ(ramp.at(-0.1F), (Rgb{0, 0, 1}));
    EXPECT_NEAR(ramp.at(0.0F).r, 1.0F, 1e-6F);
}

}  // namespace
}  // namespace overfly
