#include <gtest/gtest.h>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;

std::vector<BodyDocument> bodies_of(const std::vector<std::string>& overrides = {}) {
    return read_shot_document(good_folder / "shot.yaml", overrides).bodies;
}

std::string refusal(const std::vector<std::string>& overrides) {
    return error_text([&] { (void)bodies_of(overrides); });
}

TEST(ReadBodies, ReadsPolygonsAndPolynomials) {
    const BodyDocument body = bodies_of().at(0);
    EXPECT_EQ(body.name, "kite");
    const std::vector<Polygon> polygons = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}},
                                           {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}};
    EXPECT_EQ(body.shape, BodyShape(polygons));
    const BodyPolynomials motion{
        .place = {Angle::degrees(-105.5), Angle::degrees(37.6), 120.0, HeightAbove::Ground},
        .east_m = {{1, -2.5, 3e-2}},
        .north_m = {{7}},
        .up_m = {{0, 1, 2, 3, 4, 5, 6, 7, 8}},
        .heading_deg = {{0, 90}},
        .pitch_deg = {{5}},
        .roll_deg = {{-3}},
    };
    EXPECT_EQ(body.motion, BodyMotion(motion));
    EXPECT_EQ(body.albedo, (Rgb{0.8F, 0.2F, 0.1F}));
    EXPECT_EQ(body.mirror, 0.0);
    EXPECT_FALSE(body.shadow);
    EXPECT_EQ(body.places.body.file, good_folder / "shot.yaml");
    EXPECT_GT(body.places.body.line, 1);
}

TEST(ReadBodies, ReadsAMeshAndTheFlightThatItFollows) {
    const BodyDocument body = bodies_of().at(1);
    EXPECT_EQ(body.shape, BodyShape(MeshSource{good_folder / "triangle.obj", 0.3048, UpAxis::Y}));
    const FlightDocument flight = read_flight_document(good_folder / "flight.yaml");
    EXPECT_EQ(body.motion, BodyMotion(BodyFlight{flight.keyframes, -0.5}));
    EXPECT_EQ(body.flight_file, flight.file);
    ASSERT_EQ(body.places.keyframes.size(), flight.places.size());
    EXPECT_EQ(body.places.keyframes[2].line, flight.places[2].line);
    EXPECT_EQ(body.albedo, (Rgb{0.5F, 0.5F, 0.5F}));
    EXPECT_TRUE(body.shadow);
}

TEST(ReadBodies, PutsAnOutlinesBodyIntoItsMiddle) {
    const BodyDocument body = bodies_of().at(3);
    const auto& outline = std::get<Outline>(body.shape);
    ASSERT_EQ(outline.size(), 3U);
    EXPECT_EQ(outline[2], (LonLat{Angle::degrees(-105.515), Angle::degrees(37.58)}));
    const LonLat middle = middle_of(outline);
    EXPECT_EQ(body.motion, BodyMotion(BodyPolynomials{.place = {middle.lon, middle.lat, 3600.0, HeightAbove::Ellipsoid},
                                                      .east_m = {},
                                                      .north_m = {},
                                                      .up_m = {},
                                                      .heading_deg = {},
                                                      .pitch_deg = {},
                                                      .roll_deg = {}}));
    EXPECT_EQ(body.mirror, 0.25);
}

TEST(ReadBodies, AllowsAMirrorOfSeveralPolygonsInOnePlane) { EXPECT_EQ(bodies_of().at(2).mirror, 1.0); }

TEST(ReadBodies, TakesOverrides) {
    EXPECT_TRUE(bodies_of({"bodies=[]"}).empty());
    EXPECT_TRUE(bodies_of({"bodies="}).empty());
    EXPECT_EQ(bodies_of({"bodies.0.name=other"}).at(0).name, "other");
    const auto kite = std::get<BodyPolynomials>(bodies_of({"bodies.0.east_m.1=9"}).at(0).motion);
    EXPECT_EQ(kite.east_m.coefficients, (std::vector<double>{1, 9, 3e-2}));
    const auto shape = bodies_of({"bodies.0.polygons.1.2=[0, 2, 0]"}).at(0).shape;
    EXPECT_EQ(std::get<std::vector<Polygon>>(shape)[1][2], (Point<Scene>{0, 2, 0}));
    EXPECT_EQ(refusal({"bodies.0.mirror=2"}), "--set bodies.0.mirror=2: bodies.0.mirror: got 2, allowed 0 to 1");
    EXPECT_EQ(refusal({"bodies.4.mirror=1"}), "--set bodies.4.mirror=1: bodies: got item '4', allowed 0 to 3");
}

TEST(ReadBodies, TakesOverridesOfTheFlightsThatBodiesFollow) {
    const auto time_s = [](const BodyDocument& body) { return std::get<BodyFlight>(body.motion).keyframes[1].time_s; };
    const ShotDocument shot =
        read_shot_document(good_folder / "shot.yaml", std::vector<std::string>{"bodies.1.flight.keyframes.1.time_s=3"});
    EXPECT_EQ(time_s(shot.bodies[1]), 3.0);
    EXPECT_EQ(shot.flight.keyframes[1].time_s, 2.5) << "the camera's flight is another reading of the file";
    EXPECT_EQ(time_s(bodies_of({"flight.keyframes.1.time_s=3"})[1]), 2.5);

    const TemporaryFolder folder;
    const auto other = folder.write("other.yaml", text_of(good_folder / "flight.yaml"));
    EXPECT_EQ(bodies_of({"bodies.1.flight=" + other.string()}).at(1).flight_file, other);
    EXPECT_EQ(refusal({"bodies.0.flight.keyframes.1.time_s=3"}),
              "--set bodies.0.flight.keyframes.1.time_s=3: bodies: got '0', allowed the index of a body that follows a "
              "flight");
    EXPECT_EQ(refusal({"bodies.1.flight.keyframes.9.time_s=3"}),
              "--set bodies.1.flight.keyframes.9.time_s=3: keyframes: got item '9', allowed 0 to 2");
}

TEST(ReadBodies, ReadsTheShotsOfTheRepository) {
    for (const auto& file : std::filesystem::directory_iterator(source_folder / "configs")) {
        if (file.path().extension() != ".yaml" || document_kind(file) != DocumentKind::Shot) continue;
        EXPECT_EQ(error_text([&] { (void)read_shot_document(file); }), "no error") << file.path();
    }
}

}  // namespace
}  // namespace overfly
