#include "core/background_tasks.h"

#include <utility>

#include <oneapi/tbb/task_group.h>

#include "core/parallel.h"

namespace overfly {

struct BackgroundTasks::Group {
    tbb::task_group tasks;
};

BackgroundTasks::BackgroundTasks() : group_(std::make_unique<Group>()) {}
BackgroundTasks::~BackgroundTasks() { wait(); }

void BackgroundTasks::run(std::function<void()> task) {
    // Nobody would take it before the caller waits.
    if (thread_limit() == 1) return task();
    group_->tasks.run(std::move(task));
}

void BackgroundTasks::wait() { group_->tasks.wait(); }

}  // namespace overfly
