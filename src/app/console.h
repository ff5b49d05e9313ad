#pragma once

#include <chrono>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"

namespace overfly {

// What every verb is told.
struct CommonOptions {
    int threads = 0;  // 0: as many as the machine has
    bool quiet = false;
    bool json = false;
    std::vector<std::string> command;  // what was typed, the program's name first and without its folder
};

// Writes to standard error, and goes on where that fails: a log on a full disk must not end a render.
void print_to_stderr(std::string_view text);

// Standard output has the result of a verb and nothing else. Everything else for people goes to standard error: news,
// and how far a job is. On a terminal progress is one line that is written over; elsewhere it is a plain line now and
// then.
class Console {
  public:
    explicit Console(const CommonOptions& options);
    ~Console();  // what is printed next begins on a line of its own
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void say(std::string_view line);
    void warn(std::string_view line);  // also when quiet
    // A sink for progress that this console must outlive.
    [[nodiscard]] Progress progress();
    // The result: JSON where that was asked for, else the text, unless quiet. Throws UserError when standard output
    // does not take it.
    void result(const std::string& text, const nlohmann::ordered_json& json);

  private:
    using Clock = std::chrono::steady_clock;

    void show(std::string_view what, double done, double total);
    [[nodiscard]] std::string progress_line(double done, double total, Clock::time_point now) const;
    void clear_line();

    std::mutex mutex_;
    bool quiet_, json_, terminal_, line_open_ = false;
    std::string job_;
    Clock::time_point job_start_, last_shown_;
    double job_start_done_ = 0.0;
};

}  // namespace overfly
