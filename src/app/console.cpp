#include "app/console.h"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

namespace overfly {
namespace {

constexpr double kTerminalEvery_s = 0.1;
constexpr double kPlainEvery_s = 5.0;

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

std::string clock_text(double s) {
    const auto whole = static_cast<long>(s + 0.5);
    return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

}  // namespace

Console::Console(const CommonOptions& options) : quiet_(options.quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void Console::say(std::string_view line) {
    if (!quiet_) warn(line);
}

void Console::warn(std::string_view line) {
    const std::scoped_lock lock(mutex_);
    clear_line();
    fmt::print(stderr, "{}\n", line);
}

Progress Console::progress() {
    if (quiet_) return {};
    return [this](std::string_view what, double done, double total) { show(what, done, total); };
}

void Console::show(std::string_view what, double done, double total) {
    const std::scoped_lock lock(mutex_);
    const Clock::time_point now = Clock::now();
    const bool is_new = job_ != what;
    if (is_new) {
        job_ = what;
        job_start_ = now;
        job_start_done_ = done;
        last_shown_ = now;
        if (!terminal_) return;
    }
    const bool is_end = total > 0.0 && done >= total;
    if (!is_new && !is_end && seconds_between(last_shown_, now) < (terminal_ ? kTerminalEvery_s : kPlainEvery_s))
        return;
    if (is_end && !terminal_ && seconds_between(job_start_, now) < kPlainEvery_s) return;
    last_shown_ = now;
    std::string line = job_;
    if (total > 0.0) {
        const bool frames = what == "rendering";
        line += frames ? fmt::format(": frame {:.0f} of {:.0f}", done, total)
                       : fmt::format(": {:.0f} %", 100.0 * done / total);
        const double spent_s = seconds_between(job_start_, now);
        const double speed = spent_s > 0.0 ? (done - job_start_done_) / spent_s : 0.0;
        if (speed > 0.0 && frames) line += fmt::format(", {:.2f} frames/s", speed);
        if (speed > 0.0 && !is_end) line += fmt::format(", {} left", clock_text((total - done) / speed));
    }
    if (terminal_) {
        fmt::print(stderr, "\r\033[K{}", line);
        std::fflush(stderr);
        line_open_ = true;
    } else {
        fmt::print(stderr, "{}\n", line);
    }
}

void Console::clear_line() {
    if (!line_open_) return;
    fmt::print(stderr, "\r\033[K");
    line_open_ = false;
}

}  // namespace overfly
