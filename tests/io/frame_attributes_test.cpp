#include "io/frame_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfRationalAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTimeCodeAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

// The header of a frame as other programs get it.
class FrameAttributes : public testing::Test {
  protected:
    static constexpr int kWidth_px = 48, kHeight_px = 27;

    void SetUp() override { write_frame(file(), sample_frame(kWidth_px, kHeight_px), sample_header()); }
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "a.exr"; }

  private:
    TemporaryFolder folder_;
};

// Throws when the attribute is missing or of another type.
template <class Attribute>
auto value(const Imf::InputFile& file, const char* name) {
    return file.header().typedAttribute<Attribute>(name).value();
}

TEST_F(FrameAttributes, SayTheTime) {
    const Imf::InputFile input(file().c_str());
    const Imf::Rational rate = value<Imf::RationalAttribute>(input, "framesPerSecond");
    EXPECT_EQ(rate.n, 24000);
    EXPECT_EQ(rate.d, 1001U);
    EXPECT_EQ(value<Imf::IntAttribute>(input, "imageCounter"), 25);
    EXPECT_EQ(value<Imf::FloatAttribute>(input, "expTime"), static_cast<float>(1001.0 / 48000.0));
    EXPECT_EQ(value<Imf::FloatAttribute>(input, "shutterAngle"), 180.0F);
    EXPECT_EQ(value<Imf::DoubleAttribute>(input, "overfly:time"), 1.0);
    const Imf::TimeCode code = value<Imf::TimeCodeAttribute>(input, "timeCode");
    EXPECT_EQ(code.seconds(), 1);
    EXPECT_EQ(code.frame(), 1);
    EXPECT_FALSE(code.dropFrame());
}

TEST_F(FrameAttributes, SayWhenExposuresAreTaken) {
    const Imf::InputFile input(file().c_str());
    const Imf::Rational rate = value<Imf::RationalAttribute>(input, "captureRate");
    EXPECT_EQ(rate.n, 24000);
    EXPECT_EQ(rate.d, 1001U);
    EXPECT_EQ(value<Imf::StringAttribute>(input, "capDate"), "2026:06:21 23:59:59");
    EXPECT_EQ(value<Imf::FloatAttribute>(input, "utcOffset"), 21600.0F);  // UTC is later than Colorado's clocks
    EXPECT_EQ(value<Imf::StringAttribute>(input, "overfly:date"), "2026-06-21T23:59:59.750000-06:00");
}

TEST_F(FrameAttributes, SayThePlace) {
    const Imf::InputFile input(file().c_str());
    EXPECT_FLOAT_EQ(value<Imf::FloatAttribute>(input, "longitude"), -105.4F);  // was given as 254.6
    EXPECT_FLOAT_EQ(value<Imf::FloatAttribute>(input, "latitude"), 37.6F);
    EXPECT_FLOAT_EQ(value<Imf::FloatAttribute>(input, "altitude"), 4500.0F);
    const Imath::V3d place = value<Imf::V3dAttribute>(input, "overfly:cameraPlace");
    EXPECT_NEAR(place.x, -105.4, 1e-12);
    EXPECT_NEAR(place.y, 37.6, 1e-12);
    EXPECT_EQ(place.z, 4480.0);
    const Imath::V3d origin = value<Imf::V3dAttribute>(input, "overfly:sceneOrigin");
    EXPECT_NEAR(origin.x, -105.45, 1e-12);
    EXPECT_NEAR(origin.y, 37.55, 1e-12);
    EXPECT_EQ(origin.z, 0.0);
}

TEST_F(FrameAttributes, SayTheCamera) {
    const Imf::InputFile input(file().c_str());
    EXPECT_EQ(value<Imf::FloatAttribute>(input, "pinholeFocalLength"), 24.0F);  // 36 mm / 2 / 0.75
    EXPECT_EQ(value<Imf::V2fAttribute>(input, "sensorOverallDimensions"), Imath::V2f(36.0F, 20.25F));
    EXPECT_EQ(input.header().screenWindowWidth(), 1.5F);
    EXPECT_EQ(input.header().screenWindowCenter(), Imath::V2f(0.0F, 0.0F));
    EXPECT_EQ(input.header().pixelAspectRatio(), 1.0F);

    EXPECT_EQ(value<Imf::V2fAttribute>(input, "sensorCenterOffset"), Imath::V2f(0.0F, 0.0F));
}

TEST_F(FrameAttributes, SayTheCamerasMatricesInBothPrecisions) {
    const Imf::InputFile input(file().c_str());
    const CameraPose camera = sample_header().camera;
    const struct {
        const char *single, *exact;
        RowMatrix expected;
    } cases[] = {
        {"worldToCamera", "overfly:cameraMatrix", exr_world_to_camera(camera)},
        {"worldToNDC", "overfly:worldToNDC", exr_world_to_ndc(camera, kWidth_px, kHeight_px)},
    };
    for (const auto& c : cases) {
        const auto exact = value<Imf::M44dAttribute>(input, c.exact);
        const auto single = value<Imf::M44fAttribute>(input, c.single);
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                EXPECT_EQ(exact[row][column],
                          c.expected[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
                EXPECT_EQ(single[row][column], static_cast<float>(exact[row][column]));
            }
        }
    }
}

TEST_F(FrameAttributes, SayWhereTheFrameIsFromAndWhatItMeans) {
    const Imf::InputFile input(file().c_str());
    EXPECT_EQ(value<Imf::StringAttribute>(input, "Software"), "overfly 0.1.0");
    EXPECT_EQ(value<Imf::StringAttribute>(input, "overfly:shot"), "demo.yaml");
    EXPECT_EQ(value<Imf::StringAttribute>(input, "overfly:terrain"), "blanca_peak.yaml");
    EXPECT_EQ(value<Imf::StringAttribute>(input, "overfly:flight"), "ridge.yaml");
    EXPECT_EQ(value<Imf::StringAttribute>(input, "overfly:shotSha256"), std::string(64, 'a'));
    EXPECT_EQ(value<Imf::StringAttribute>(input, "overfly:terrainSha256"), std::string(64, 'b'));
    EXPECT_EQ(input.header().find("overfly:flightSha256"), input.header().end()) << "that isn't known";
    EXPECT_NE(value<Imf::StringAttribute>(input, "overfly:depth").find("planar distance along the view axis in metres"),
              std::string::npos);
    EXPECT_NE(value<Imf::StringAttribute>(input, "comments").find("east, north, up"), std::string::npos);
    const Imf::Chromaticities colours = value<Imf::ChromaticitiesAttribute>(input, "chromaticities");
    EXPECT_EQ(colours.red, Imath::V2f(0.64F, 0.33F));
    EXPECT_EQ(colours.white, Imath::V2f(0.3127F, 0.3290F));
}

TEST_F(FrameAttributes, ProjectAPointWhereTheCameraSeesItForOpenImageIO) {
    const auto input = OIIO::ImageInput::open(file().string());
    ASSERT_TRUE(input);
    const auto* attribute = input->spec().find_attribute("worldtoNDC", OIIO::TypeMatrix);
    ASSERT_NE(attribute, nullptr);
    const auto* m = static_cast<const float*>(attribute->data());

    // What lies 6 km along the view and 1.5 km to the right and 0.9 km up the image, by hand: half the picture's
    // width is 0.75 * 6 km = 4.5 km there, half its height 9/16 of that.
    const CameraPose camera = sample_header().camera;
    const Point<Scene> p = camera.position + camera.orientation * Vector<Camera>{1500.0, -900.0, 6000.0};
    std::array<double, 4> q{};
    for (std::size_t i = 0; i < 4; ++i) q[i] = p.x * m[i] + p.y * m[4 + i] + p.z * m[8 + i] + m[12 + i];
    EXPECT_NEAR(q[0] / q[3], 0.5 + 0.5 * 1500.0 / 4500.0, 1e-6);
    EXPECT_NEAR(q[1] / q[3], 0.5 - 0.5 * 900.0 / (4500.0 * 9.0 / 16.0), 1e-6);
    EXPECT_NEAR(q[3], 6000.0, 0.01);
}

TEST_F(FrameAttributes, SayForOpenImageIOWhenExposuresAreTaken) {
    const auto input = OIIO::ImageInput::open(file().string());
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_EQ(spec.get_string_attribute("DateTime"), "2026:06:21 23:59:59");
    EXPECT_EQ(spec.get_float_attribute("utcOffset"), 21600.0F);
    EXPECT_EQ(spec.get_float_attribute("ExposureTime"), static_cast<float>(1001.0 / 48000.0));
    const auto* const rate = spec.find_attribute("captureRate", OIIO::TypeRational);
    ASSERT_NE(rate, nullptr);
    const auto* const terms = static_cast<const int*>(rate->data());
    EXPECT_EQ(terms[0], 24000);
    EXPECT_EQ(terms[1], 1001);
}

TEST(FrameAttributesWithoutADate, SayNone) {
    FrameHeader header = sample_header();
    header.date.reset();
    for (const FrameAttribute& attribute : frame_attributes(header, 16, 9)) {
        EXPECT_NE(attribute.name, "capDate");
        EXPECT_NE(attribute.name, "utcOffset");
        EXPECT_NE(attribute.name, "overfly:date");
    }
}

// Where x lies in a picture 1920 pixels wide, by a matrix for row vectors.
template <class Matrix>
double column_px(Point<Scene> x, const Matrix& m) {
    const auto product = [&](std::size_t i) { return x.x * m[0][i] + x.y * m[1][i] + x.z * m[2][i] + m[3][i]; };
    return 1920.0 * product(0) / product(3);
}

// What the contract says of worldToNDC in single precision, and that it is no idle promise.
TEST(FrameAttributesFarFromTheOrigin, AreAsExactAsTheContractSays) {
    FrameHeader header = sample_header();
    header.camera.tan_half_fov = std::tan(Angle::degrees(30.0).radians());
    double largest_px = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double turn = 0.01 * i;
        header.camera.position = {20'000.0 * std::cos(turn), 20'000.0 * std::sin(turn), 3000.0 + i};
        header.camera.orientation = {
            {std::cos(3 * turn), std::sin(3 * turn), 0}, {0, 0, -1}, {-std::sin(3 * turn), std::cos(3 * turn), 0}};
        const Point<Scene> seen = header.camera.position + header.camera.orientation * Vector<Camera>{0, 0, 400.0};
        for (const FrameAttribute& attribute : frame_attributes(header, 1920, 1080)) {
            if (attribute.name == "overfly:worldToNDC") {
                EXPECT_NEAR(column_px(seen, std::get<RowMatrix>(attribute.value)), 960.0, 1e-7);
            } else if (attribute.name == "worldToNDC") {
                const double found_px = column_px(seen, std::get<FrameAttribute::Matrix44f>(attribute.value));
                largest_px = std::max(largest_px, std::abs(found_px - 960.0));
            }
        }
    }
    EXPECT_LT(largest_px, 0.01);
    EXPECT_GT(largest_px, 0.003);
}

TEST(FrameAttributesOfOddRates, HaveNoTimeCode) {
    FrameHeader header = sample_header();
    header.rate = {25, 2};
    for (const FrameAttribute& attribute : frame_attributes(header, 16, 9)) EXPECT_NE(attribute.name, "timeCode");
}

}  // namespace
}  // namespace overfly
