#include "config/document_file.h"
#include "config/read.h"

namespace overfly {
namespace config {

void read_terrain(Section& document, TerrainDocument& terrain) {
    static constexpr NamedValue<VerticalDatum> kDatums[] = {{"egm96", VerticalDatum::Egm96},
                                                            {"sea_level", VerticalDatum::Egm96},
                                                            {"ellipsoid", VerticalDatum::Ellipsoid},
                                                            {"offset", VerticalDatum::Offset}};
    ElevationSource& source = terrain.source;
    document.require({"dem"});
    document.read("dem", source.dem, PathTo::Raster);
    document.read("band", source.band, {1, 65536});
    document.read("crs", source.crs);
    document.read_any_number("no_data", source.no_data);
    document.read("vertical_unit", source.vertical_unit);
    document.read("vertical_datum", source.vertical_datum, kDatums);
    document.read("vertical_offset_m", source.vertical_offset_m, {-20'000, 20'000});

    const bool offset = source.vertical_datum == VerticalDatum::Offset;
    if (offset) document.require({"vertical_offset_m"});
    if (!offset) document.refuse("vertical_offset_m", "only with `vertical_datum: offset`");
}

}  // namespace config

TerrainDocument read_terrain_document(const std::filesystem::path& file, std::span<const std::string> overrides) {
    config::Findings findings;
    TerrainDocument terrain{.file = file, .source = {}};
    read_document(file, config::parse_overrides(overrides, findings.problems), findings,
                  [&](config::Section& document) { read_terrain(document, terrain); });
    finish(findings);
    return terrain;
}

}  // namespace overfly
