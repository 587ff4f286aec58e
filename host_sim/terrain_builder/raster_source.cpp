#include "host_sim/terrain_builder/raster_source.hpp"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kInternationalFoot_m = 0.3048, kUsSurveyFoot_m = 1200.0 / 3937.0;
constexpr double kPlainShareOfPost = 0.01;

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string inside_zip(const std::string& file) {
    if (!ends_with(lower(file), ".zip")) return file;
    const std::string archive = "/vsizip/" + file;
    const CPLStringList names(VSIReadDirRecursive(archive.c_str()));
    for (int n = 0; n < names.Count(); ++n) {
        std::string candidate = archive + "/" + names[n];
        if (GdalDataset(GDALDataset::Open(candidate.c_str(), GDAL_OF_RASTER)) != nullptr) return candidate;
    }
    throw UserError(file + ": no raster inside this archive; unpack it and name the height file");
}

GdalDataset open_dataset(const std::string& file) {
    VSIStatBufL info;
    if (VSIStatL(file.c_str(), &info) != 0) throw UserError(file + ": no such file; check the name");
    GdalDataset dataset(GDALDataset::Open(inside_zip(file).c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (dataset == nullptr || dataset->GetRasterCount() < 1)
        throw UserError(file + ": not a raster that GDAL can read (" + QuietGdal::last_message() +
                        "); give a height raster such as GeoTIFF, HGT, HF2, TER or BT");
    return dataset;
}

/// Length of a unit of the band in metres; nothing for what is no length.
std::optional<double> metres_per_unit(const std::string& stated) {
    const std::string unit = lower(stated);
    for (const char* name : {"", "m", "metre", "meter", "metres", "meters"})
        if (unit == name) return 1.0;
    for (const char* name : {"ft", "foot", "feet", "international foot"})
        if (unit == name) return kInternationalFoot_m;
    for (const char* name : {"us survey foot", "us survey feet", "us-ft", "ftus", "foot_us", "ft_us"})
        if (unit == name) return kUsSurveyFoot_m;
    if (unit == "cm" || unit == "centimetre" || unit == "centimeter") return 0.01;
    if (unit == "mm" || unit == "millimetre" || unit == "millimeter") return 0.001;
    if (unit == "km" || unit == "kilometre" || unit == "kilometer") return 1000.0;
    return std::nullopt;
}

void read_scale(RasterSource& source) {
    GDALRasterBand* const band = source.dataset->GetRasterBand(1);
    const std::string unit = band->GetUnitType();
    const auto metres = metres_per_unit(unit);
    if (!metres) throw UserError(source.file + ": its values are in '" + unit + "', which is no length; give a height raster");
    source.metres_per_count = band->GetScale() * *metres;
    source.offset_m = band->GetOffset() * *metres;
    if (!std::isfinite(source.metres_per_count) || !std::isfinite(source.offset_m) || source.metres_per_count == 0)
        throw UserError(source.file + ": its scale and offset are no usable numbers; correct the raster's metadata");
}

void refuse_pictures(const RasterSource& source) {
    GDALRasterBand* const band = source.dataset->GetRasterBand(1);
    const GDALColorInterp meaning = band->GetColorInterpretation();
    const bool colour =
        meaning == GCI_RedBand || meaning == GCI_GreenBand || meaning == GCI_BlueBand || meaning == GCI_PaletteIndex;
    if (colour || GDALDataTypeIsComplex(band->GetRasterDataType()) != 0)
        throw UserError(source.file + ": its first band holds colours or complex numbers, no heights; give a height raster");
}

void read_place(RasterSource& source, const RasterOptions& options) {
    const bool placed = source.dataset->GetGeoTransform(source.transform.data()) == CE_None;
    const auto& t = source.transform;
    const bool finite = std::all_of(t.begin(), t.end(), [](double x) { return std::isfinite(x); });
    if (!placed || !finite || t[1] * t[5] - t[2] * t[4] == 0)
        throw UserError(source.file + ": the raster does not say where on Earth it lies; georeference it first");
    if (options.crs) {
        if (source.crs.SetFromUserInput(options.crs->c_str()) != OGRERR_NONE)
            throw UserError("--crs " + *options.crs + ": unknown coordinate system; use for instance EPSG:2056");
    } else if (const OGRSpatialReference* stated = source.dataset->GetSpatialRef()) {
        source.crs = *stated;
    } else {
        throw UserError(source.file +
                        ": the raster names no coordinate system; give it with --crs, for instance --crs EPSG:4326");
    }
    source.crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
}

/// Asked of the coordinates themselves: other names for WGS84, and systems that agree with it, need no interpolation.
bool is_plain(const RasterSource& source) {
    const auto& t = source.transform;
    if (source.crs.IsGeographic() == 0 || t[2] != 0 || t[4] != 0 || !(t[1] > 0) || !(t[5] < 0)) return false;
    const OGRSpatialReference wgs84 = wgs84_longitude_latitude();
    if (source.crs.IsSame(&wgs84) != 0) return true;
    const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&source.crs, &wgs84));
    if (change == nullptr) return false;
    const double columns = source.dataset->GetRasterXSize(), rows = source.dataset->GetRasterYSize();
    for (const double u : {0.0, 0.5, 1.0}) {
        for (const double v : {0.0, 0.5, 1.0}) {
            const double longitude = t[0] + u * columns * t[1], latitude = t[3] + v * rows * t[5];
            double x = longitude, y = latitude;
            if (change->Transform(1, &x, &y) == 0) return false;
            const double moved_x = std::abs(std::remainder(x - longitude, 360.0)), moved_y = std::abs(y - latitude);
            if (moved_x > kPlainShareOfPost * t[1] || moved_y > -kPlainShareOfPost * t[5]) return false;
        }
    }
    return true;
}

/// Nonzero where a value counts; empty where every one does.
std::vector<std::uint8_t> read_mask(GDALRasterBand& band, const PostWindow& w) {
    if ((band.GetMaskFlags() & GMF_ALL_VALID) != 0) return {};
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(w.columns) * static_cast<std::size_t>(w.rows));
    const CPLErr error =
        band.GetMaskBand()->RasterIO(GF_Read, w.i, w.j, w.columns, w.rows, mask.data(), w.columns, w.rows, GDT_Byte, 0, 0);
    return error == CE_None ? mask : std::vector<std::uint8_t>();
}

}  // namespace

OGRSpatialReference wgs84_longitude_latitude() {
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return wgs84;
}

RasterSource open_raster_source(const std::string& file, const RasterOptions& options) {
    GDALAllRegister();  // does nothing the second time
    RasterSource source;
    source.file = file;
    source.dataset = open_dataset(file);
    refuse_pictures(source);
    read_scale(source);
    read_place(source, options);
    source.plain = is_plain(source);
    return source;
}

std::vector<float> read_heights(const RasterSource& source, const PostWindow& w, const RasterOptions& options) {
    GDALRasterBand& band = *source.dataset->GetRasterBand(1);
    std::vector<float> heights(static_cast<std::size_t>(w.columns) * static_cast<std::size_t>(w.rows));
    CPLErrorReset();
    const CPLErr error =
        band.RasterIO(GF_Read, w.i, w.j, w.columns, w.rows, heights.data(), w.columns, w.rows, GDT_Float32, 0, 0);
    const std::vector<std::uint8_t> mask = read_mask(band, w);
    if (error != CE_None || CPLGetLastErrorType() >= CE_Failure)
        throw UserError(source.file + ": the raster ends early or is damaged (" + QuietGdal::last_message() +
                        "); get a whole copy");
    for (std::size_t n = 0; n < heights.size(); ++n) {
        const float raw = heights[n];
        const double height_m = raw * source.metres_per_count + source.offset_m;
        const bool is_void = (!mask.empty() && mask[n] == 0) ||
                             (options.void_value && raw == static_cast<float>(*options.void_value)) ||
                             !(height_m >= kLowestHeight_m && height_m <= kHighestHeight_m);
        heights[n] = is_void ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(height_m);
    }
    return heights;
}

}  // namespace tedavis::host_sim
