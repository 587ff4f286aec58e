#include "host_sim/scene_builder/grid_source.hpp"

#include <cpl_string.h>
#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "host_sim/input_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/quiet_stdout.hpp"
#include "host_sim/scene_builder/grid_times.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kFullTurn_deg = 360;

/// GDAL's reader of GRIB prints by itself of what follows the last message.
GdalDataset open_quietly(const std::string& name) {
    const QuietStdout quiet;
    return GdalDataset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The name that opens a variable of a container: NETCDF:"file":u, HDF5:"file"://dataset1/data1/data.
std::string name_of_variable(GDALDataset& container, const std::string& file, const std::string& variable) {
    const CPLStringList names(container.GetMetadata("SUBDATASETS"), FALSE);
    std::string choices;
    for (int n = 1;; ++n) {
        const char* const name = names.FetchNameValue(CPLSPrintf("SUBDATASET_%d_NAME", n));
        if (name == nullptr) break;
        if (ends_with(name, ":" + variable) || ends_with(name, "/" + variable)) return name;
        const std::string whole(name);
        choices += (choices.empty() ? "" : ", ") + whole.substr(whole.find_last_of(':') + 1);
    }
    throw UserError(file + ": has no variable '" + variable + "'; choose one of " + (choices.empty() ? "none" : choices));
}

std::optional<int> band_of(const std::string& variable) {
    if (variable.rfind("band ", 0) != 0) return std::nullopt;
    return static_cast<int>(std::strtol(variable.c_str() + 5, nullptr, 10));  // what is no number is no band
}

std::optional<double> number_of(GDALRasterBand& band, const char* key) {
    const char* const text = band.GetMetadataItem(key);
    return text != nullptr ? std::optional(CPLAtof(text)) : std::nullopt;
}

/// GRIB's "50000-ISBL" is a pressure in Pa, given in hPa as netCDF does; other levels are as they are.
std::optional<double> level_of(GDALRasterBand& band) {
    for (const char* const key : {"NETCDF_DIM_level", "NETCDF_DIM_pressure_level", "NETCDF_DIM_height",
                                  "NETCDF_DIM_isobaricInhPa", "NETCDF_DIM_z", "NETCDF_DIM_lev"})
        if (const std::optional<double> level = number_of(band, key)) return level;
    const char* const name = band.GetMetadataItem("GRIB_SHORT_NAME");
    if (name == nullptr) return std::nullopt;
    const std::string text(name);
    return ends_with(text, "-ISBL") ? std::optional(CPLAtof(name) / 100) : CPLAtof(name);
}

/// netCDF's conventions name the units of its axes where they name no system.
bool states_degrees(GDALDataset& dataset) {
    for (const char* const axis : {"longitude#units", "lon#units"}) {
        const char* const unit = dataset.GetMetadataItem(axis);
        if (unit != nullptr && std::string(unit).rfind("degree", 0) == 0) return true;
    }
    return false;
}

/// All of it, not one corner: metres near the origin of a local system begin like degrees.
bool looks_geographic(GDALDataset& dataset, const double (&transform)[6]) {
    constexpr double kMaxLatitude_deg = 91;  // corners of pixels whose middles are posts
    const double columns = dataset.GetRasterXSize(), rows = dataset.GetRasterYSize();
    const double east = transform[0] + columns * transform[1], south = transform[3] + rows * transform[5];
    const bool is_on_earth = std::abs(transform[0]) <= kFullTurn_deg && std::abs(east) <= 2 * kFullTurn_deg &&
                             std::abs(transform[3]) <= kMaxLatitude_deg && std::abs(south) <= kMaxLatitude_deg;
    return is_on_earth && std::abs(east - transform[0]) <= kFullTurn_deg + std::abs(transform[1]);
}

}  // namespace

GridSource::GridSource(const std::string& file, const std::string& variable, const std::string& crs, bool may_blend)
    : file_(file) {
    GDALAllRegister();
    require_regular_file(file);
    const QuietGdal quiet;
    open(file, variable);
    warp_to_longitude_latitude(crs, may_blend);
    read_places();
    list_planes(variable);
}

void GridSource::open(const std::string& file, const std::string& variable) {
    dataset_ = open_quietly(file);
    if (dataset_ == nullptr)
        throw UserError(file + ": not a raster that GDAL can read (" + QuietGdal::last_message() +
                        "); give GeoTIFF, netCDF, GRIB or HDF5");
    if (dataset_->GetRasterCount() > 0) return;
    const std::string name = name_of_variable(*dataset_, file, variable);
    container_ = std::move(dataset_);
    dataset_ = open_quietly(name);
    if (dataset_ == nullptr || dataset_->GetRasterCount() == 0)
        throw UserError(file + ": variable '" + variable + "' cannot be read (" + QuietGdal::last_message() +
                        "); check the file");
}

void GridSource::warp_to_longitude_latitude(const std::string& crs, bool may_blend) {
    const OGRSpatialReference* const stated = dataset_->GetSpatialRef();
    double transform[6];
    const bool has_places = dataset_->GetGeoTransform(transform) == CE_None;
    if (stated == nullptr && crs.empty()) {
        if (!has_places || !looks_geographic(*dataset_, transform))
            throw UserError(file_ + ": does not say in which reference system it lies; name it with crs = \"EPSG:...\"");
        is_assumed_ = !states_degrees(*dataset_);
        return;
    }
    const bool is_turned = has_places && (transform[2] != 0 || transform[4] != 0);
    if (crs.empty() && stated != nullptr && stated->IsGeographic() != 0 && has_places && !is_turned) return;
    CPLStringList words;
    for (const char* const word : {"-of", "VRT", "-t_srs", "EPSG:4326", "-dstnodata", "nan", "-ot", "Float64", "-r"})
        words.AddString(word);
    words.AddString(may_blend ? "bilinear" : "near");
    if (!crs.empty()) words.AddString("-s_srs"), words.AddString(crs.c_str());
    GDALWarpAppOptions* const options = GDALWarpAppOptionsNew(words.List(), nullptr);
    GDALDatasetH from = dataset_.get();
    GdalDataset warped(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &from, options, nullptr)));
    GDALWarpAppOptionsFree(options);
    if (warped == nullptr)
        throw UserError(file_ + ": cannot be brought to longitude and latitude (" + QuietGdal::last_message() + "); check 'crs'");
    unwarped_ = std::move(dataset_);
    dataset_ = std::move(warped);
}

void GridSource::read_places() {
    double t[6];
    if (dataset_->GetGeoTransform(t) != CE_None || !(t[1] != 0) || !(t[5] != 0))
        throw UserError(file_ + ": does not say where on the Earth it lies; give a file with a geotransform");
    places_.columns = dataset_->GetRasterXSize();
    places_.rows = dataset_->GetRasterYSize();
    flips_columns_ = t[1] < 0;
    flips_rows_ = t[5] > 0;
    places_.step_lon_deg = std::abs(t[1]);
    places_.step_lat_deg = std::abs(t[5]);
    const double first_lon_deg = t[0] + 0.5 * t[1], first_lat_deg = t[3] + 0.5 * t[5];
    places_.west_deg = flips_columns_ ? first_lon_deg + t[1] * (places_.columns - 1) : first_lon_deg;
    places_.north_deg = flips_rows_ ? first_lat_deg + t[5] * (places_.rows - 1) : first_lat_deg;
    places_.west_deg -= kFullTurn_deg * std::floor((places_.west_deg + 180) / kFullTurn_deg);
    const double south_deg = places_.north_deg - places_.step_lat_deg * (places_.rows - 1);
    if (!(places_.north_deg <= 90 + 1e-6) || !(south_deg >= -90 - 1e-6))
        throw UserError(file_ + ": its rows reach beyond the poles; name its reference system with crs = \"EPSG:...\"");
    if (places_.step_lon_deg * (places_.columns - 1) > kFullTurn_deg + 1e-6)
        throw UserError(file_ +
                        ": its columns reach more than once round the Earth; name its reference system with crs = \"EPSG:...\"");
}

void GridSource::list_planes(const std::string& variable) {
    const std::optional<int> only = band_of(variable);
    const int bands = dataset_->GetRasterCount();
    if (only && (*only < 1 || *only > bands))
        throw UserError(file_ + ": has no " + variable + "; its bands are 1 to " + std::to_string(bands));
    const GridTimes times(unwarped_ != nullptr ? *unwarped_ : *dataset_, file_);
    for (int b = 1; b <= bands; ++b) {
        if (only && b != *only) continue;
        GDALRasterBand& band = *(unwarped_ != nullptr ? unwarped_ : dataset_)->GetRasterBand(b);  // the warped one says less
        planes_.push_back({b, times.of(band), level_of(band), times.reference_of(band)});
        if (unit_.empty()) unit_ = band.GetUnitType();
    }
}

std::vector<float> GridSource::read(const GridPlane& plane) const {
    const QuietGdal quiet;
    GDALRasterBand& band = *dataset_->GetRasterBand(plane.band);
    const auto columns = static_cast<std::size_t>(places_.columns), rows = static_cast<std::size_t>(places_.rows);
    std::vector<double> stated(columns * rows);
    if (band.RasterIO(GF_Read, 0, 0, places_.columns, places_.rows, stated.data(), places_.columns, places_.rows, GDT_Float64, 0,
                      0) != CE_None)
        throw UserError(file_ + ": band " + std::to_string(plane.band) + " cannot be read (" + QuietGdal::last_message() +
                        "); get a whole copy");
    std::vector<std::uint8_t> mask(stated.size(), 1);
    if ((band.GetMaskFlags() & GMF_ALL_VALID) == 0 &&
        band.GetMaskBand()->RasterIO(GF_Read, 0, 0, places_.columns, places_.rows, mask.data(), places_.columns, places_.rows,
                                     GDT_Byte, 0, 0) != CE_None)
        throw UserError(file_ + ": the mask of band " + std::to_string(plane.band) + " cannot be read (" +
                        QuietGdal::last_message() + "); get a whole copy");
    int has_scale = 0, has_offset = 0;
    double scale = band.GetScale(&has_scale), offset = band.GetOffset(&has_offset);
    if (has_scale == 0) scale = 1;
    if (has_offset == 0) offset = 0;
    std::vector<float> values(stated.size());
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t row = flips_rows_ ? rows - 1 - j : j, column = flips_columns_ ? columns - 1 - i : i;
            const double value = stated[row * columns + column];
            const bool is_missing = std::isnan(value) || mask[row * columns + column] == 0;
            values[j * columns + i] =
                is_missing ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(value * scale + offset);
        }
    return values;
}

}  // namespace tedavis::host_sim
