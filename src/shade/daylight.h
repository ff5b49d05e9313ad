#pragma once

#include <optional>

#include "core/colour.h"
#include "core/geometry.h"
#include "geo/frames.h"
#include "shade/air_views.h"
#include "shade/look.h"

namespace overfly {

// Sun, sky and haze over the scene. Light is in units in which white ground that faces a sun at the zenith is 2: a stop
// above that of a picture balanced for white, for terrain is dark. Horizontal ground is lit by exactly the sky that
// `background` shows.
class Daylight {
  public:
    explicit Daylight(const Look& look);

    // Towards the sun, a unit vector; the sun is so far that it is the same everywhere in the scene.
    [[nodiscard]] Vector<Scene> to_sun() const { return to_sun_; }
    // Irradiance of ground that faces the sun, and of level ground from the whole sky, divided by pi.
    [[nodiscard]] Rgb sun() const { return sun_; }
    [[nodiscard]] Rgb sky() const { return sky_; }

    // What is seen along a unit direction where there is no ground. `up` is the camera's own.
    [[nodiscard]] Rgb background(Vector<Scene> direction, Vector<Scene> up) const;

    // A view of `behind` through `distance_m` of air, between two heights above the scene's lowest ground. Haze tends
    // to the sky's colour at the horizon in that direction; along a level path at height 0 it leaves 2 % of the green
    // light at the distance of the visibility.
    struct AirPath {
        double distance_m = 0.0;
        double from_height_m = 0.0, to_height_m = 0.0;
    };
    [[nodiscard]] Rgb through_air(Rgb behind, const AirPath& path, Vector<Scene> direction) const;
    // The same in parts: the share of what is behind that comes through, and the light that the air adds.
    struct AirShare {
        Rgb left{1.0F, 1.0F, 1.0F}, haze;
    };
    [[nodiscard]] AirShare share_of_air(const AirPath& path, Vector<Scene> direction) const;
    // What many such views have in common (look_through).
    [[nodiscard]] const Air& air() const { return air_; }
    // Of the background straight up; it changes to the horizon's by 1/e in kSkyRise, a sine of elevation.
    [[nodiscard]] Rgb zenith() const { return zenith_; }
    static constexpr float kSkyRise = 0.20F;

  private:
    [[nodiscard]] Rgb horizon(Vector<Scene> direction) const;

    Vector<Scene> to_sun_;
    Rgb sun_, sky_, zenith_;
    Air air_;
};

inline constexpr double kEarthRadius_m = 6'371'008.8;  // mean radius (IUGG)

// Up at a place of the scene: away from the middle of an Earth that is a ball. For skies, not for geodesy.
[[nodiscard]] Vector<Scene> up_at(Point<Scene> p);
// Height above that ball, in metres.
[[nodiscard]] double height_over_ball_m(Point<Scene> p);
// How far a view from p along a unit direction is from the surface `height_m` above that ball, if it meets it.
// REQUIRES: p is above that surface.
[[nodiscard]] std::optional<double> distance_to_ball_m(Point<Scene> p, Vector<Scene> direction, double height_m);

}  // namespace overfly
