#pragma once

#include <thread>

namespace overfly {

// While it lives, Ctrl-C and SIGTERM ask the program to stop instead of ending it; a second one ends it.
// GUARANTEES: the program has ended kPatience_s after it was asked to. What is being done (a library that reads a large
// raster can't be asked) is then given up where it is: unfinished files are removed, and the program ends as one that
// stopped by itself.
class StopSignals {
  public:
    static constexpr double kPatience_s = 3.0;  // of the five seconds that we promise; the rest is for a busy machine

    StopSignals();

  private:
    std::jthread deadline_;
};

// Whether one has come.
[[nodiscard]] bool stop_was_asked();

// Says how a stopped run ends, and returns its exit code.
[[nodiscard]] int tell_stopped();

}  // namespace overfly
