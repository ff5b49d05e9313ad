#pragma once

#include <string>
#include <vector>

namespace overfly {

// The frame numbers that a shot has, both ends included. REQUIRES: first <= last.
struct FrameSpan {
    int first = 1, last = 1;
};

// Reads a choice of frames: numbers and ranges separated by commas, a range with a step after `:` or `x`:
// `5`, `10-20`, `1-100:5`, `1-100x5`, `1,5,10-12`.
// GUARANTEES: at least one frame, rising, none twice, all within `available`.
// Throws UserError with every part that is malformed, empty (`20-10`) or outside.
[[nodiscard]] std::vector<int> parse_frame_range(const std::string& text, FrameSpan available);

}  // namespace overfly
