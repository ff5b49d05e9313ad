#pragma once

#include <variant>

#include "trace/discrete_shadow.h"
#include "trace/shadow_tracer.h"

namespace overfly {

// The ways to answer "when does this surface stand before the sun", behind one call.
using SunBlocker = std::variant<DiscreteShadowTracer, ShadowTracer>;

inline void trace(const SunBlocker& blocker, const MotionPiece& motion, std::span<const ShadowQuery> queries,
                  ShadowLists& out, TraceCounters& counters) {
    std::visit([&](const auto& b) { b.trace(motion, queries, out, counters); }, blocker);
}

}  // namespace overfly
