#include "app/stop_signal.h"

#include <csignal>

namespace overfly {
namespace {

// The only kind of object that a signal handler may write to.
volatile std::sig_atomic_t stop_asked = 0;

extern "C" void ask_to_stop(int signal) {
    stop_asked = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_stop_signals() {
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
}

bool stop_was_asked() { return stop_asked != 0; }

}  // namespace overfly
