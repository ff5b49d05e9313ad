#include "config/range.h"

#include <fmt/format.h>

namespace overfly::config {

std::string Range::text() const {
    return low_allowed ? fmt::format("{} to {}", low, high) : fmt::format("above {}, up to {}", low, high);
}

}  // namespace overfly::config
