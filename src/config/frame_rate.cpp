#include "config/frame_rate.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace overfly::config {
namespace {

constexpr double kMaxRate_per_s = 1000.0;
// Bounds the products of frame number and denominator (FrameRate::time_s) far below what 64 bits hold.
constexpr std::int64_t kMaxTerm = 1'000'000;

template <class Number>
std::optional<Number> whole_text(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::optional<FrameRate> lowest_terms(std::int64_t numerator, std::int64_t denominator) {
    const bool terms_allowed = numerator >= 1 && numerator <= kMaxTerm && denominator >= 1 && denominator <= kMaxTerm;
    if (!terms_allowed || static_cast<double>(numerator) > kMaxRate_per_s * static_cast<double>(denominator)) {
        return std::nullopt;
    }
    const std::int64_t divisor = std::gcd(numerator, denominator);
    return FrameRate{static_cast<std::int32_t>(numerator / divisor), static_cast<std::int32_t>(denominator / divisor)};
}

}  // namespace

std::optional<FrameRate> parse_frame_rate(std::string_view text) {
    if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
        const auto numerator = whole_text<std::int64_t>(text.substr(0, slash));
        const auto denominator = whole_text<std::int64_t>(text.substr(slash + 1));
        return numerator && denominator ? lowest_terms(*numerator, *denominator) : std::nullopt;
    }
    const std::optional<double> rate = whole_text<double>(text);
    if (!rate || !(*rate > 0.0 && *rate <= kMaxRate_per_s)) return std::nullopt;
    for (const std::int64_t nominal : {24, 30, 48, 60, 120}) {
        if (std::abs(*rate - static_cast<double>(nominal) / 1.001) < 0.0005) return lowest_terms(nominal * 1000, 1001);
    }
    const double thousandths = std::round(*rate * 1000.0);
    // A product of a three-decimal number rounds by no more than this.
    if (std::abs(*rate * 1000.0 - thousandths) > 1e-9 * thousandths) return std::nullopt;
    return lowest_terms(static_cast<std::int64_t>(thousandths), 1000);
}

}  // namespace overfly::config
