#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace overfly {

// The DEM that comes with the project.
[[nodiscard]] std::filesystem::path blanca();

// Like the programs gdal_translate and gdalwarp with these options. A failure is a test's failure.
void translate(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& options);
void warp(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& options);

// Puts a file into a new archive under its own name.
void zip(const std::filesystem::path& file, const std::filesystem::path& archive);

// A small GeoTIFF with whatever is wanted wrong about it.
struct SampleRaster {
    int columns = 3, rows = 2, bands = 1;
    std::string type = "Float32";
    std::vector<double> values = {100, 110, 120, 130, 140, 150};  // of the first band
    std::optional<std::array<double, 6>> crs_from_pixel = {{470'000, 30, 0, 4'180'000, 0, -30}};
    std::string crs = "EPSG:32613";  // empty: none
    std::optional<double> no_data;
    std::string unit;
    std::optional<double> scale, offset;
    bool has_palette = false;
    std::vector<std::uint8_t> mask;  // empty: none
};
void write_raster(const std::filesystem::path& file, const SampleRaster& raster);

// PROJ itself: x, y, z through an operation that PROJ or GDAL is told in words.
class Proj {
  public:
    // A pipeline in PROJ's language.
    explicit Proj(const std::string& pipeline);
    // From one CRS to another, longitude before latitude.
    Proj(const std::string& from, const std::string& to);
    ~Proj();
    Proj(const Proj&) = delete;
    Proj& operator=(const Proj&) = delete;

    [[nodiscard]] std::array<double, 3> operator()(std::array<double, 3> p) const;

  private:
    void* transformation_;
};

}  // namespace overfly
