#include "io/vertical_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace overfly {
namespace {

struct NamedUnit {
    std::string_view name;
    double metres;
    std::array<std::string_view, 8> other_names;  // lower case
};

// The US survey foot is 1200/3937 m by law; the others are metric by definition.
constexpr std::array<NamedUnit, 8> kUnits = {{
    {"m", 1.0, {"metre", "meter", "metres", "meters"}},
    {"km", 1000.0, {"kilometre", "kilometer", "kilometres", "kilometers"}},
    {"dm", 0.1, {"decimetre", "decimeter", "decimetres", "decimeters"}},
    {"cm", 0.01, {"centimetre", "centimeter", "centimetres", "centimeters"}},
    {"mm", 0.001, {"millimetre", "millimeter", "millimetres", "millimeters"}},
    {"ft", 0.3048, {"foot", "feet", "international foot", "international feet", "foot_intl"}},
    {"us-ft",
     1200.0 / 3937.0,
     {"us survey foot", "us survey feet", "u.s. survey foot", "foot_us", "ftus", "us_survey_foot", "survey foot",
      "us-foot"}},
    {"fathom", 1.8288, {"fathoms", "fath"}},
}};

std::string lower_case(std::string_view name) {
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

}  // namespace

std::optional<VerticalUnit> vertical_unit_named(std::string_view name) {
    const std::string wanted = lower_case(name);
    if (wanted.empty()) return std::nullopt;
    for (const NamedUnit& unit : kUnits)
        if (unit.name == wanted || std::ranges::find(unit.other_names, wanted) != unit.other_names.end())
            return VerticalUnit{std::string(unit.name), unit.metres};
    return std::nullopt;
}

std::string known_vertical_units() {
    std::string names;
    for (const NamedUnit& unit : kUnits) names += (names.empty() ? "" : ", ") + std::string(unit.name);
    return names;
}

}  // namespace overfly
