#include "app/stop_signal.h"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <stop_token>

#include "app/console.h"
#include "app/verbs.h"
#include "io/temporary_file.h"

namespace overfly {
namespace {

// The only kind of object that a signal handler may write to.
volatile std::sig_atomic_t stop_asked = 0;

extern "C" void ask_to_stop(int signal) {
    stop_asked = 1;
    std::signal(signal, SIG_DFL);
}

// Sleeps, and returns whether the program still has not ended.
bool is_still_running_after(std::chrono::duration<double> time, const std::stop_token& ended) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any never;
    never.wait_for(lock, ended, time, [] { return false; });
    return !ended.stop_requested();
}

// A signal handler can wake nobody, hence the looking.
void end_when_late(const std::stop_token& ended) {
    constexpr std::chrono::milliseconds kLookEvery{50};
    while (!stop_was_asked()) {
        if (!is_still_running_after(kLookEvery, ended)) return;
    }
    if (!is_still_running_after(std::chrono::duration<double>(StopSignals::kPatience_s), ended)) return;
    remove_unfinished_files();
    if (isatty(STDERR_FILENO) == 1) print_to_stderr("\r\033[K");  // the line of progress
    std::_Exit(tell_stopped());
}

}  // namespace

StopSignals::StopSignals() : deadline_(end_when_late) {
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
}

bool stop_was_asked() { return stop_asked != 0; }

int tell_stopped() {
    print_to_stderr("stopped; what was finished is complete, and a second run goes on from there\n");
    return kInterrupted;
}

}  // namespace overfly
