#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

#include "core/progress.h"

namespace overfly {

// What every verb is told.
struct CommonOptions {
    int threads = 0;  // 0: as many as the machine has
    bool quiet = false;
    bool json = false;
};

// Everything for people goes to standard error: news, and how far a job is. On a terminal progress is one line that is
// written over; elsewhere it is a plain line now and then.
class Console {
  public:
    explicit Console(const CommonOptions& options);

    void say(std::string_view line);
    void warn(std::string_view line);  // also when quiet
    // A sink for progress that this console must outlive.
    [[nodiscard]] Progress progress();

  private:
    using Clock = std::chrono::steady_clock;

    void show(std::string_view what, double done, double total);
    void clear_line();

    std::mutex mutex_;
    bool quiet_, terminal_, line_open_ = false;
    std::string job_;
    Clock::time_point job_start_, last_shown_;
    double job_start_done_ = 0.0;
};

}  // namespace overfly
