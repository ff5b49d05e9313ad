#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace overfly::config {

// How many single-character insertions, deletions, replacements and swaps of neighbours lead from one word to the
// other, none of them touching a place twice ("optimal string alignment").
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

// The known word that `word` is probably a misspelling of: the nearest, the first of several, and nothing where even
// that one differs in more than a third of its characters.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known);

}  // namespace overfly::config
