#include "core/local_time.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace overfly {
namespace {

using std::chrono::microseconds;

constexpr int kDecimals = 6;

// Takes what it understands from the front of a text; after the first thing that isn't there it takes nothing.
class Taker {
  public:
    explicit Taker(std::string_view text) : rest_(text) {}

    // So many digits, whose number is in the range.
    int digits(std::size_t count, int low, int high) {
        int value = 0;
        const char* const end = rest_.data() + count;
        // A sign would be understood as well.
        is_good_ = is_good_ && rest_.size() >= count &&
                   rest_.substr(0, count).find_first_not_of("0123456789") == std::string_view::npos &&
                   std::from_chars(rest_.data(), end, value).ec == std::errc() && low <= value && value <= high;
        if (is_good_) rest_.remove_prefix(count);
        return value;
    }
    void one_of(std::string_view characters) {
        is_good_ = is_good_ && !rest_.empty() && characters.find(rest_.front()) != std::string_view::npos;
        if (is_good_) rest_.remove_prefix(1);
    }
    // The same, if it is there.
    bool optional(char character) {
        const bool is_there = is_good_ && rest_.starts_with(character);
        if (is_there) rest_.remove_prefix(1);
        return is_there;
    }
    microseconds decimals() {
        const std::size_t count = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
        if (count < 1 || count > kDecimals) is_good_ = false;
        int value = digits(count, 0, 999'999);
        for (std::size_t i = count; i < kDecimals; ++i) value *= 10;
        return microseconds(value);
    }
    [[nodiscard]] bool took_all() const { return is_good_ && rest_.empty(); }

  private:
    std::string_view rest_;
    bool is_good_ = true;
};

std::chrono::minutes take_zone(Taker& take) {
    if (take.optional('Z')) return std::chrono::minutes(0);
    const bool behind = take.optional('-');
    if (!behind) take.one_of("+");
    const std::chrono::hours hours(take.digits(2, 0, 14));
    take.one_of(":");
    const std::chrono::minutes ahead = hours + std::chrono::minutes(take.digits(2, 0, 59));
    return behind ? -ahead : ahead;
}

}  // namespace

LocalTime later(LocalTime time, double by_s) {
    return {time.utc + microseconds(std::llround(1e6 * by_s)), time.ahead_of_utc};
}

std::optional<LocalTime> parse_local_time(std::string_view text) {
    Taker take(text);
    const std::chrono::year year(take.digits(4, 1, 9999));
    take.one_of("-");
    const std::chrono::month month(static_cast<unsigned>(take.digits(2, 1, 12)));
    take.one_of("-");
    const std::chrono::day day(static_cast<unsigned>(take.digits(2, 1, 31)));
    take.one_of("T ");
    const std::chrono::hours hours(take.digits(2, 0, 23));
    take.one_of(":");
    const std::chrono::minutes minutes(take.digits(2, 0, 59));
    take.one_of(":");
    const std::chrono::seconds seconds(take.digits(2, 0, 59));
    const microseconds fraction = take.optional('.') ? take.decimals() : microseconds(0);
    const std::chrono::minutes ahead = take_zone(take);
    const std::chrono::year_month_day date(year, month, day);
    if (!take.took_all() || !date.ok()) return std::nullopt;
    return LocalTime{std::chrono::sys_days(date) + hours + minutes + seconds + fraction - ahead, ahead};
}

std::string iso_text(const LocalTime& time) {
    const auto clock = time.clock();
    const auto midnight = std::chrono::floor<std::chrono::days>(clock);
    const std::chrono::year_month_day date(midnight);
    const std::chrono::hh_mm_ss of_day(clock - midnight);
    std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", static_cast<int>(date.year()),
                                   static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                                   of_day.hours().count(), of_day.minutes().count(), of_day.seconds().count());
    if (of_day.subseconds().count() != 0) text += fmt::format(".{:06}", of_day.subseconds().count());
    const auto ahead = std::chrono::abs(time.ahead_of_utc);
    return text + fmt::format("{}{:02}:{:02}", time.ahead_of_utc.count() < 0 ? '-' : '+', ahead.count() / 60,
                              ahead.count() % 60);
}

}  // namespace overfly
