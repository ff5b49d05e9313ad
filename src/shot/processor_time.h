#pragma once

#include <ctime>

namespace overfly {

// What this thread has used of a processor, in seconds: of this thread alone, so that a busy machine does not count.
[[nodiscard]] inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace overfly
