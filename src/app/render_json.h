#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shot/render_shot.h"

namespace overfly {

[[nodiscard]] nlohmann::ordered_json render_json(const RenderResult& result);
[[nodiscard]] nlohmann::ordered_json counters_json(const TraceCounters& counters);

}  // namespace overfly
