#include <sys/resource.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/verbs.h"
#include "config/read.h"
#include "core/error.h"
#include "io/temporary_file.h"
#include "shot/prepare_scene.h"

namespace overfly {
namespace {

struct Arguments {
    std::vector<std::string> dem;
    std::string output;
    std::optional<int> band;
    std::optional<double> no_data, vertical_offset_m;
    std::string crs, vertical_unit, vertical_datum;
};

// Bounds of the mesh in scene metres.
struct SceneBounds {
    Point<Scene> low, high;
};

SceneBounds bounds_of(const TerrainMesh& mesh) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    SceneBounds b = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (const Point<Scene>& p : mesh.positions) {
        b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
        b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
    }
    return b;
}

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

bool is_document(const std::filesystem::path& file) {
    return file.extension() == ".yaml" || file.extension() == ".yml";
}

// A terrain document with what the command line says put in.
TerrainDocument amended_document(const Arguments& arguments) {
    std::vector<std::string> overrides;
    const auto add = [&](const char* key, const std::string& value) {
        if (!value.empty()) overrides.push_back(fmt::format("{}={}", key, value));
    };
    if (arguments.band) add("band", fmt::format("{}", *arguments.band));
    if (arguments.no_data) add("no_data", fmt::format("{}", *arguments.no_data));
    add("crs", arguments.crs);
    add("vertical_unit", arguments.vertical_unit);
    add("vertical_datum", arguments.vertical_datum);
    if (arguments.vertical_offset_m) {
        add("vertical_datum", "offset");
        add("vertical_offset_m", fmt::format("{}", *arguments.vertical_offset_m));
    }
    return read_terrain_document(arguments.dem.front(), overrides);
}

VerticalDatum datum_named(const Arguments& arguments) {
    if (arguments.vertical_offset_m) return VerticalDatum::Offset;
    if (arguments.vertical_datum.empty()) return VerticalDatum::Unstated;
    return arguments.vertical_datum == "ellipsoid" ? VerticalDatum::Ellipsoid : VerticalDatum::Egm96;
}

// What the command line says, as the document that -o writes.
TerrainDocument document_of(const Arguments& arguments) {
    const auto document_file = std::ranges::find_if(arguments.dem, is_document);
    if (document_file != arguments.dem.end()) {
        if (arguments.dem.size() == 1) return amended_document(arguments);
        throw UserError({*document_file}, "a terrain document is imported alone, not together with other files");
    }
    TerrainDocument document;
    document.file = arguments.output;
    document.source.dem.assign(arguments.dem.begin(), arguments.dem.end());
    document.source.band = arguments.band;
    document.source.crs = arguments.crs;
    document.source.no_data = arguments.no_data;
    document.source.vertical_unit = arguments.vertical_unit;
    document.source.vertical_datum = datum_named(arguments);
    document.source.vertical_offset_m = arguments.vertical_offset_m.value_or(0.0);
    return document;
}

void write_document(const TerrainDocument& document, const std::filesystem::path& file) {
    std::error_code error;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
    TemporaryFile temporary(file);
    std::ofstream stream(temporary.path());
    stream << terrain_document_text(document, file.has_parent_path() ? file.parent_path() : std::filesystem::path("."));
    stream.close();
    if (!stream) throw UserError({file}, "can't be written");
    temporary.commit();
}

std::string share_text(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

std::string report_text(const PreparedTerrain& terrain) {
    const ElevationReport& r = terrain.scene.report;
    const TerrainMesh& mesh = terrain.scene.mesh;
    const SceneBounds b = bounds_of(mesh);
    std::string text_lines;
    const auto line = [&](const char* what, const std::string& value) {
        text_lines += fmt::format("{:<18}{}\n", what, value);
    };
    for (std::size_t i = 0; i < r.files.size(); ++i) line(i == 0 ? "files" : "", r.files[i].string());
    line("format", r.driver);
    line("CRS", r.crs_authority.empty() ? r.crs_name : fmt::format("{} ({})", r.crs_name, r.crs_authority));
    line("samples",
         fmt::format("{} x {} = {}, {:.6g} x {:.6g} {} apart", r.columns, r.rows,
                     static_cast<long long>(r.columns) * r.rows, r.column_spacing, r.row_spacing, r.spacing_unit));
    line("no data", r.no_data ? fmt::format("{} of the samples (value {})", share_text(r.no_data_share), *r.no_data)
                              : fmt::format("{} of the samples (no value declared)", share_text(r.no_data_share)));
    line("vertical unit",
         fmt::format("{} = {} m ({})", r.vertical_unit.name, r.vertical_unit.metres, text(r.vertical_unit_provenance)));
    line("vertical datum",
         fmt::format("{} ({}{})", r.vertical.name, text(r.vertical.provenance),
                     r.vertical.provenance == Provenance::Assumed ? ": state vertical_datum to be sure" : ""));
    line("heights", fmt::format("{:.2f} to {:.2f} m above that datum", r.lowest_m, r.highest_m));
    line("extent", fmt::format("lon {:.6f} to {:.6f}, lat {:.6f} to {:.6f}", r.extent.west_deg, r.extent.east_deg,
                               r.extent.south_deg, r.extent.north_deg));
    line("triangles", fmt::format("{} ({} vertices)", mesh.triangles.size(), mesh.positions.size()));
    line("bounds", fmt::format("{:.1f} x {:.1f} x {:.1f} m, east x north x up", b.high.x - b.low.x, b.high.y - b.low.y,
                               b.high.z - b.low.z));
    line("origin",
         fmt::format("lon {:.6f} lat {:.6f}", terrain.scene.origin.lon.degrees(), terrain.scene.origin.lat.degrees()));
    line("time",
         fmt::format("{:.2f} s{}", terrain.seconds, terrain.from_cache ? " (prepared earlier; inputs unchanged)" : ""));
    line("memory", fmt::format("{:.0f} MB at most, mesh {:.0f} MB", peak_memory_mb(),
                               static_cast<double>(mesh.memory_bytes()) / 1048576.0));
    return text_lines;
}

nlohmann::ordered_json report_json(const PreparedTerrain& terrain) {
    const ElevationReport& r = terrain.scene.report;
    const TerrainMesh& mesh = terrain.scene.mesh;
    const SceneBounds b = bounds_of(mesh);
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& f : r.files) files.push_back(f.string());
    return {{"files", files},
            {"format", r.driver},
            {"crs", {{"name", r.crs_name}, {"authority", r.crs_authority}}},
            {"samples", {{"columns", r.columns}, {"rows", r.rows}, {"valid", r.valid_count}}},
            {"spacing", {{"column", r.column_spacing}, {"row", r.row_spacing}, {"unit", r.spacing_unit}}},
            {"no_data",
             {{"value", r.no_data ? nlohmann::ordered_json(*r.no_data) : nlohmann::ordered_json()},
              {"share", r.no_data_share}}},
            {"vertical_unit",
             {{"name", r.vertical_unit.name},
              {"metres", r.vertical_unit.metres},
              {"known", text(r.vertical_unit_provenance)}}},
            {"vertical_datum", {{"name", r.vertical.name}, {"known", text(r.vertical.provenance)}}},
            {"height_m", {{"min", r.lowest_m}, {"max", r.highest_m}}},
            {"extent_deg",
             {{"west", r.extent.west_deg},
              {"south", r.extent.south_deg},
              {"east", r.extent.east_deg},
              {"north", r.extent.north_deg}}},
            {"triangles", mesh.triangles.size()},
            {"vertices", mesh.positions.size()},
            {"bounds_m", {{"east", {b.low.x, b.high.x}}, {"north", {b.low.y, b.high.y}}, {"up", {b.low.z, b.high.z}}}},
            {"origin_deg", {{"lon", terrain.scene.origin.lon.degrees()}, {"lat", terrain.scene.origin.lat.degrees()}}},
            {"from_cache", terrain.from_cache},
            {"seconds", terrain.seconds},
            {"peak_memory_mb", peak_memory_mb()},
            {"mesh_mb", static_cast<double>(mesh.memory_bytes()) / 1048576.0}};
}

int run_import(const Arguments& arguments, const CommonOptions& common) {
    Console console(common);
    const TerrainDocument document = document_of(arguments);
    const PreparedTerrain terrain = prepare_terrain(document, default_cache_folder(), console.progress());
    if (!arguments.output.empty()) {
        write_document(document, arguments.output);
        console.say(fmt::format("wrote {}", arguments.output));
    }
    console.result(report_text(terrain), report_json(terrain));
    return kDone;
}

}  // namespace

RunVerb add_import(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    verb.add_option("dem", arguments->dem, "rasters of elevation, or a terrain document")->required();
    verb.add_option("-o,--output", arguments->output, "the terrain document to write, terrain/NAME.yaml");
    verb.add_option("--band", arguments->band, "the band that holds heights, from 1")
        ->check(CLI::Range(1, std::numeric_limits<int>::max()));
    verb.add_option("--crs", arguments->crs,
                    "the coordinate reference system, where the file has none or a wrong one: EPSG:4326");
    verb.add_option("--no-data", arguments->no_data, "the value that means nothing was measured");
    verb.add_option("--vertical-unit", arguments->vertical_unit, "the unit of the heights: m, km, ft, us-ft");
    auto* datum = verb.add_option("--vertical-datum", arguments->vertical_datum, "what heights are counted from")
                      ->check(CLI::IsMember({"egm96", "sea_level", "ellipsoid"}));
    verb.add_option("--vertical-offset-m", arguments->vertical_offset_m,
                    "metres to add to a height to get one above the ellipsoid")
        ->excludes(datum);
    return [arguments](const CommonOptions& common) { return run_import(*arguments, common); };
}

}  // namespace overfly
