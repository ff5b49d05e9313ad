#pragma once

#include <functional>
#include <string_view>

namespace overfly {

// Told how far a long job is: what it is doing, done out of total (total 0: not known). Called often and from one
// thread at a time; must be cheap.
using Progress = std::function<void(std::string_view what, double done, double total)>;

}  // namespace overfly
