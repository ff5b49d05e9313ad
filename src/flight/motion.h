#pragma once

#include <span>
#include <vector>

#include "core/time_range.h"
#include "flight/camera_path.h"
#include "flight/shutter.h"
#include "flight/view.h"

namespace overfly {

// The inversion (design 3.1; Chapman, Calvert and Dill 1991, section 4): instead of the polygons, the ray of an image
// sample moves, by polynomials in time.
//
// A quadratic vector of u, the time within a piece scaled to [0, 1]:  c0 + c1 u + c2 u^2.
struct QuadraticVector {
    Vector<Scene> c0, c1, c2;

    [[nodiscard]] constexpr Vector<Scene> at(double u) const { return c0 + u * (c1 + u * c2); }
};

// One stretch of the flight on which the camera is quadratic, in the frame of what it looks at (view.h). The ray of the
// film point (x, y) starts at `reference` + origin(u) and runs along x * right(u) + y * down(u) + view(u). Film
// coordinates: x from -1 at the left edge to +1 at the right edge of the picture, y downward on the same scale with 0
// at the middle row. right and down are as long as the tangent of half the field of view, view is a unit vector, up to
// the bound of the fit; the ray's parameter is therefore the planar depth in metres.
struct MotionPiece {
    TimeRange when;
    Point<Scene> reference;
    QuadraticVector origin;  // small numbers: relative to reference
    QuadraticVector right, down, view;
    QuadraticVector to_sun{};  // a unit vector up to the bound of the fit; zero where it wasn't asked for

    [[nodiscard]] constexpr double u_at(double time_s) const { return (time_s - when.begin_s) / when.duration_s(); }
    [[nodiscard]] constexpr double time_at(double u) const { return when.begin_s + u * when.duration_s(); }
    [[nodiscard]] constexpr Point<Scene> origin_at(double u) const { return reference + origin.at(u); }
    [[nodiscard]] constexpr Vector<Scene> direction_at(double u, double x, double y) const {
        return x * right.at(u) + y * down.at(u) + view.at(u);
    }
};

struct MotionOptions {
    double bound_px = 0.01;  // how far a ground point's image may be from where the exact path puts it
    int width_px = 960;      // of the picture: what a pixel is
    int height_px = 540;
    double longest_piece_s = 1.0 / 3.0;
    // Where joints are welcome: at every period_s from about_s on, as far as there is such a time between two cuts.
    // Between two exposures, they spare work: what is exposed while a joint passes is traced twice. 0: anywhere.
    struct Gaps {
        double about_s = 0.0, period_s = 0.0;
    };
    Gaps gaps{};
    std::vector<double> cuts_s{};  // ascending: where joints have to be, beside those of the path
};

// The whole flight in pieces that follow each other without gap. Which pieces there are depends on the flight and the
// options alone, never on the frames asked for.
struct Motion {
    std::vector<MotionPiece> pieces;
    double bound_px = 0.0;          // that was asked for
    double largest_error_px = 0.0;  // found while fitting, at the densest set of times looked at

    [[nodiscard]] TimeRange times() const { return {pieces.front().when.begin_s, pieces.back().when.end_s}; }
    // The piece that a time lies in; of two at a joint, the later. Times outside belong to the first or the last piece.
    [[nodiscard]] const MotionPiece& piece_at(double time_s) const;
    // The pieces that overlap a time range.
    [[nodiscard]] std::span<const MotionPiece> pieces_over(TimeRange when) const;
};

// Fits quadratics between every two of `cuts_s`, halving until the bound holds: what the view looks at is, within its
// reach, imaged within bound_px of where the exact rays put it, anywhere in the picture; and a shadow that the sun
// draws on it as far away as the camera is moves by no more than that. REQUIRES: cuts_s ascending, at least two; all
// options positive. GUARANTEES: a joint at every cut; continuous there (equal up to rounding). The error is measured in
// closed form at 24 times of each piece and 25 film points, and must there be below 0.7 of the bound. Two exceptions:
// what is nearer than 1 cm, and the 10 microseconds in which a camera turns over that flies straight over its target;
// then largest_error_px exceeds bound_px.
[[nodiscard]] Motion fit_motion(const View& view, std::span<const double> cuts_s, const MotionOptions& options);

// The same for the camera over the ground, over `when`, which may reach beyond the path's own times; cut at the path's
// joints, at the options' cuts and into pieces no longer than the options say, but for half a period of the gaps.
// REQUIRES: when lasts for some time.
[[nodiscard]] Motion fit_motion(const CameraPath& path, TimeRange when, const Surroundings& surroundings,
                                const MotionOptions& options);

}  // namespace overfly
