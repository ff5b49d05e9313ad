#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "config/document_path.h"
#include "config/read.h"

namespace overfly {
namespace {

std::string name_relative_to(const std::filesystem::path& folder, const std::filesystem::path& path) {
    if (config::is_gdal_name(path.native())) return path.string();
    const std::filesystem::path base = folder.empty() ? std::filesystem::path(".") : folder;
    const std::filesystem::path relative = std::filesystem::relative(path, base);
    return relative.empty() ? path.string() : relative.string();
}

// YAML's own words for what is not finite; else the shortest decimal that reads back as the same number.
std::string number_text(double value) {
    if (std::isnan(value)) return ".nan";
    if (std::isinf(value)) return value < 0.0 ? "-.inf" : ".inf";
    return fmt::format("{}", value);
}

const char* datum_word(VerticalDatum datum) {
    switch (datum) {
        case VerticalDatum::Unstated:
            return "";
        case VerticalDatum::Egm96:
            return "egm96";
        case VerticalDatum::Ellipsoid:
            return "ellipsoid";
        case VerticalDatum::Offset:
            return "offset";
    }
    throw InternalError("every vertical datum has a word");
}

}  // namespace

std::string terrain_document_text(const TerrainDocument& document, const std::filesystem::path& folder) {
    const ElevationSource& source = document.source;
    YAML::Emitter text;
    const auto pair = [&text](const char* key, const std::string& value) {
        if (!value.empty()) text << YAML::Key << key << YAML::Value << value;
    };
    text << YAML::BeginMap << YAML::Key << "dem" << YAML::Value;
    if (source.dem.size() == 1) {
        text << name_relative_to(folder, source.dem.front());
    } else {
        text << YAML::BeginSeq;
        for (const std::filesystem::path& dem : source.dem) text << name_relative_to(folder, dem);
        text << YAML::EndSeq;
    }
    if (source.band) pair("band", std::to_string(*source.band));
    pair("crs", source.crs);
    if (source.no_data) pair("no_data", number_text(*source.no_data));
    pair("vertical_unit", source.vertical_unit);
    pair("vertical_datum", datum_word(source.vertical_datum));
    if (source.vertical_datum == VerticalDatum::Offset)
        pair("vertical_offset_m", number_text(source.vertical_offset_m));
    text << YAML::EndMap;
    return std::string("# Which rasters make the terrain, and what their numbers mean.\n") + text.c_str() + '\n';
}

}  // namespace overfly
