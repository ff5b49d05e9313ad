#pragma once

#include <exception>
#include <string>

namespace overfly {

// What is said of a file that ends too early, and of nothing else.
inline constexpr const char* kCutOff = "it is cut off";

// What OpenEXR says is wrong with a file that it reads, without the file's name, which whoever reports it says anyway.
[[nodiscard]] std::string exr_complaint(const std::exception& error);

}  // namespace overfly
