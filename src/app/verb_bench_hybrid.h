#pragma once

#include "app/verbs.h"

namespace overfly {

// `overfly bench hybrid`: the hybrid beside the two tracers that it chooses from.
RunVerb add_bench_hybrid(CLI::App& bench);

}  // namespace overfly
