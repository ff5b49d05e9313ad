#pragma once

#include <functional>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

// Whether ground stands in the way from a point along a direction. Called from many threads at once.
using IsBlocked = std::function<bool(Point<Scene> from, Vector<Scene> direction)>;

}  // namespace overfly
