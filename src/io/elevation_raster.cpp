#include "io/elevation_raster.h"

#include <cmath>
#include <string_view>

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "core/error.h"
#include "io/elevation_band.h"
#include "io/gdal_messages.h"
#include "io/raster_dataset.h"

namespace overfly {
namespace {

// What was found wrong with one file so far; thrown at once by read_elevation_raster.
class Findings {
  public:
    explicit Findings(const std::filesystem::path& file) : file_(file) {}
    void add(std::string message) { problems_.push_back({{file_}, std::move(message)}); }
    void add(const UserError& error) {
        problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
    }
    void throw_if_any() const {
        if (!problems_.empty()) throw UserError(problems_);
    }

  private:
    const std::filesystem::path& file_;
    std::vector<Problem> problems_;
};

// The band with the heights; nullptr and a finding where none can be it.
GDALRasterBand* choose_band(GDALDataset& dataset, std::optional<int> stated, Findings& findings) {
    const int count = dataset.GetRasterCount();
    if (stated) {
        if (*stated >= 1 && *stated <= count) return dataset.GetRasterBand(*stated);
        findings.add(fmt::format("band: {} is stated, the file has {} band(s)", *stated, count));
        return nullptr;
    }
    GDALRasterBand* chosen = nullptr;
    for (int i = 1; i <= count; ++i) {
        GDALRasterBand* const band = dataset.GetRasterBand(i);
        if (band->GetColorInterpretation() == GCI_AlphaBand) continue;
        if (chosen != nullptr) {
            findings.add(fmt::format("has {} bands; state the one with the heights with band:", count));
            return nullptr;
        }
        chosen = band;
    }
    if (chosen == nullptr) findings.add("has no band with heights, only a mask");
    return chosen;
}

void check_band(GDALRasterBand& band, Findings& findings) {
    const int columns = band.GetXSize(), rows = band.GetYSize();
    if (columns < 2 || rows < 2)
        findings.add(fmt::format("has {}x{} samples; a surface needs at least 2x2", columns, rows));
    if (static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) > kMostSamples)
        findings.add(fmt::format("has {}x{} samples; at most {} can be meshed: cut it or thin it out (gdalwarp)",
                                 columns, rows, kMostSamples));
    if (band.GetColorInterpretation() == GCI_PaletteIndex)
        findings.add("is a picture: its numbers are indices into a colour palette, not heights");
    if (GDALDataTypeIsComplex(band.GetRasterDataType()) != 0)
        findings.add(
            fmt::format("has complex numbers ({}), not heights", GDALGetDataTypeName(band.GetRasterDataType())));
}

CrsFromPixel placement(GDALDataset& dataset, Findings& findings) {
    CrsFromPixel a{};
    if (dataset.GetGeoTransform(a.data()) != CE_None)
        findings.add(dataset.GetGCPCount() > 0 ? "is placed by ground control points only; place it with gdalwarp first"
                                               : "does not say where it lies (no geotransform, no world file)");
    else if (!(std::abs(a[1] * a[5] - a[2] * a[4]) > 0.0))
        findings.add("its geotransform has samples without any area");
    return a;
}

// The stated CRS, else the file's own. Empty, with a finding, where it is of no use.
OGRSpatialReference choose_crs(GDALDataset& dataset, const std::string& stated, Findings& findings) {
    OGRSpatialReference crs;
    if (!stated.empty()) {
        static const char* const options[] = {"ALLOW_NETWORK_ACCESS=NO", nullptr};
        const GdalMessages messages;
        if (crs.SetFromUserInput(stated.c_str(), options) != OGRERR_NONE) {
            findings.add(fmt::format("crs: \"{}\" is no coordinate reference system that GDAL knows", stated));
            return OGRSpatialReference();
        }
    } else if (const OGRSpatialReference* own = dataset.GetSpatialRef(); own != nullptr) {
        crs = *own;
    } else {
        findings.add("has no coordinate reference system; state one with crs:, for instance crs: EPSG:4326");
        return OGRSpatialReference();
    }
    if (crs.IsGeographic() != 0 || crs.IsProjected() != 0) return crs;
    findings.add(fmt::format("its CRS \"{}\" is neither geographic nor projected; state the right one with crs:",
                             crs.GetName() != nullptr ? crs.GetName() : "unnamed"));
    return OGRSpatialReference();
}

// "EPSG:32613", or "EPSG:4326+5773" for one that is put together; empty where the CRS says none.
std::string authority_of(const OGRSpatialReference& whole, const OGRSpatialReference& horizontal) {
    const auto text_of = [](const char* name, const char* code) {
        return name != nullptr && code != nullptr ? fmt::format("{}:{}", name, code) : std::string();
    };
    std::string text = text_of(whole.GetAuthorityName(nullptr), whole.GetAuthorityCode(nullptr));
    if (!text.empty()) return text;
    text = text_of(horizontal.GetAuthorityName(nullptr), horizontal.GetAuthorityCode(nullptr));
    const char* const vertical_code = whole.GetAuthorityCode("COMPD_CS|VERT_CS");
    return text.empty() || vertical_code == nullptr ? text : text + "+" + vertical_code;
}

void describe_crs(const OGRSpatialReference& whole, ElevationRaster& raster) {
    OGRSpatialReference crs = whole;
    if (crs.IsCompound() != 0) crs.StripVertical();
    if (crs.GetAxesCount() == 3) crs.DemoteTo2D(nullptr);
    static const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    char* wkt = nullptr;
    crs.exportToWkt(&wkt, options);
    raster.crs_wkt = wkt != nullptr ? wkt : "";
    CPLFree(wkt);
    raster.crs_name = whole.GetName() != nullptr ? whole.GetName() : "unnamed";
    raster.crs_authority = authority_of(whole, crs);
    const char* unit = nullptr;
    if (crs.IsGeographic() != 0)
        crs.GetAngularUnits(&unit);
    else
        crs.GetLinearUnits(&unit);
    raster.crs_unit = unit != nullptr ? unit : "";
}

// Stated, else the band's, else that of the CRS's vertical part, else metres.
void choose_unit(GDALRasterBand& band, const ElevationSource& source, const OGRSpatialReference& crs,
                 ElevationRaster& raster, Findings& findings) {
    const std::string band_unit = band.GetUnitType() != nullptr ? band.GetUnitType() : "";
    const bool is_stated = !source.vertical_unit.empty();
    if (is_stated || !band_unit.empty()) {
        const std::string& name = is_stated ? source.vertical_unit : band_unit;
        raster.unit_provenance = is_stated ? Provenance::Stated : Provenance::FromFile;
        if (const auto unit = vertical_unit_named(name))
            raster.unit = *unit;
        else if (is_stated)
            findings.add(fmt::format("vertical_unit: \"{}\" is not known; known are {}", name, known_vertical_units()));
        else
            findings.add(fmt::format("its heights are in \"{}\", which is not known; state vertical_unit: as one of {}",
                                     name, known_vertical_units()));
    } else if (crs.IsCompound() != 0) {
        const char* name = nullptr;
        const double metres = crs.GetTargetLinearUnits("COMPD_CS|VERT_CS", &name);
        const auto known = vertical_unit_named(name != nullptr ? name : "");
        raster.unit = known ? *known : VerticalUnit{name != nullptr ? name : "", metres};
        raster.unit_provenance = Provenance::FromFile;
    }
}

}  // namespace

ElevationRaster read_elevation_raster(const std::filesystem::path& file, const ElevationSource& source) {
    const GdalMessages messages;
    const RasterDataset dataset = open_raster(file);
    ElevationRaster raster;
    raster.file = file;
    raster.files = files_of(*dataset);
    raster.driver = dataset->GetDriver()->GetDescription();

    Findings findings(file);
    GDALRasterBand* const band = choose_band(*dataset, source.band, findings);
    if (band != nullptr) check_band(*band, findings);
    raster.crs_from_pixel = placement(*dataset, findings);
    const OGRSpatialReference crs = choose_crs(*dataset, source.crs, findings);
    if (band != nullptr) choose_unit(*band, source, crs, raster, findings);
    if (!crs.IsEmpty()) {
        describe_crs(crs, raster);
        try {
            raster.vertical = vertical_reference(source, crs, {file});
        } catch (const UserError& error) {
            findings.add(error);
        }
    }
    findings.throw_if_any();

    raster.no_data = no_data_of(*band, source.no_data);
    raster.model = read_band(*band, source.no_data, raster.unit.metres, file);
    return raster;
}

}  // namespace overfly
