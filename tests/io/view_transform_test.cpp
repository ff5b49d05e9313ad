#include "io/view_transform.h"

#include <array>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/display.h"
#include "io/sample_view.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

using testing::HasSubstr;

// $OCIO as the test wants it; what it was comes back.
class Environment {
  public:
    explicit Environment(const std::string& ocio) {
        if (const char* before = std::getenv("OCIO")) before_ = before;
        set(ocio);
    }
    ~Environment() { set(before_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    static void set(const std::string& value) { value.empty() ? unsetenv("OCIO") : setenv("OCIO", value.c_str(), 1); }
    std::string before_;
};

std::array<float, 4> shown(const ViewTransform& view, std::array<float, 4> rgba) {
    std::array<std::array<float, 4>, 1> pixels = {rgba};
    view.apply(pixels);
    return pixels[0];
}

std::string complaint(const ViewChoice& choice) {
    try {
        const ViewTransform view(choice);
        return "none: " + view.story();
    } catch (const UserError& error) {
        return error.what();
    }
}

TEST(SoftHighlight, KeepsWhatIsNotAHighlight) {
    for (const float v : {0.0F, 0.18F, 0.5F, 0.8F}) EXPECT_EQ(soft_highlight(v), v);
    EXPECT_EQ(soft_highlight(-0.1F), 0.0F);
}

TEST(SoftHighlight, RisesToOneWithoutAKink) {
    float last = soft_highlight(0.8F);
    for (float v = 0.81F; v < 1.5F; v += 0.01F) {
        const float now = soft_highlight(v);
        EXPECT_GT(now, last);
        EXPECT_LT(now - last, 0.0101F);
        last = now;
    }
    EXPECT_LE(soft_highlight(1e6F), 1.0F);
    EXPECT_NEAR(soft_highlight(0.8F + 1e-3F) - 0.8F, 1e-3F, 1e-5F);
}

TEST(ViewTransform, IsSrgbWhereNothingElseIsThere) {
    EXPECT_EQ(ViewTransform().name(), "sRGB");
    // IEC 61966-2-1: 18 % grey.
    EXPECT_NEAR(shown(ViewTransform(), {0.18F, 0.18F, 0.18F, 1.0F})[0], 0.4613F, 1e-4F);
}

TEST(ViewTransform, TakesTheDefaultViewOfAConfiguration) {
    const TemporaryFolder folder;
    const ViewTransform view({.config = write_sample_view(folder / "a.ocio")});
    EXPECT_EQ(view.name(), "Monitor, Half");
    EXPECT_EQ(view.story(), "Monitor, Half, by OpenColorIO's " + (folder / "a.ocio").string());
    EXPECT_EQ(shown(view, {0.5F, 1.0F, 3.0F, 0.75F}), (std::array{0.25F, 0.5F, 1.5F, 0.75F}));
}

TEST(ViewTransform, TakesTheDisplayAndTheViewThatAreAskedFor) {
    const TemporaryFolder folder;
    const auto file = write_sample_view(folder / "a.ocio");
    EXPECT_EQ(shown(ViewTransform({.config = file, .display = "Projector"}), {0.5F, 1.0F, 2.0F, 1.0F}),
              (std::array{0.125F, 0.25F, 0.5F, 1.0F}));
    EXPECT_EQ(shown(ViewTransform({.config = file, .view = "Plain"}), {0.5F, 1.0F, 2.0F, 1.0F}),
              (std::array{0.5F, 1.0F, 2.0F, 1.0F}));
}

TEST(ViewTransform, NamesWhatIsAllowed) {
    const TemporaryFolder folder;
    const auto file = write_sample_view(folder / "a.ocio");
    const std::string place = file.string() + ": ";
    EXPECT_EQ(complaint({.config = file, .display = "Screen"}),
              place + "output.preview.display: got 'Screen', allowed Monitor, Projector");
    EXPECT_EQ(complaint({.config = file, .view = "Quarter"}),
              place + "output.preview.view: got 'Quarter', allowed Half, Plain");
    EXPECT_EQ(complaint({.config = file, .colour_space = "linear"}),
              place + "output.preview.colour_space: got 'linear', allowed raw, lin_rec709_scene, half, quarter");
    EXPECT_THAT(complaint({.config = folder / "missing.ocio"}), HasSubstr("missing.ocio: "));
}

TEST(ViewTransform, AsksWhichColourSpaceOursIs) {
    const TemporaryFolder folder;
    const auto file = write_sample_view(folder / "a.ocio", "house_linear");
    EXPECT_THAT(complaint({.config = file}),
                HasSubstr("say with output.preview.colour_space which one it is: raw, house_linear"));
    EXPECT_EQ(ViewTransform({.config = file, .colour_space = "house_linear"}).name(), "Monitor, Half");
    EXPECT_EQ(ViewTransform({.config = file, .colour_space = "scene_linear"}).name(), "Monitor, Half");  // a role
}

TEST(ViewTransform, HonoursTheEnvironment) {
    const TemporaryFolder folder;
    const Environment environment(write_sample_view(folder / "a.ocio").string());
    EXPECT_EQ(ViewTransform(ViewChoice{}).name(), "Monitor, Half");
    EXPECT_EQ(ViewTransform({.display = "Projector"}).name(), "Projector, Quarter");
    // The document's own goes before it.
    EXPECT_EQ(ViewTransform({.config = write_sample_view(folder / "b.ocio"), .view = "Plain"}).story(),
              "Monitor, Plain, by OpenColorIO's " + (folder / "b.ocio").string());
}

TEST(ViewTransform, SaysWhyTheEnvironmentIsOfNoUse) {
    const TemporaryFolder folder;
    const std::string file = write_sample_view(folder / "a.ocio", "house_linear").string();
    const Environment environment(file);
    const ViewTransform view(ViewChoice{});
    EXPECT_EQ(view.name(), "sRGB");
    EXPECT_THAT(view.story(), HasSubstr("sRGB; " + file + ": no colour space has a usual name"));
    // Asked for, it is an error.
    EXPECT_THAT(complaint({.view = "Plain"}), HasSubstr(file + ": no colour space has a usual name"));
}

TEST(ViewTransform, SaysWhatItIsWithoutAnyConfiguration) {
    const Environment environment("");
    const ViewTransform view(ViewChoice{});
    if (view.name() == "sRGB") {
        EXPECT_THAT(view.story(), testing::MatchesRegex("sRGB; OpenColorIO 2.1[.0-9]* has no built-in configuration"));
        EXPECT_THAT(complaint({.view = "Plain"}), HasSubstr("name one with output.preview.ocio_config or $OCIO"));
    } else {
        EXPECT_THAT(view.story(), HasSubstr("by OpenColorIO's ocio://default"));
        EXPECT_THAT(complaint({.view = "Plain"}),
                    HasSubstr("ocio://default: output.preview.view: got 'Plain', allowed "));
    }
}

TEST(ViewTransform, IsWhatADisplayImageShows) {
    const TemporaryFolder folder;
    const ViewTransform view({.config = write_sample_view(folder / "a.ocio")});
    const Frame frame{.width = 1, .height = 1, .rgba = {{0.2F, 1.0F, 9.0F, 1.0F}}, .depth_m = {1.0F}};
    EXPECT_EQ(display_image(frame, view).rgb, (std::vector<std::uint8_t>{26, 128, 255}));
}

}  // namespace
}  // namespace overfly
