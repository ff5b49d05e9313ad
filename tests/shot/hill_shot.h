#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "config/read.h"
#include "io/frame_file.h"
#include "io/temporary_folder.h"
#include "shot/render_shot.h"

namespace overfly::testing {

// A small picture of a hill on a slope, with a lake that mirrors it and a slab that flies by, on a morning.
class HillShot {
  public:
    static constexpr int kWidth = 64, kHeight = 36;
    // The slope without the hill falls to the south.
    static constexpr double kPosts_m = 50.0, kSlope = 0.15;

    HillShot() {
        write_hill();
        std::ofstream(folder_ / "hill.yaml") << "dem: hill.asc\ncrs: EPSG:32613\nvertical_datum: ellipsoid\n";
        std::ofstream(folder_ / "colours.txt") << "0 110 90 60\n420 110 90 60\n640 230 230 240\n5000 230 230 240\n";
        std::ofstream(folder_ / "flight.yaml")
            << "height_above: ellipsoid\nlens: {hfov_deg: 50}\nkeyframes:\n"
               "  - {time_s: 0, lon_deg: -105.5555, lat_deg: 37.4955, height_m: 640, heading_deg: -4, pitch_deg: -9}\n"
               "  - {time_s: 0.25, lon_deg: -105.5535, lat_deg: 37.4965, height_m: 650, heading_deg: 0, pitch_deg: "
               "-8}\n"
               "  - {time_s: 0.5, lon_deg: -105.5520, lat_deg: 37.4970, height_m: 655, heading_deg: 6, pitch_deg: "
               "-8}\n";
        std::ofstream(folder_ / "hill_shot.yaml")
            << "terrain: hill.yaml\nflight: flight.yaml\nframes: {rate: 24, count: 3, start_s: 0.2}\n"
               "image: {width: 64, height: 36}\nsampling: {lines: 4, mirror_depth: 1}\nlayers: all\n"
               "look: {colours: colours.txt, sun: {azimuth_deg: 115, elevation_deg: 14, shadows: exact}, "
               "visibility_km: 20}\n"
               "bodies:\n"
               "  - name: slab\n    colour: [0.8, 0.1, 0.1]\n"
               "    polygons: [[[-30, -30, 0], [30, -30, 0], [30, 30, 20], [-30, 30, 20]]]\n"
               "    place: {lon_deg: -105.5550, lat_deg: 37.5020, height_m: 590, height_above: ellipsoid}\n"
               "    east_m: [-50, 250]\n"
               "  - name: lake\n    colour: [0.02, 0.05, 0.05]\n    mirror: 0.5\n    shadow: false\n"
               "    outline:\n"
               "      lon_lat_deg: [[-105.5560, 37.5010], [-105.5500, 37.5010], [-105.5500, 37.5060], [-105.5560, "
               "37.5060]]\n"
               "      height_m: 420\n      height_above: ellipsoid\n"
               "output: {contact_sheet: false, movie: false, folder: out}\n";
    }

    [[nodiscard]] ShotDocument document(const std::vector<std::string>& overrides = {}) const {
        return read_shot_document(folder_ / "hill_shot.yaml", overrides);
    }
    // A frame as its file has it, with all its layers; from the middle of those that are rendered at once.
    [[nodiscard]] Frame rendered(std::vector<std::string> overrides = {}, const std::string& frames = "2") const {
        overrides.push_back("output.folder=" + (folder_ / ("out" + std::to_string(renders_++))).string());
        const ShotDocument shot = document(overrides);
        RenderOptions options;
        options.frames = frames;
        options.cache_folder = folder_ / "cache";
        static_cast<void>(render_shot(shot, options));
        const std::string middle = frames == "1-3" ? "2" : frames;
        return read_frame_with_layers(shot.output.folder / ("hill_shot.000" + middle + ".exr"));
    }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }
    [[nodiscard]] std::filesystem::path cache() const { return folder_ / "cache"; }

  private:
    void write_hill() const {
        constexpr int kPosts = 60;
        std::ofstream file(folder_ / "hill.asc");
        file << "ncols 60\nnrows 60\nxllcorner 450000\nyllcorner 4149800\ncellsize 50\n";
        for (int row = 0; row < kPosts; ++row) {
            for (int column = 0; column < kPosts; ++column) {
                const double north_m = kPosts_m * (kPosts - row), east_m = kPosts_m * column;
                const double r = std::hypot(north_m - 1700.0, east_m - 1500.0) / 400.0;
                file << 300.0 + kSlope * north_m * 0.5 + 250.0 * std::exp(-r * r) << ' ';
            }
            file << '\n';
        }
    }

    TemporaryFolder folder_;
    mutable int renders_ = 0;
};

// A channel of a frame by its name. REQUIRES: the frame has it.
inline const std::vector<float>& channel(const Frame& frame, const std::string& name) {
    for (const LayerChannel& c : frame.layers) {
        if (c.name == name) return c.values;
    }
    throw std::out_of_range(name);
}

}  // namespace overfly::testing
