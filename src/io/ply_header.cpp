#include "io/ply_header.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <system_error>

namespace overfly {
namespace {

// Comments included, nobody needs more.
constexpr int kMostLines = 10'000;
constexpr std::size_t kLongestLine = 10'000;

// A line without its end, or nothing behind the last one.
std::optional<std::string> next_line(std::istream& stream) {
    std::string line;
    for (char c = 0; stream.get(c) && c != '\n' && line.size() < kLongestLine;) line.push_back(c);
    if (!stream) return std::nullopt;
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

}  // namespace

std::optional<std::string> ply_header_fault(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return "it can't be read";
    if (next_line(stream) != "ply") return "its first line is not 'ply'";
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
    for (int i = 0; i < kMostLines; ++i) {
        const std::optional<std::string> line = next_line(stream);
        if (!line) break;
        if (line == "end_header") return std::nullopt;
        std::istringstream words(*line);
        std::string word, name;
        std::uintmax_t count = 0;
        if (!(words >> word) || word != "element") continue;
        // Every element is a byte at least.
        if (!(words >> name >> count) || unknown || count > bytes)
            return fmt::format("it can't have the elements of '{}'", *line);
    }
    return "its header has no end ('end_header')";
}

}  // namespace overfly
