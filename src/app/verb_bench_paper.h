#pragma once

#include "app/verbs.h"

namespace overfly {

// `overfly bench paper`: the paper's table, measured again.
RunVerb add_bench_paper(CLI::App& bench);

}  // namespace overfly
