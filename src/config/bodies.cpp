#include "config/bodies.h"

#include <algorithm>
#include <array>
#include <utility>

#include "config/body_shape.h"
#include "config/flight_place.h"
#include "config/number_lists.h"

namespace overfly::config {
namespace {

// Degree 8: what can still be told from rounding over the seconds of a shot.
constexpr std::size_t kMostCoefficients = 9;
constexpr Range kDistance_m{-10'000'000, 10'000'000};
// A propeller at 2,400 revolutions a minute turns by 14,400 degrees a second.
constexpr Range kAngle_deg{-100'000, 100'000};
constexpr Range kDelay_s{-1'000'000, 1'000'000};

struct PolynomialKey {
    const char* key;
    TimePolynomial BodyPolynomials::*value;
    Range range;
};

constexpr PolynomialKey kPolynomials[] = {
    {"east_m", &BodyPolynomials::east_m, kDistance_m},      {"north_m", &BodyPolynomials::north_m, kDistance_m},
    {"up_m", &BodyPolynomials::up_m, kDistance_m},          {"heading_deg", &BodyPolynomials::heading_deg, kAngle_deg},
    {"pitch_deg", &BodyPolynomials::pitch_deg, kAngle_deg}, {"roll_deg", &BodyPolynomials::roll_deg, kAngle_deg}};

bool is_name(const std::string& text) {
    return std::ranges::all_of(text, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
}

void read_name(Section& section, BodyDocument& body, const std::vector<BodyDocument>& before) {
    static constexpr const char* kAllowed = "a name of letters, digits, '_' and '-'";
    section.require({"name"});
    if (!section.read("name", body.name, kAllowed)) return;
    if (!is_name(body.name)) section.refuse("name", kAllowed);
    if (std::ranges::find(before, body.name, &BodyDocument::name) != before.end())
        section.refuse("name", "a name that no body before it has");
}

void read_polynomial(Section& section, const PolynomialKey& polynomial, BodyPolynomials& motion) {
    section.read_node(polynomial.key, [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
        auto coefficients = number_or_numbers_of(node, path, polynomial.range, kMostCoefficients, problems);
        if (coefficients) (motion.*polynomial.value).coefficients = std::move(*coefficients);
    });
}

// Notes every key of a motion that the body can't have.
void refuse_motion(Section& section, const char* allowed) {
    for (const PolynomialKey& polynomial : kPolynomials) section.refuse(polynomial.key, allowed);
}

// Asks for all keys, whatever there is: they become known.
void read_motion(Section& section, BodyDocument& body) {
    BodyPolynomials polynomials;
    BodyFlight flight;
    const bool has_place =
        section.section("place", [&](Section& place) { polynomials.place = read_place(place, HeightAbove::SeaLevel); });
    for (const PolynomialKey& polynomial : kPolynomials) read_polynomial(section, polynomial, polynomials);
    section.read("flight", body.flight_file, PathTo::File);
    section.read("delay_s", flight.delay_s, kDelay_s);
    const bool has_flight = section.has("flight");

    if (section.has("outline")) {
        static constexpr const char* kAtRest = "nothing that moves it: the body of an outline lies where that is";
        for (const char* key : {"place", "flight", "delay_s"}) section.refuse(key, kAtRest);
        return refuse_motion(section, kAtRest);
    }
    section.allow_one_of("place", "flight");
    if (!has_place) refuse_motion(section, "only with 'place'");
    if (!has_flight) section.refuse("delay_s", "only with 'flight'");
    if (!has_place && !has_flight) section.problem("got no motion, allowed one of 'place', 'flight'");
    if (has_flight) {
        body.motion = std::move(flight);
    } else {
        body.motion = std::move(polynomials);
    }
}

void read_colour(Section& section, Rgb& albedo) {
    static constexpr Range kShare{0, 1};
    static constexpr std::array kRanges{kShare, kShare, kShare};
    section.read_node("colour", [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
        const auto rgb = numbers_of(node, path, kRanges, "3 numbers [red, green, blue]", problems);
        if (rgb) albedo = {static_cast<float>((*rgb)[0]), static_cast<float>((*rgb)[1]), static_cast<float>((*rgb)[2])};
    });
}

}  // namespace

void read_bodies(Section& document, std::vector<BodyDocument>& bodies) {
    document.each("bodies", Section::Empty::Allowed, [&](Section& item) {
        BodyDocument body;
        body.places.body = item.place();
        read_name(item, body, bodies);
        read_colour(item, body.albedo);
        item.read("mirror", body.mirror, {0, 1});
        item.read("shadow", body.shadow);
        read_motion(item, body);
        read_body_shape(item, body);
        bodies.push_back(std::move(body));
    });
}

}  // namespace overfly::config
