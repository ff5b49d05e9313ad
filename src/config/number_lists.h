#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/node.h"
#include "config/range.h"

namespace overfly::config {

// The numbers of a list that has as many as there are ranges, each within its own. Nothing where something is wrong,
// which is noted. wanted: what messages call it, as "3 numbers [r, g, b]".
[[nodiscard]] std::optional<std::vector<double>> numbers_of(const Node& node, const std::string& path,
                                                            std::span<const Range> ranges, const std::string& wanted,
                                                            std::vector<Problem>& problems);

// A number, or a list of one to `most` of them.
[[nodiscard]] std::optional<std::vector<double>> number_or_numbers_of(const Node& node, const std::string& path,
                                                                      const Range& range, std::size_t most,
                                                                      std::vector<Problem>& problems);

// Hands each item of a list, which is not empty, to `read` with its path; false where there is none, which is noted.
// items: what messages call them, as "corners".
bool for_each_item(const Node& node, const std::string& path, const std::string& items, std::vector<Problem>& problems,
                   const std::function<void(const Node& item, const std::string& item_path)>& read);

}  // namespace overfly::config
