#include "flight/resolve_place.h"

namespace overfly {
namespace {

std::optional<double> datum_height_m(const FlightPlace& place, const Surroundings& surroundings) {
    switch (place.above) {
        case HeightAbove::Ground:
            return surroundings.ground_height_m(place.lon, place.lat);
        case HeightAbove::SeaLevel:
            return surroundings.sea_level_m(place.lon, place.lat);
        case HeightAbove::Ellipsoid:
            break;
    }
    return 0.0;
}

}  // namespace

std::optional<Geodetic> resolve_place(const FlightPlace& place, const Surroundings& surroundings) {
    const std::optional<double> datum_m = datum_height_m(place, surroundings);
    if (!datum_m) return std::nullopt;
    return Geodetic{place.lon, place.lat, *datum_m + place.height_m};
}

}  // namespace overfly
