#pragma once

#include <exception>
#include <functional>

namespace overfly {

// Asked often during a long job; true once the user wants it to end.
using ShouldStop = std::function<bool()>;

// Thrown when a job ends because the user asked for it. Everything finished before is complete on disk.
class Interrupted : public std::exception {
  public:
    [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

}  // namespace overfly
