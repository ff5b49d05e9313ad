#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <ranges>

#include "film/cryptomatte.h"
#include "io/exr_camera.h"
#include "shot/flight_scene.h"
#include "shot/hill_shot.h"

namespace overfly {
namespace {

using namespace testing;

const HillShot& hill() {
    static const HillShot shot;
    return shot;
}

// Rendered once for all tests.
const Frame& blurred() {
    static const Frame frame = hill().rendered();
    return frame;
}
const Frame& sharp() {
    static const Frame frame = hill().rendered(
        {"sampling.tracer=discrete", "sampling.samples=1", "shutter.angle_deg=0", "mesh.pixel_error=0"});
    return frame;
}

// How far an approximated camera may be off (motion_bound_px).
constexpr double kMotionBound_px = 0.01;

// Where the light of a pixel comes from adds up to the pixel.
void expect_light_adds_up(const Frame& frame) {
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string end = std::string(".") + "RGB"[c];
            double sum = 0.0;
            for (const char* layer : {"direct", "shadow", "sky", "haze", "background", "reflection"})
                sum += static_cast<double>(channel(frame, layer + end)[i]);
            largest = std::max(largest, std::abs(sum - static_cast<double>(frame.rgba[i][c])));
        }
    }
    // The beauty and six layers are stored as half, with 11 binary digits.
    EXPECT_LT(largest, 7 * 0.5 / 2048.0);
}

TEST(Layers, LightAddsUpToTheBeauty) {
    expect_light_adds_up(blurred());
    expect_light_adds_up(sharp());
    expect_light_adds_up(hill().rendered({"image.filter=mitchell", "shutter.shape=smooth", "layers=light"}));
    expect_light_adds_up(hill().rendered({"sampling.error=0.01", "layers=light"}));
    expect_light_adds_up(hill().rendered({"sampling.tracer=interval", "sampling.drift_px=0", "layers=light"}));
    expect_light_adds_up(hill().rendered({"sampling.tracer=hybrid", "sampling.samples=4", "layers=light"}));
    expect_light_adds_up(hill().rendered({"image.transparent_sky=true", "layers=light"}));
}

// Whether the pixel shows nothing but this object.
bool shows_only(const Frame& frame, std::size_t i, std::string_view object) {
    return channel(frame, "CryptoObject00.r")[i] == cryptomatte_number(cryptomatte_id(object)) &&
           channel(frame, "CryptoObject00.g")[i] > 0.9999F;
}

Point<Scene> position(const Frame& frame, std::size_t i) {
    return {static_cast<double>(channel(frame, "P.X")[i]), static_cast<double>(channel(frame, "P.Y")[i]),
            static_cast<double>(channel(frame, "P.Z")[i])};
}

// The camera of the shot, apart from how it is rendered.
class Camera {
  public:
    Camera() : stage_(prepare_terrain(shot_.terrain, hill().cache()), middle_of(shot_.flight)) {}

    // Of the frame that is rendered, or so many frames later, in its middle.
    [[nodiscard]] CameraPose pose(int later = 0) const {
        return path_.pose_at(shot_.frames.start_s + (1 + later) / kRate);
    }
    struct Seen {
        double x = 0.0, y = 0.0;  // pixels from the upper left
        double depth_m = 0.0;
    };
    [[nodiscard]] Seen seen(Point<Scene> p, int later = 0) const {
        const auto m = exr_world_to_ndc(pose(later), HillShot::kWidth, HillShot::kHeight);
        const std::array<double, 4> at = {p.x, p.y, p.z, 1.0};
        std::array<double, 4> to{};
        for (std::size_t c = 0; c < 4; ++c) {
            for (std::size_t r = 0; r < 4; ++r) to[c] += at[r] * m[r][c];
        }
        return {HillShot::kWidth * to[0] / to[3], HillShot::kHeight * to[1] / to[3], to[3]};
    }
    [[nodiscard]] const Stage& stage() const { return stage_; }

    static constexpr double kRate = 24.0;

  private:
    ShotDocument shot_ = hill().document();
    Stage stage_;
    CameraPath path_ = make_path(shot_.flight, stage_);
};

const Camera& camera() {
    static const Camera camera;
    return camera;
}

TEST(Layers, PlacesAreWhereThePixelsLook) {
    const Frame& frame = sharp();
    int seen = 0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        if (channel(frame, "coverage")[i] == 0.0F) continue;
        ++seen;
        const Point<Scene> p = position(frame, i);
        const Camera::Seen at = camera().seen(p);
        EXPECT_NEAR(at.x, static_cast<double>(i % HillShot::kWidth) + 0.5, 0.5 + kMotionBound_px);
        EXPECT_NEAR(at.y, static_cast<double>(i / HillShot::kWidth) + 0.5, 0.5 + kMotionBound_px);
        EXPECT_NEAR(static_cast<double>(frame.depth_m[i]), at.depth_m, 1e-5 * at.depth_m);
        EXPECT_NEAR(static_cast<double>(channel(frame, "mean.Z")[i]), at.depth_m, 1e-5 * at.depth_m);
        const double range_m = length(p - camera().pose().position);
        EXPECT_NEAR(static_cast<double>(channel(frame, "mean.range")[i]), range_m, 1e-5 * range_m);
        EXPECT_NEAR(static_cast<double>(channel(frame, "range")[i]), range_m, 0.01 * range_m);
        const Geodetic place = camera().stage().frame().geodetic(p);
        EXPECT_NEAR(static_cast<double>(channel(frame, "lon")[i]), place.lon.degrees(), 5e-6);
        EXPECT_NEAR(static_cast<double>(channel(frame, "lat")[i]), place.lat.degrees(), 3e-6);
        const double sea_level_m = camera().stage().sea_level_m(place.lon, place.lat);
        EXPECT_NEAR(static_cast<double>(channel(frame, "elevation.ellipsoid")[i]), place.height_m, 0.01);
        EXPECT_NEAR(static_cast<double>(channel(frame, "elevation.sea_level")[i]), place.height_m - sea_level_m, 0.01);
    }
    EXPECT_GT(seen, 1300);
}

// Of the ground, which stands still: its place as the cameras of the frames beside this one see it.
TEST(Layers, MotionLeadsToTheSamePlaceInTheFramesBeside) {
    const Frame& frame = sharp();
    int seen = 0;
    double farthest = 0.0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        if (!shows_only(frame, i, "terrain")) continue;
        ++seen;
        const Point<Scene> p = position(frame, i);
        const Camera::Seen now = camera().seen(p), next = camera().seen(p, 1), last = camera().seen(p, -1);
        EXPECT_NEAR(static_cast<double>(channel(frame, "forward.u")[i]), next.x - now.x, 2.0 * kMotionBound_px);
        EXPECT_NEAR(static_cast<double>(channel(frame, "forward.v")[i]), next.y - now.y, 2.0 * kMotionBound_px);
        EXPECT_NEAR(static_cast<double>(channel(frame, "backward.u")[i]), last.x - now.x, 2.0 * kMotionBound_px);
        EXPECT_NEAR(static_cast<double>(channel(frame, "backward.v")[i]), last.y - now.y, 2.0 * kMotionBound_px);
        farthest = std::max(farthest, std::hypot(next.x - now.x, next.y - now.y));
    }
    EXPECT_GT(seen, 700);
    EXPECT_GT(farthest, 1.4);
}

// The middle of what shows an object only.
std::array<double, 2> middle_of_object(const Frame& frame, std::string_view object) {
    double weight = 0.0, x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        for (const char* rank : {"00.r 00.g", "00.b 00.a"}) {
            const std::string name = rank;
            if (channel(frame, "CryptoObject" + name.substr(0, 4))[i] != cryptomatte_number(cryptomatte_id(object)))
                continue;
            const auto share = static_cast<double>(channel(frame, "CryptoObject" + name.substr(5))[i]);
            weight += share;
            x += share * static_cast<double>(i % HillShot::kWidth);
            y += share * static_cast<double>(i / HillShot::kWidth);
        }
    }
    return {x / weight, y / weight};
}

TEST(Layers, ABodysMotionIsItsOwnAndTheCameras) {
    const Frame next = hill().rendered({"layers=[cryptomatte]"}, "3");
    const Frame last = hill().rendered({"layers=[cryptomatte]"}, "1");
    const auto now = middle_of_object(blurred(), "slab");
    double forward = 0.0, backward = 0.0;
    int seen = 0;
    for (std::size_t i = 0; i < blurred().rgba.size(); ++i) {
        if (!shows_only(blurred(), i, "slab")) continue;
        ++seen;
        forward += static_cast<double>(channel(blurred(), "forward.u")[i]);
        backward += static_cast<double>(channel(blurred(), "backward.u")[i]);
    }
    EXPECT_GT(seen, 5);
    EXPECT_NEAR(forward / seen, middle_of_object(next, "slab")[0] - now[0], 0.05);
    EXPECT_NEAR(backward / seen, middle_of_object(last, "slab")[0] - now[0], 0.05);
}

// Ground far from the hill: a plane that falls to the south.
bool is_on_slope(const Frame& frame, std::size_t i) {
    constexpr double kTopLon = -105.5484, kTopLat = 37.5090;
    const double north_m = 111'000.0 * (static_cast<double>(channel(frame, "lat")[i]) - kTopLat);
    const double east_m = 88'300.0 * (static_cast<double>(channel(frame, "lon")[i]) - kTopLon);
    return shows_only(frame, i, "terrain") && std::hypot(north_m, east_m) > 1300.0;
}

TEST(Layers, SlopeAspectAndIncidenceAreThoseOfAPlane) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const double slope_deg = kDegrees * std::atan(0.5 * HillShot::kSlope);
    const Look& sun = hill().document().look.look;
    const double sun_height = sun.sun_elevation.radians(), from_fall = sun.sun_azimuth.radians() - std::numbers::pi;
    const double cosine = std::sin(sun_height) * std::cos(slope_deg / kDegrees) +
                          std::cos(sun_height) * std::sin(slope_deg / kDegrees) * std::cos(from_fall);
    int seen = 0;
    for (std::size_t i = 0; i < sharp().rgba.size(); ++i) {
        if (!is_on_slope(sharp(), i)) continue;
        ++seen;
        EXPECT_NEAR(static_cast<double>(channel(sharp(), "slope")[i]), slope_deg, 0.1);
        EXPECT_NEAR(static_cast<double>(channel(sharp(), "aspect")[i]), 180.0, 2.0);
        EXPECT_NEAR(static_cast<double>(channel(sharp(), "sun_incidence")[i]), kDegrees * std::acos(cosine), 0.2);
    }
    EXPECT_GT(seen, 40);
}

TEST(Layers, ObjectsAreSeenForTheirShareOfThePixel) {
    const Frame& frame = blurred();
    int mixed = 0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        double sum = 0.0;
        for (const char* rank : {"00.g", "00.a", "01.g", "01.a", "02.g", "02.a"})
            sum += static_cast<double>(channel(frame, std::string("CryptoObject") + rank)[i]);
        EXPECT_NEAR(sum, static_cast<double>(channel(frame, "coverage")[i]), 1e-5);
        EXPECT_EQ(channel(frame, "id")[i], channel(frame, "CryptoObject00.r")[i]);
        EXPECT_GE(channel(frame, "CryptoObject00.g")[i], channel(frame, "CryptoObject00.a")[i]);
        if (channel(frame, "CryptoObject00.a")[i] > 0.01F) ++mixed;
    }
    EXPECT_GT(mixed, 30);
    EXPECT_TRUE(std::ranges::any_of(std::views::iota(std::size_t{0}, frame.rgba.size()),
                                    [&](std::size_t i) { return shows_only(frame, i, "lake"); }));
}

// Left of the hill there is water, right of that what has no name; in the north nothing is known.
void write_classes() {
    std::ofstream(hill().folder() / "classes.asc") << "ncols 2\nnrows 2\nxllcorner 449600\nyllcorner 4149800\n"
                                                      "cellsize 1500\nNODATA_value -1\n-1 -1\n11 42\n";
    std::ofstream(hill().folder() / "classes.vrt")
        << "<VRTDataset rasterXSize='2' rasterYSize='2'><SRS>EPSG:32613</SRS>"
           "<GeoTransform>449600, 1500, 0, 4152800, 0, -1500</GeoTransform>"
           "<VRTRasterBand dataType='Int32' band='1'><NoDataValue>-1</NoDataValue><SimpleSource>"
           "<SourceFilename relativeToVRT='1'>classes.asc</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>";
}

TEST(Layers, ClassesOfTheGroundAreObjectsToo) {
    write_classes();
    const std::string raster = "classes.raster=" + (hill().folder() / "classes.vrt").string();
    const Frame frame = hill().rendered({raster, "classes.names={11: water}", "layers=[cryptomatte, lon, lat]",
                                         "sampling.tracer=discrete", "sampling.samples=1", "shutter.angle_deg=0"});
    // Where the classes meet, and within how much of it a sample may be of either.
    constexpr double kBorderLon = -105.5529, kBorderLat = 37.5070, kNear = 0.0006;
    std::map<std::string_view, int> seen;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
        const double east = static_cast<double>(channel(frame, "lon")[i]) - kBorderLon;
        const double north = static_cast<double>(channel(frame, "lat")[i]) - kBorderLat;
        if (shows_only(frame, i, "slab") || shows_only(frame, i, "lake") || std::abs(east) < kNear ||
            std::abs(north) < kNear || channel(frame, "CryptoObject00.g")[i] == 0.0F)
            continue;
        const std::string_view there = north > 0.0 ? "terrain" : east > 0.0 ? "42" : "water";
        EXPECT_TRUE(shows_only(frame, i, there)) << i << there;
        ++seen[there];
    }
    EXPECT_GT(seen["water"], 20);
    EXPECT_GT(seen["42"], 20);
    EXPECT_GT(seen["terrain"], 20);
}

// Root mean square difference of a channel, as a share of the values that it has.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += std::pow(static_cast<double>(a[i]) - static_cast<double>(b[i]), 2.0);
    const auto [least, most] = std::ranges::minmax(b);
    const double range = static_cast<double>(most) - static_cast<double>(least);
    return range > 0.0 ? std::sqrt(squares / static_cast<double>(a.size())) / range : 0.0;
}

// What is averaged over surfaces only is unstable where there is next to none.
std::vector<float> weighted(const Frame& frame, const std::string& name) {
    constexpr LayerSet kOfSurfaces = {Layer::Mean,     Layer::Normal,    Layer::Position, Layer::Longitude,
                                      Layer::Latitude, Layer::Elevation, Layer::Slope,    Layer::SunIncidence};
    std::vector<float> values = channel(frame, name);
    if (!kOfSurfaces.has(*layer_of_channel(name))) return values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] *= channel(frame, "coverage")[i];
    return values;
}

// Every layer but those that say how it was found.
void expect_the_mean_of_many_looks(const std::vector<std::string>& how, double bound) {
    std::vector<std::string> lines = how, looks = how;
    lines.insert(lines.end(), {"sampling.lines=12"});
    looks.insert(looks.end(), {"sampling.tracer=discrete", "sampling.samples=144"});
    const Frame by_lines = hill().rendered(lines), by_looks = hill().rendered(looks);
    for (const LayerChannel& c : by_looks.layers) {
        const Layer layer = *layer_of_channel(c.name);
        if (LayerSet{Layer::Range, Layer::Aspect, Layer::Id, Layer::Cryptomatte, Layer::Density, Layer::Cost}.has(
                layer))
            continue;
        const double off = difference(weighted(by_lines, c.name), weighted(by_looks, c.name));
        EXPECT_LT(off, bound) << c.name;
    }
}

TEST(Layers, AreTheMeanOfManyLooks) { expect_the_mean_of_many_looks({}, 0.003); }
TEST(Layers, AreTheMeanOfManyLooksThroughAWideFilter) {
    expect_the_mean_of_many_looks({"image.filter=mitchell", "shutter.shape=smooth", "sampling.drift_px=3"}, 0.01);
}

TEST(Layers, LeaveTheBeautyAsItIs) {
    for (const char* tracer : {"kinetic", "discrete"}) {
        const std::vector<std::string> how = {std::string("sampling.tracer=") + tracer, "sampling.samples=4",
                                              "layers=[]"};
        std::vector<std::string> with = how;
        with.back() = "layers=all";
        Frame all = hill().rendered(with);
        all.layers.clear();
        EXPECT_EQ(all, hill().rendered(how)) << tracer;
    }
}

TEST(Layers, AreTheSameWhicheverFramesAreRenderedTogether) { EXPECT_EQ(blurred(), hill().rendered({}, "1-3")); }

}  // namespace
}  // namespace overfly
