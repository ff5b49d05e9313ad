#include "config/frame_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/error.h"

namespace overfly {
namespace {

struct Part {
    int first, last, step;
};

// Takes a number without a sign off the front of `text`.
std::optional<int> take_number(std::string_view& text) {
    int value = 0;
    if (text.empty() || text.front() == '-') return std::nullopt;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

// FIRST, FIRST-LAST, FIRST-LAST:STEP or FIRST-LASTxSTEP.
std::optional<Part> parse_part(std::string_view text) {
    const std::optional<int> first = take_number(text);
    if (!first) return std::nullopt;
    if (text.empty()) return Part{*first, *first, 1};
    if (text.front() != '-') return std::nullopt;
    text.remove_prefix(1);
    const std::optional<int> last = take_number(text);
    if (!last) return std::nullopt;
    if (text.empty()) return Part{*first, *last, 1};
    if (text.front() != ':' && text.front() != 'x') return std::nullopt;
    text.remove_prefix(1);
    const std::optional<int> step = take_number(text);
    if (!step || !text.empty() || *step < 1) return std::nullopt;
    return Part{*first, *last, *step};
}

}  // namespace

std::vector<int> parse_frame_range(const std::string& text, FrameSpan available) {
    const Place place{"--frames " + text};
    std::vector<Problem> problems;
    std::vector<int> frames;
    std::string_view rest = text;
    for (bool more = true; more;) {
        const std::size_t comma = rest.find(',');
        const std::string_view part_text = rest.substr(0, comma);
        more = comma != std::string_view::npos;
        rest.remove_prefix(more ? comma + 1 : rest.size());

        const std::optional<Part> part = parse_part(part_text);
        if (!part) {
            problems.push_back({place, fmt::format("got '{}', allowed a frame (5), a range (10-20) or a range with a "
                                                   "step (1-100:5 or 1-100x5), separated by commas",
                                                   part_text)});
        } else if (part->first > part->last) {
            problems.push_back({place, fmt::format("got {}, which is empty, allowed a first frame that is not after "
                                                   "the last",
                                                   part_text)});
        } else if (part->first < available.first || part->last > available.last) {
            problems.push_back(
                {place, fmt::format("got {}, allowed frames {} to {}", part_text, available.first, available.last)});
        } else {
            // Counted down so that a step near the largest int cannot overflow.
            for (int n = (part->last - part->first) / part->step; n >= 0; --n) {
                frames.push_back(part->first + n * part->step);
            }
        }
    }
    if (!problems.empty()) throw UserError(std::move(problems));
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

}  // namespace overfly
