#include "config/number_lists.h"

#include <fmt/format.h>

namespace overfly::config {
namespace {

std::optional<double> number_within(const Node& node, const std::string& path, const Range& range,
                                    std::vector<Problem>& problems) {
    const std::optional<double> number = number_of(node);
    if (number && range.contains(*number)) return number;
    problems.push_back(refusal(path, node, (number ? "" : "a number, ") + range.text()));
    return std::nullopt;
}

std::string item_path(const std::string& path, std::size_t index) { return fmt::format("{}.{}", path, index); }

}  // namespace

std::optional<std::vector<double>> numbers_of(const Node& node, const std::string& path, std::span<const Range> ranges,
                                              const std::string& wanted, std::vector<Problem>& problems) {
    if (node.kind != Node::Kind::List || node.items.size() != ranges.size()) {
        problems.push_back(refusal(path, node, wanted));
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (const auto number = number_within(node.items[i], item_path(path, i), ranges[i], problems))
            numbers.push_back(*number);
    }
    return numbers.size() == ranges.size() ? std::optional(numbers) : std::nullopt;
}

std::optional<std::vector<double>> number_or_numbers_of(const Node& node, const std::string& path, const Range& range,
                                                        std::size_t most, std::vector<Problem>& problems) {
    if (node.kind == Node::Kind::Scalar) {
        const auto number = number_within(node, path, range, problems);
        return number ? std::optional(std::vector{*number}) : std::nullopt;
    }
    const std::vector<Range> ranges(node.items.size(), range);
    if (node.items.empty() || node.items.size() > most) {
        problems.push_back(refusal(path, node, fmt::format("a number, or a list of 1 to {} of them", most)));
        return std::nullopt;
    }
    return numbers_of(node, path, ranges, "", problems);
}

bool for_each_item(const Node& node, const std::string& path, const std::string& items, std::vector<Problem>& problems,
                   const std::function<void(const Node& item, const std::string& item_path)>& read) {
    if (node.kind != Node::Kind::List || node.items.empty()) {
        problems.push_back(refusal(path, node, "a list of " + items));
        return false;
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) read(node.items[i], item_path(path, i));
    return true;
}

}  // namespace overfly::config
