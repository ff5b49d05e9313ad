#include "config/body_shape.h"

#include <fmt/format.h>

#include <array>

#include "config/flight_place.h"
#include "config/number_lists.h"
#include "geo/scene_frame.h"
#include "mesh/body_mesh.h"
#include "mesh/mesh_plane.h"

namespace overfly::config {
namespace {

// A body is at most as large as the Earth.
constexpr Range kCoordinate_m{-10'000'000, 10'000'000};

// Farther from its middle a lake's level plane would be more than 800 m above the lake.
constexpr double kWidestOutline_m = 100'000.0;

void read_mesh(Section& section, BodyDocument& body) {
    static constexpr NamedValue<UpAxis> kAxes[] = {{"y", UpAxis::Y}, {"z", UpAxis::Z}};
    MeshSource source;
    if (section.read("mesh", source.file, PathTo::File)) {
        const std::optional<MeshFormat> format = mesh_format(source.file);
        if (!format) section.refuse("mesh", kMeshFileNames);
        source.up = usual_up_axis(format.value_or(MeshFormat::Ply));
    }
    section.read("scale", source.scale, Range::above(0, 1'000'000));
    section.read("up", source.up, kAxes);
    if (section.has("mesh")) {
        body.shape = source;
        return;
    }
    section.refuse("scale", "only with 'mesh'");
    section.refuse("up", "only with 'mesh'");
}

// A ring's corners, or nothing where any of them is not what it should be, which is noted.
template <std::size_t size>
std::vector<std::array<double, size>> read_ring(const Node& node, const std::string& path,
                                                const std::array<Range, size>& ranges, const std::string& corner,
                                                std::vector<Problem>& problems) {
    std::vector<std::array<double, size>> ring;
    bool all = true;
    for_each_item(node, path, "corners " + corner, problems, [&](const Node& item, const std::string& item_path) {
        const auto numbers = numbers_of(item, item_path, ranges, "a corner " + corner, problems);
        all = all && numbers;
        if (numbers) std::copy_n(numbers->begin(), size, ring.emplace_back().begin());
    });
    if (!all) ring.clear();
    return ring;
}

bool note_fault(std::span<const Point<Scene>> corners, const Place& place, const std::string& path,
                std::vector<Problem>& problems) {
    const std::optional<std::string> fault = polygon_fault(corners);
    if (fault) problems.push_back({place, fmt::format("{}: got {}", path, *fault)});
    return fault.has_value();
}

// A mirror shows one direction from each place, so that its plane must be one. And what has no area at all can't be
// seen, however many corners it has.
void check_whole(Section& section, const std::vector<Polygon>& polygons, double mirror) {
    const BodyMesh body = body_mesh_of(polygons);
    if (body.mesh.triangles.empty()) section.problem("got polygons without area");
    if (mirror == 0.0 || body.mesh.triangles.empty()) return;
    const MeshPlane plane = plane_of(body.mesh);
    if (plane.is_planar()) return;
    section.refuse("mirror", fmt::format("0 for a body that is not planar: its corners are up to {:.4g} m off one "
                                         "plane, a mirror's at most {:.4g} m",
                                         plane.farthest_m, kPlanar * plane.size_m));
}

void read_polygons(Section& section, BodyDocument& body) {
    static constexpr std::array kRanges{kCoordinate_m, kCoordinate_m, kCoordinate_m};
    bool all_good = true;
    section.read_node("polygons", [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
        std::vector<Polygon> polygons;
        const auto read_polygon = [&](const Node& item, const std::string& item_path) {
            Polygon& polygon = polygons.emplace_back();
            for (const auto& [x, y, z] : read_ring(item, item_path, kRanges, "[x, y, z] in metres", problems))
                polygon.push_back({x, y, z});
            all_good = !polygon.empty() && !note_fault(polygon, item.place, item_path, problems) && all_good;
        };
        all_good = for_each_item(node, path, "polygons", problems, read_polygon) && all_good;
        body.shape = std::move(polygons);
    });
    if (section.has("polygons") && all_good)
        check_whole(section, std::get<std::vector<Polygon>>(body.shape), body.mirror);
}

void check_outline(const Outline& outline, const Place& place, const std::string& path,
                   std::vector<Problem>& problems) {
    const LonLat middle = middle_of(outline);
    const Geodetic at{middle.lon, middle.lat, 0.0};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const double away_m = geodesic_length_m(at, {outline[i].lon, outline[i].lat, 0.0});
        if (away_m <= kWidestOutline_m) continue;
        problems.push_back({place, fmt::format("{}: got corner {} {:.1f} km from the outline's middle, allowed {} km",
                                               path, i, away_m / 1000.0, kWidestOutline_m / 1000.0)});
        return;
    }
    note_fault(level_polygon(outline, at), place, path, problems);
}

// Where the outline's height is counted; its middle is the place.
void read_outline_keys(Section& section, Outline& outline, FlightPlace& place) {
    static constexpr std::array kRanges{Range{-360, 360}, Range{-90, 90}};
    section.require({"lon_lat_deg", "height_m"});
    section.read_node("lon_lat_deg", [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
        for (const auto& [lon, lat] : read_ring(node, path, kRanges, "[lon, lat] in degrees", problems))
            outline.push_back({Angle::degrees(lon), Angle::degrees(lat)});
        if (!outline.empty()) check_outline(outline, node.place, path, problems);
    });
    section.read("height_m", place.height_m, kHeight_m);
    read_height_above(section, place.above);
    if (outline.empty()) return;
    const LonLat middle = middle_of(outline);
    place.lon = middle.lon;
    place.lat = middle.lat;
}

void read_outline(Section& section, BodyDocument& body) {
    Outline outline;
    BodyPolynomials rest;
    rest.place.above = HeightAbove::SeaLevel;
    if (!section.section("outline", [&](Section& inner) { read_outline_keys(inner, outline, rest.place); })) return;
    body.shape = std::move(outline);
    body.motion = std::move(rest);
}

}  // namespace

void read_body_shape(Section& section, BodyDocument& body) {
    read_mesh(section, body);
    read_polygons(section, body);
    read_outline(section, body);
    section.allow_one_of("mesh", "polygons");
    section.allow_one_of("mesh", "outline");
    section.allow_one_of("polygons", "outline");
    if (!section.has("mesh") && !section.has("polygons") && !section.has("outline"))
        section.problem("got no shape, allowed one of 'mesh', 'polygons', 'outline'");
}

}  // namespace overfly::config
