#pragma once

#include <functional>

#include "film/frame.h"

namespace overfly {

// Of the differences of red, green and blue of two pictures of one size, in linear light; of those pixels alone that
// `where` has, if it is given.
[[nodiscard]] double root_mean_square(const Frame& a, const Frame& b,
                                      const std::function<bool(int x, int y)>& where = {});

}  // namespace overfly
