// Looks into the program's results for tests/app:
//   json POINTER          prints the value at a JSON pointer of standard input; strings without quotes
//   complete FRAME...     whether all the frames can be read to their ends
//   same FRAME FRAME      whether all pixels of all channels are equal to the bit
//   has FRAME ATTRIBUTE   whether the header has it
//   summit FRAME TERRAIN  prints where worldToNDC puts the terrain's highest vertex: x, y in pixels, depth in metres
//   change, pixels_of, hashed_bytes, centroid: see probe_frames.h
//   skyline FRAME COLUMN  prints the row and the depth of the uppermost pixel of the column that isn't only sky
// Exit code 0: yes or done, 1: no.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "config/read.h"
#include "core/error.h"
#include "io/frame_file.h"
#include "probe_frames.h"
#include "shot/prepare_scene.h"

namespace overfly {
namespace {

using Arguments = std::vector<std::string>;

bool print_json(const Arguments& a) {
    const nlohmann::json document = nlohmann::json::parse(std::cin);
    const nlohmann::json value = document.at(nlohmann::json::json_pointer(a.at(0)));
    fmt::print("{}\n", value.is_string() ? value.get<std::string>() : value.dump());
    return true;
}

bool has_attribute(const Arguments& a) {
    const Imf::InputFile file(a.at(0).c_str());
    return file.header().find(a.at(1)) != file.header().end();
}

bool print_summit(const Arguments& a) {
    const PreparedTerrain terrain = prepare_terrain(read_terrain_document(a.at(1)), default_cache_folder());
    const TerrainMesh& mesh = terrain.scene.mesh;
    const auto highest = std::ranges::max_element(mesh.elevation_m) - mesh.elevation_m.begin();
    const Point<Scene> summit = mesh.positions[static_cast<std::size_t>(highest)];
    const Imf::InputFile file(a.at(0).c_str());
    // By hand, as a reader of the standard would: row vectors, and a divide by the fourth coordinate.
    const Imath::M44f m = Imf::worldToNDC(file.header());
    const auto column = [&](int c) { return summit.x * m[0][c] + summit.y * m[1][c] + summit.z * m[2][c] + m[3][c]; };
    const auto size = file.header().displayWindow().size();
    fmt::print("{:.5f} {:.5f} {:.3f}\n", column(0) / column(3) * (size.x + 1), column(1) / column(3) * (size.y + 1),
               column(3));
    return true;
}

bool print_skyline(const Arguments& a) {
    const Frame frame = read_frame(a.at(0));
    const int column = std::stoi(a.at(1));
    for (int y = 0; y < frame.height; ++y) {
        const float depth_m = frame.depth_m[frame.index(column, y)];
        if (depth_m == Frame::kNoDepth) continue;
        fmt::print("{} {:.3f}\n", y, depth_m);
        return true;
    }
    return false;
}

const std::map<std::string, bool (*)(const Arguments&)> kQuestions = {
    {"json", print_json},
    {"complete", [](const Arguments& a) { return std::ranges::all_of(a, is_complete_frame); }},
    {"same", [](const Arguments& a) { return read_frame_with_layers(a.at(0)) == read_frame_with_layers(a.at(1)); }},
    {"has", has_attribute},
    {"summit", print_summit},
    {"skyline", print_skyline},
    {"change", probe::change},
    {"pixels_of", probe::pixels_of},
    {"hashed_bytes", probe::print_hashed_bytes},
    {"centroid", probe::print_centroid},
};

}  // namespace
}  // namespace overfly

int main(int argc, char** argv) {
    try {
        const overfly::Arguments arguments(argv + 1, argv + argc);
        const overfly::Arguments rest(arguments.begin() + 1, arguments.end());
        return overfly::kQuestions.at(arguments.at(0))(rest) ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& error) {
        fmt::print(stderr, "probe: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
