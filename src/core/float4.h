#pragma once

#include <cstdint>

namespace overfly {

// Four numbers for one vector instruction: GCC's and Clang's vector extension, which needs no particular processor.
using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;

}  // namespace overfly
