#pragma once

#include "core/colour.h"
#include "core/geometry.h"
#include "geo/frames.h"
#include "shade/daylight.h"

namespace overfly {

// How the surface of a body looks: the same all over.
struct BodyLook {
    Rgb colour = {0.5F, 0.5F, 0.5F};  // albedo
    double mirror = 0.0;              // share of light from straight ahead that it mirrors; 0: no mirror
};

// Where light meets a surface. Unit vectors in one frame, whichever; `normal` on the viewer's side.
struct Incidence {
    Vector<Scene> normal, to_sun, up;
};

// What a matt surface of this albedo sends to every side: light of the sun, if nothing stands before it, and that of
// the part of the sky that it faces and of the ground below.
struct MattLight {
    Rgb sun, around;
};
[[nodiscard]] MattLight matt_light(Rgb albedo, const Incidence& at, const Daylight& day);

// The share of light that a surface mirrors at an angle with this cosine: all of it at grazing (Schlick 1994).
[[nodiscard]] double mirrored_share(double share_straight, double cos_to_normal);

}  // namespace overfly
