#pragma once

#include <functional>
#include <string>

#include "app/console.h"

namespace CLI {
class App;
}

namespace overfly {

// A verb adds its own command line to the program's, and answers what to run when it is chosen: a function that returns
// the program's exit code.
using RunVerb = std::function<int(const CommonOptions&)>;
using AddVerb = RunVerb (*)(CLI::App& verb);

RunVerb add_import(CLI::App& verb);
RunVerb add_path(CLI::App& verb);
RunVerb add_render(CLI::App& verb);
RunVerb add_batch(CLI::App& verb);
RunVerb add_bench(CLI::App& verb);
RunVerb add_timeline(CLI::App& verb);
RunVerb add_verify(CLI::App& verb);
RunVerb add_info(CLI::App& verb);

// Exit codes.
inline constexpr int kDone = 0;
inline constexpr int kOurFault = 1;
inline constexpr int kUserCanFix = 2;
inline constexpr int kInterrupted = 130;  // as shells say of a program that Ctrl-C ended

}  // namespace overfly
