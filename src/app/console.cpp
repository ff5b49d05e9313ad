#include "app/console.h"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace overfly {
namespace {

constexpr double kTerminalEvery_s = 0.1;
constexpr double kPlainEvery_s = 5.0;

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

std::string clock_text(double s) {
    const long whole = std::lround(s);
    return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

}  // namespace

void print_to_stderr(std::string_view text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));  // unbuffered
}

Console::Console(const CommonOptions& options)
    : quiet_(options.quiet), json_(options.json), terminal_(isatty(STDERR_FILENO) == 1) {}

Console::~Console() { clear_line(); }

void Console::say(std::string_view line) {
    if (!quiet_) warn(line);
}

void Console::warn(std::string_view line) {
    const std::scoped_lock lock(mutex_);
    clear_line();
    print_to_stderr(fmt::format("{}\n", line));
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
    const std::string line = progress_line(done, total, now);
    if (terminal_) {
        print_to_stderr("\r\033[K" + line);
        line_open_ = true;
    } else {
        print_to_stderr(fmt::format("{}\n", line));
    }
}

std::string Console::progress_line(double done, double total, Clock::time_point now) const {
    if (total <= 0.0) return job_;
    const bool is_frames = job_ == "rendering";
    std::string line = job_ + (is_frames ? fmt::format(": frame {:.0f} of {:.0f}", done, total)
                                         : fmt::format(": {:.0f} %", 100.0 * done / total));
    const double spent_s = seconds_between(job_start_, now);
    const double speed = spent_s > 0.0 ? (done - job_start_done_) / spent_s : 0.0;
    if (speed > 0.0 && is_frames) line += fmt::format(", {:.2f} frames/s", speed);
    if (speed > 0.0 && done < total) line += fmt::format(", {} left", clock_text((total - done) / speed));
    return line;
}

void Console::result(const std::string& text, const nlohmann::ordered_json& json) {
    std::string out = text;
    // File names may hold bytes that are no UTF-8, which JSON does not have.
    if (json_) out = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
    if (out.empty() || (quiet_ && !json_)) return;
    const bool is_written = std::fwrite(out.data(), 1, out.size(), stdout) == out.size() && std::fflush(stdout) == 0;
    if (!is_written) {
        throw UserError(Place{},
                        fmt::format("standard output: can't be written: {}", std::generic_category().message(errno)));
    }
}

void Console::clear_line() {
    if (!line_open_) return;
    print_to_stderr("\r\033[K");
    line_open_ = false;
}

}  // namespace overfly
