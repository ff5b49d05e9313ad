#include "io/colour_relief_file.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {
namespace {

using Srgb = ColourRelief::Srgb;

struct NamedColour {
    std::string_view name;
    Srgb srgb;
};

// GRASS's standard colours (lib/gis/named_colr.c).
constexpr std::array<NamedColour, 16> kNamedColours = {{
    {"white", {255, 255, 255}},
    {"black", {0, 0, 0}},
    {"red", {255, 0, 0}},
    {"green", {0, 255, 0}},
    {"blue", {0, 0, 255}},
    {"yellow", {255, 255, 0}},
    {"magenta", {255, 0, 255}},
    {"cyan", {0, 255, 255}},
    {"aqua", {0, 191, 191}},
    {"grey", {191, 191, 191}},
    {"gray", {191, 191, 191}},
    {"orange", {255, 127, 0}},
    {"brown", {191, 127, 63}},
    {"purple", {127, 0, 255}},
    {"violet", {127, 0, 255}},
    {"indigo", {0, 127, 255}},
}};

struct Word {
    std::string_view text;
    int column = 0;  // from 1
};

std::vector<Word> split(std::string_view line, std::string_view separators) {
    std::vector<Word> words;
    for (std::size_t begin = line.find_first_not_of(separators); begin != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        words.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
        begin = line.find_first_not_of(separators, end);
    }
    return words;
}

std::optional<double> number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

// Reads line by line, and gathers what is wrong.
class ReliefReader {
  public:
    explicit ReliefReader(const std::filesystem::path& file)
        : file_(file), is_cpt_(file.extension() == ".cpt" || file.extension() == ".CPT") {}

    void read_line(std::string_view line) {
        ++line_number_;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (is_cpt_ && line.starts_with('#') && line.find("COLOR_MODEL") != line.npos && line.find("RGB") == line.npos)
            wrong({line, 1}, "only RGB tables are understood");
        line = line.substr(0, line.find('#'));
        // GMT writes colours as R/G/B too.
        const std::vector<Word> words = split(line, is_cpt_ ? " \t/" : " \t,:");
        if (words.empty()) return;
        if (is_cpt_)
            read_cpt(words);
        else
            read_text(words);
    }

    ColourRelief finish() {
        if (problems_.empty() && relief_.entries.empty())
            problems_.push_back({{file_}, "has no line with an elevation and a colour"});
        if (!problems_.empty()) throw UserError(std::move(problems_));
        return std::move(relief_);
    }

  private:
    void wrong(const Word& word, std::string message) {
        problems_.push_back({{file_, line_number_, word.column}, std::move(message)});
    }

    void read_text(std::span<const Word> words) {
        ColourRelief::Entry entry;
        std::string_view value = words[0].text;
        const bool is_no_data = value == "nv";
        entry.is_percent = value.ends_with('%');
        if (entry.is_percent) value.remove_suffix(1);
        const std::optional<double> elevation = number(value);
        if (!is_no_data && !elevation)
            return wrong(words[0], fmt::format("\"{}\" is no elevation; a number, a percentage or nv", words[0].text));
        const std::optional<Srgb> srgb = colour(words[0], words.subspan(1));
        if (!srgb) return;
        if (is_no_data) {
            relief_.no_data = *srgb;
            return;
        }
        entry.value = *elevation;
        entry.srgb = *srgb;
        relief_.entries.push_back(entry);
    }

    // A slice: from one elevation and colour to the next. B, F, N are what lies below, above and nowhere.
    void read_cpt(std::span<const Word> words) {
        const std::string_view first = words[0].text;
        if (first == "B" || first == "F" || first == "N") {
            const std::optional<Srgb> srgb = colour(words[0], words.subspan(1));
            if (srgb && first == "N") relief_.no_data = *srgb;
            return;
        }
        if (words.size() < 8) return wrong(words[0], "a slice is two elevations, each with R G B");
        for (const std::size_t i : {std::size_t{0}, std::size_t{4}}) {
            const std::optional<double> elevation = number(words[i].text);
            if (!elevation) return wrong(words[i], fmt::format("\"{}\" is no elevation", words[i].text));
            const std::optional<Srgb> srgb = colour(words[i], words.subspan(i + 1, 3));
            if (!srgb) return;
            const ColourRelief::Entry entry{*elevation, false, *srgb};
            if (relief_.entries.empty() || relief_.entries.back() != entry) relief_.entries.push_back(entry);
        }
    }

    std::optional<Srgb> colour(const Word& elevation, std::span<const Word> words) {
        if (words.size() == 1) {
            std::string name(words[0].text);
            std::ranges::transform(name, name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
            const auto* const known = std::ranges::find(kNamedColours, name, &NamedColour::name);
            if (known != kNamedColours.end()) return known->srgb;
            wrong(words[0], fmt::format("\"{}\" is no colour that is known by name", words[0].text));
            return std::nullopt;
        }
        if (words.size() != 3 && words.size() != 4) {
            wrong(elevation, fmt::format("{} colour values; there are three, R G B, or four with opacity, or a name",
                                         words.size()));
            return std::nullopt;
        }
        Srgb srgb{};
        bool is_right = true;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::optional<double> value = number(words[i].text);
            if (value && *value >= 0.0 && *value <= 255.0) {
                if (i < 3) srgb[i] = static_cast<std::uint8_t>(std::lround(*value));
                continue;
            }
            wrong(words[i], fmt::format("\"{}\" is no colour value; 0 to 255", words[i].text));
            is_right = false;
        }
        return is_right ? std::optional<Srgb>(srgb) : std::nullopt;
    }

    const std::filesystem::path& file_;
    bool is_cpt_;
    int line_number_ = 0;
    ColourRelief relief_;
    std::vector<Problem> problems_;
};

}  // namespace

ColourRelief read_colour_relief(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw UserError({file}, "can't be read: " + std::generic_category().message(errno));
    ReliefReader reader(file);
    for (std::string line; std::getline(stream, line);) reader.read_line(line);
    if (stream.bad()) throw UserError({file}, "can't be read to the end");
    return reader.finish();
}

ColourRamp colour_ramp(const ColourRelief& relief, ElevationRange range) {
    ColourRamp ramp;
    for (const ColourRelief::Entry& entry : relief.entries) {
        const double share = entry.value / 100.0;
        const double elevation_m =
            entry.is_percent ? range.lowest_m + share * (range.highest_m - range.lowest_m) : entry.value;
        const auto linear = [&](std::size_t i) { return linear_from_srgb(static_cast<float>(entry.srgb[i]) / 255.0F); };
        ramp.stops.push_back({static_cast<float>(elevation_m), {linear(0), linear(1), linear(2)}});
    }
    std::ranges::stable_sort(ramp.stops, {}, &ColourRamp::Stop::elevation_m);
    return ramp;
}

}  // namespace overfly
