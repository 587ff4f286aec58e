#include "host_sim/terrain_builder/raster_source.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/binary_terrain_header.hpp"
#include "host_sim/terrain_builder/height_encoding.hpp"
#include "host_sim/terrain_builder/stated_quantity.hpp"
#include "host_sim/terrain_builder/vertical_reference.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kPlainShareOfPost = 0.01;
constexpr int kColorBands = 3;

std::string driver_of(const RasterSource& source) { return source.dataset->GetDriverName(); }

/// Terragen files have a scale and a coordinate system of their own world, but no place on ours.
bool is_placed(const RasterSource& source) {
    std::array<double, 6> t{};
    if (source.dataset->GetGeoTransform(t.data()) != CE_None || driver_of(source) == "Terragen") return false;
    return std::all_of(t.begin(), t.end(), [](double x) { return std::isfinite(x); }) && t[1] * t[5] - t[2] * t[4] != 0;
}

void place_by_extent(RasterSource& source, const MapExtent& extent) {
    source.placed_by_options = true;
    source.transform = {extent.west, (extent.east - extent.west) / source.columns, 0, extent.north,
                        0,           (extent.south - extent.north) / source.rows};
}

void read_transform(RasterSource& source, const RasterOptions& options) {
    if (is_placed(source)) {
        source.dataset->GetGeoTransform(source.transform.data());
    } else if (options.extent) {
        place_by_extent(source, *options.extent);
    } else {
        throw UserError(source.file + ": the raster does not say where on Earth it lies; give its outer edges with --extent " +
                        "W,S,E,N, in degrees or in units of the system named with --crs");
    }
}

/// GDAL takes the zone in the header where the projection file is missing, and reads the wrong hemisphere of some.
void require_projection_file(const RasterSource& source) {
    if (driver_of(source) != "BT") return;
    const auto header = read_binary_terrain_header(source.dataset->GetDescription());
    const std::string projection = CPLResetExtension(source.dataset->GetDescription(), "prj");
    VSIStatBufL info;
    if (header && header->projection_file_needed && VSIStatL(projection.c_str(), &info) != 0)
        throw UserError(source.file + ": its coordinate system stands in " + projection +
                        ", which is missing; put it there or give the system with --crs");
}

OGRSpatialReference stated_crs(const RasterSource& source) {
    const OGRSpatialReference* const stated = source.dataset->GetSpatialRef();
    if (stated == nullptr || stated->IsEmpty() != 0)
        throw UserError(source.file +
                        ": the raster names no coordinate system; give it with --crs, for instance --crs EPSG:4326");
    if (stated->IsLocal() != 0)
        throw UserError(source.file + ": its coordinate system '" + stated->GetName() +
                        "' has no place on Earth; give the right one with --crs");
    require_projection_file(source);
    return *stated;
}

/// With its vertical part, where there is one.
OGRSpatialReference read_crs(const RasterSource& source, const RasterOptions& options) {
    if (!options.crs) return source.placed_by_options ? wgs84_longitude_latitude() : stated_crs(source);
    OGRSpatialReference crs;
    if (crs.SetFromUserInput(options.crs->c_str()) != OGRERR_NONE)
        throw UserError("--crs " + *options.crs + ": unknown coordinate system; use for instance EPSG:2056");
    return crs;
}

/// The first that says anything: the option, the file's coordinate system, its other marks.
VerticalReference read_vertical_reference(const RasterSource& source, const OGRSpatialReference& crs) {
    VerticalReference reference = vertical_reference(crs);
    const OGRSpatialReference* const stated = source.dataset->GetSpatialRef();
    if (!reference.datum && stated != nullptr && stated->IsLocal() == 0) reference = vertical_reference(*stated);
    const VerticalReference band = vertical_reference_of_band(*source.dataset);
    if (!reference.datum) {
        reference.datum = band.datum;
        reference.name = band.name;
    }
    reference.is_depth = reference.is_depth || band.is_depth;
    if (reference.unit.empty()) reference.unit = band.unit;
    return reference;
}

void settle_datum(RasterSource& source, const VerticalReference& reference, const RasterOptions& options) {
    const auto word = [](VerticalDatum datum) { return datum == VerticalDatum::egm96 ? "egm96" : "ellipsoid"; };
    if (reference.is_depth)
        throw UserError(source.file + ": holds depths, positive downwards (" + reference.name +
                        "); give heights, positive upwards");
    if (reference.datum && options.vertical_datum && *reference.datum != *options.vertical_datum)
        throw UserError(source.file + ": says that its heights are above '" + reference.name +
                        "', which contradicts --vertical-datum " + word(*options.vertical_datum) +
                        "; leave the option out or correct the file");
    source.datum = reference.datum.value_or(options.vertical_datum.value_or(VerticalDatum::egm96));
    if (is_other_sea_level(reference))
        source.notes.push_back(source.file + ": its heights are above '" + reference.name +
                               "'; they are taken for heights above EGM96, from which that datum may differ");
}

void read_scale(RasterSource& source, const VerticalReference& reference) {
    GDALRasterBand* const band = source.dataset->GetRasterBand(1);
    const std::string of_band = band->GetUnitType(), unit = of_band.empty() ? reference.unit : of_band;
    std::optional<double> metres = metres_per_unit(unit);
    if (driver_of(source) == "BT") {
        const auto header = read_binary_terrain_header(source.dataset->GetDescription());
        if (header) metres = header->metres_per_unit;
    }
    if (!metres) throw UserError(source.file + ": its values are in '" + unit + "', which is no length; give a height raster");
    source.metres_per_count = band->GetScale() * *metres;
    source.offset_m = band->GetOffset() * *metres;
    if (!std::isfinite(source.metres_per_count) || !std::isfinite(source.offset_m) || source.metres_per_count == 0)
        throw UserError(source.file + ": its scale and offset are no usable numbers; correct the raster's metadata");
}

bool has_color_bytes(GDALDataset& dataset) {
    bool bytes = dataset.GetRasterCount() >= kColorBands;
    for (int band = 1; bytes && band <= kColorBands; ++band) bytes = dataset.GetRasterBand(band)->GetRasterDataType() == GDT_Byte;
    return bytes;
}

bool is_lossy(const RasterSource& source) {
    const char* const compression = source.dataset->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE");
    return driver_of(source) == "JPEG" || (compression != nullptr && std::string(compression).find("JPEG") != std::string::npos);
}

void settle_encoding(RasterSource& source, const RasterOptions& options) {
    GDALRasterBand* const band = source.dataset->GetRasterBand(1);
    const GDALColorInterp meaning = band->GetColorInterpretation();
    const bool color =
        meaning == GCI_RedBand || meaning == GCI_GreenBand || meaning == GCI_BlueBand || meaning == GCI_PaletteIndex;
    if (options.encoding && has_color_bytes(*source.dataset)) {
        if (is_lossy(source))
            throw UserError(source.file +
                            ": its colours were compressed with loss, so they hold no heights any more; give the "
                            "PNG or another lossless file");
        source.encoding = options.encoding;
    } else if (color || GDALDataTypeIsComplex(band->GetRasterDataType()) != 0) {
        throw UserError(source.file + ": its first band holds colours or complex numbers, no heights; give a height raster, or " +
                        "say with --encoding how 8-bit RGB colours hold heights");
    }
}

void require_heights(const RasterSource& source) {
    if (const auto other = other_quantity(*source.dataset))
        throw UserError(source.file + ": says that it holds " + *other +
                        ", which is no height; give a height raster (other data are for 'tedavis scene build')");
}

/// Asked of the coordinates themselves: other names for WGS84, and systems that agree with it, need no interpolation.
bool is_plain(const RasterSource& source) {
    const auto& t = source.transform;
    if (source.crs.IsGeographic() == 0 || t[2] != 0 || t[4] != 0 || !(t[1] > 0) || !(t[5] < 0)) return false;
    const OGRSpatialReference wgs84 = wgs84_longitude_latitude();
    if (source.crs.IsSame(&wgs84) != 0) return true;
    const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&source.crs, &wgs84));
    if (change == nullptr) return false;
    const double columns = source.columns, rows = source.rows;
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

std::size_t posts_in(const PostWindow& w) { return static_cast<std::size_t>(w.columns) * static_cast<std::size_t>(w.rows); }

/// Nonzero where a value counts; empty where every one does. A colour by itself marks nothing in an encoded height.
std::vector<std::uint8_t> read_mask(const RasterSource& source, const PostWindow& w) {
    GDALRasterBand& band = *source.dataset->GetRasterBand(1);
    const int flags = band.GetMaskFlags();
    if ((flags & GMF_ALL_VALID) != 0 || (source.encoding && (flags & GMF_NODATA) != 0)) return {};
    std::vector<std::uint8_t> mask(posts_in(w));
    const CPLErr error =
        band.GetMaskBand()->RasterIO(GF_Read, w.i, w.j, w.columns, w.rows, mask.data(), w.columns, w.rows, GDT_Byte, 0, 0);
    return error == CE_None ? mask : std::vector<std::uint8_t>();
}

/// The numbers as they are stored, or the metres that colours hold; false where the file does not give them.
bool read_raw(const RasterSource& source, const PostWindow& w, std::vector<float>& raw) {
    if (!source.encoding)
        return source.dataset->GetRasterBand(1)->RasterIO(GF_Read, w.i, w.j, w.columns, w.rows, raw.data(), w.columns, w.rows,
                                                          GDT_Float32, 0, 0) == CE_None;
    std::vector<std::uint8_t> colors(raw.size() * kColorBands);
    int bands[kColorBands] = {1, 2, 3};
    if (source.dataset->RasterIO(GF_Read, w.i, w.j, w.columns, w.rows, colors.data(), w.columns, w.rows, GDT_Byte, kColorBands,
                                 bands, kColorBands, GSpacing{kColorBands} * w.columns, 1) != CE_None)
        return false;
    for (std::size_t n = 0; n < raw.size(); ++n) {
        const std::uint8_t* const c = &colors[n * kColorBands];
        raw[n] = static_cast<float>(decoded_height_m(*source.encoding, c[0], c[1], c[2]));
    }
    return true;
}

}  // namespace

OGRSpatialReference wgs84_longitude_latitude() {
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return wgs84;
}

RasterSource open_raster_source(const std::string& file, const RasterOptions& options) {
    // Without these, GDAL keeps what GeoTIFF, HGT and DTED files say about their vertical datum to itself.
    const CPLConfigOptionSetter geotiff("GTIFF_REPORT_COMPD_CS", "YES", false), others("REPORT_COMPD_CS", "YES", false);
    RasterSource source;
    source.file = file;
    source.dataset = open_raster_file(file);
    source.columns = source.dataset->GetRasterXSize();
    source.rows = source.dataset->GetRasterYSize();
    settle_encoding(source, options);
    read_transform(source, options);
    const OGRSpatialReference crs = read_crs(source, options);
    const VerticalReference reference = read_vertical_reference(source, crs);
    settle_datum(source, reference, options);
    read_scale(source, reference);
    require_heights(source);
    source.crs = horizontal_part(crs);
    source.plain = is_plain(source);
    const int bands = source.dataset->GetRasterCount();
    if (bands > 1 && !source.encoding)
        source.notes.push_back(file + ": has " + std::to_string(bands) + " bands; heights are taken from the first");
    return source;
}

std::vector<float> read_heights(const RasterSource& source, const PostWindow& w, const RasterOptions& options) {
    CPLErrorReset();
    std::vector<float> heights(posts_in(w));
    const bool whole = read_raw(source, w, heights);
    const std::vector<std::uint8_t> mask = read_mask(source, w);
    if (!whole || CPLGetLastErrorType() >= CE_Failure)
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
