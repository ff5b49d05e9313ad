#pragma once

namespace overfly {

// The ways to find out which polygon is seen when (tracer.h).
enum class TracerKind {
    Discrete,
    Interval,
    Kinetic,
    Hybrid  // either, tile by tile: whichever is expected to cost less (shot/tile_choice.h)
};

}  // namespace overfly
