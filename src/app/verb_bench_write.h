#pragma once

#include "app/verbs.h"

namespace overfly {

// `overfly bench write`: what frames take in each compression.
RunVerb add_bench_write(CLI::App& bench);

}  // namespace overfly
