#include "config/flight_place.h"

namespace overfly::config {

void read_height_above(Section& section, HeightAbove& above) {
    static constexpr NamedValue<HeightAbove> kWords[] = {
        {"ground", HeightAbove::Ground}, {"sea_level", HeightAbove::SeaLevel}, {"ellipsoid", HeightAbove::Ellipsoid}};
    section.read("height_above", above, kWords);
}

FlightPlace read_place(Section& section, HeightAbove above) {
    FlightPlace place{.lon = {}, .lat = {}, .height_m = 0.0, .above = above};
    section.require({"lon_deg", "lat_deg", "height_m"});
    section.read("lon_deg", place.lon, {-360, 360});
    section.read("lat_deg", place.lat, {-90, 90});
    section.read("height_m", place.height_m, kHeight_m);
    read_height_above(section, place.above);
    return place;
}

}  // namespace overfly::config
