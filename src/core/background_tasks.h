#pragma once

#include <functional>
#include <memory>

namespace overfly {

// Work beside whatever else goes on: threads of the limit (parallel.h) that are idle take it, and so does the caller
// while it waits; no thread is added for it. Where one thread is allowed, run() is the task itself.
class BackgroundTasks {
  public:
    BackgroundTasks();
    ~BackgroundTasks();  // waits
    BackgroundTasks(const BackgroundTasks&) = delete;
    BackgroundTasks& operator=(const BackgroundTasks&) = delete;

    // REQUIRES: the task throws nothing.
    void run(std::function<void()> task);
    // Until all have ended.
    void wait();

  private:
    struct Group;
    std::unique_ptr<Group> group_;
};

}  // namespace overfly
