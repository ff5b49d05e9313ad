#include "io/vertical_reference.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <ogr_spatialref.h>

namespace overfly {
namespace {

constexpr std::string_view kHowToState =
    "state vertical_datum: egm96 or ellipsoid, or the offset from these heights to ellipsoidal ones";

bool contains_word(std::string_view text, std::string_view word) {
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

// GRS80 (NAD83, ETRS89 ...) and WGS84 differ by 0.1 mm at the poles; older ellipsoids by hundreds of metres.
bool has_modern_ellipsoid(const OGRSpatialReference& crs) {
    constexpr double kSemiMajor_m = 6378137.0, kInverseFlattening = 298.257;
    return std::abs(crs.GetSemiMajor() - kSemiMajor_m) < 0.01 &&
           std::abs(crs.GetInvFlattening() - kInverseFlattening) < 0.001;
}

VerticalReference from_ellipsoid(const OGRSpatialReference& crs, const Place& place) {
    if (has_modern_ellipsoid(crs)) return {VerticalDatum::Ellipsoid, 0.0, "ellipsoid", Provenance::FromFile};
    throw UserError(place, fmt::format("its CRS counts heights from the ellipsoid of {}, not of WGS84; {}",
                                       crs.GetName(), kHowToState));
}

VerticalReference from_vertical_crs(const OGRSpatialReference& crs, const Place& place) {
    const char* const stated_name = crs.GetAttrValue("COMPD_CS|VERT_CS");
    const std::string name = stated_name != nullptr ? stated_name : "";
    if (contains_word(name, "EGM96")) return {VerticalDatum::Egm96, 0.0, "EGM96 geoid", Provenance::FromFile};
    if (contains_word(name, "ellipsoid")) return from_ellipsoid(crs, place);
    // "Sea level" without saying which one is what every CRS without a vertical part says.
    for (const std::string_view vague : {"MSL height", "mean sea level", "unknown", "unnamed"})
        if (contains_word(name, vague)) return {VerticalDatum::Egm96, 0.0, "EGM96 geoid", Provenance::Assumed};
    throw UserError(place,
                    fmt::format("its heights are counted from \"{}\", for which no exact conversion is known; {}", name,
                                kHowToState));
}

}  // namespace

std::string text(Provenance provenance) {
    switch (provenance) {
        case Provenance::Stated:
            return "stated";
        case Provenance::FromFile:
            return "from the file";
        case Provenance::Assumed:
            return "assumed";
    }
    return "";
}

VerticalReference vertical_reference(const ElevationSource& source, const OGRSpatialReference& crs,
                                     const Place& place) {
    switch (source.vertical_datum) {
        case VerticalDatum::Egm96:
            return {VerticalDatum::Egm96, 0.0, "EGM96 geoid", Provenance::Stated};
        case VerticalDatum::Ellipsoid:
            return {VerticalDatum::Ellipsoid, 0.0, "ellipsoid", Provenance::Stated};
        case VerticalDatum::Offset:
            return {VerticalDatum::Offset, source.vertical_offset_m,
                    fmt::format("{:+} m from the ellipsoid", source.vertical_offset_m), Provenance::Stated};
        case VerticalDatum::Unstated:
            break;
    }
    if (crs.IsCompound() != 0) return from_vertical_crs(crs, place);
    if (crs.GetAxesCount() == 3) return from_ellipsoid(crs, place);
    return {VerticalDatum::Egm96, 0.0, "EGM96 geoid", Provenance::Assumed};
}

}  // namespace overfly
