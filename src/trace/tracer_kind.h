#pragma once

namespace overfly {

// The ways to find out which polygon is seen when (tracer.h).
enum class TracerKind { Discrete, Interval };

}  // namespace overfly
