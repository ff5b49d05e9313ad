#pragma once

#include <string>

#include "core/error.h"
#include "terrain/elevation_source.h"

class OGRSpatialReference;

namespace overfly {

// How a fact about a raster came to be known; the less certain, the later.
enum class Provenance { Stated, FromFile, Assumed };
[[nodiscard]] std::string text(Provenance provenance);  // "stated", "from the file", "assumed"

// What heights are counted from. `datum` is never Unstated.
struct VerticalReference {
    VerticalDatum datum = VerticalDatum::Egm96;
    double offset_m = 0.0;  // with Offset
    std::string name;       // for people: "EGM96 geoid", ...
    Provenance provenance = Provenance::Assumed;

    friend bool operator==(const VerticalReference&, const VerticalReference&) = default;
};

// What `source` states, else what the CRS of the raster says, else EGM96. Throws UserError, with `place`, where the CRS
// names a datum that can't be brought to the ellipsoid exactly (NAVD88, EGM2008, ...): it must be stated then.
[[nodiscard]] VerticalReference vertical_reference(const ElevationSource& source, const OGRSpatialReference& crs,
                                                   const Place& place);

}  // namespace overfly
