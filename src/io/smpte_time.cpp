#include "io/smpte_time.h"

#include <cstdint>

namespace overfly {
namespace {

// Frames that a second of time code has: the rate itself, or the rate of which it is 1000/1001.
std::optional<int> nominal_frames_per_second(FrameRate rate) {
    const std::int64_t numerator = rate.numerator, denominator = rate.denominator;
    if (numerator % denominator == 0) return static_cast<int>(numerator / denominator);
    if (numerator * 1001 % (denominator * 1000) == 0) return static_cast<int>(numerator * 1001 / (denominator * 1000));
    return std::nullopt;
}

}  // namespace

std::optional<SmpteTime> smpte_time(int number, FrameRate rate) {
    const std::optional<int> per_second = nominal_frames_per_second(rate);
    if (!per_second || *per_second < 1 || *per_second > 60) return std::nullopt;

    const int per_day = 24 * 60 * 60 * *per_second;
    const int of_day = (number % per_day + per_day) % per_day;
    const int second = of_day / *per_second;
    const int frame = of_day % *per_second;
    const bool pairs = *per_second > 30;
    return SmpteTime{.hours = second / 3600,
                     .minutes = second / 60 % 60,
                     .seconds = second % 60,
                     .frame = pairs ? frame / 2 : frame,
                     .second_of_pair = pairs && frame % 2 == 1};
}

}  // namespace overfly
