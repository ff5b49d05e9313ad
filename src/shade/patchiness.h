#pragma once

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

// How irregularly plants and snow end: a smooth random surface between -1 and 1 over east and north, the same for ever,
// with patches of about 200 and 700 m. Nothing measured, so only for colours that are none either.
[[nodiscard]] float patchiness(Point<Scene> p);

}  // namespace overfly
