#pragma once

namespace overfly {

// From the call on, Ctrl-C and SIGTERM ask the program to stop instead of ending it; a second one ends it.
void catch_stop_signals();

// Whether one has come.
[[nodiscard]] bool stop_was_asked();

}  // namespace overfly
