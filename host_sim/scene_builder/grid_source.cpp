#include "host_sim/scene_builder/grid_source.hpp"

#include <cpl_string.h>
#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "host_sim/input_file.hpp"
#include "host_sim/name_choices.hpp"
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

GdalDataset open_or_refuse(const std::string& file) {
    GdalDataset dataset = open_quietly(file);
    if (dataset == nullptr)
        throw UserError(file + ": not a raster that GDAL can read (" + QuietGdal::last_message() +
                        "); give GeoTIFF, netCDF, GRIB or HDF5");
    return dataset;
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Names that open the variables of a container: NETCDF:"file":u, HDF5:"file"://dataset1/data1/data.
std::vector<std::string> names_in(GDALDataset& container) {
    const CPLStringList stated(container.GetMetadata("SUBDATASETS"), FALSE);
    std::vector<std::string> names;
    for (int n = 1;; ++n) {
        const char* const name = stated.FetchNameValue(CPLSPrintf("SUBDATASET_%d_NAME", n));
        if (name == nullptr) return names;
        names.emplace_back(name);
    }
}
std::vector<std::string> short_names(std::vector<std::string> names) {
    for (std::string& name : names) name.erase(0, name.find_last_of(':') + 1);
    return names;
}

std::string name_of_variable(GDALDataset& container, const std::string& file, const std::string& variable) {
    const std::vector<std::string> names = names_in(container);
    for (const std::string& name : names)
        if (ends_with(name, ":" + variable) || ends_with(name, "/" + variable)) return name;
    throw UserError(file + ": has no variable '" + variable + "'; choose one of " + name_choices(short_names(names)) +
                    look_hint(file));
}

std::optional<int> band_of(const std::string& variable) {
    if (variable.rfind("band ", 0) != 0) return std::nullopt;
    return static_cast<int>(std::strtol(variable.c_str() + 5, nullptr, 10));  // what is no number is no band
}

std::optional<double> number_of(GDALRasterBand& band, const char* key) {
    const char* const text = band.GetMetadataItem(key);
    return text != nullptr ? std::optional(CPLAtof(text)) : std::nullopt;
}

constexpr const char* kLevelAxes[] = {"level", "pressure_level", "height", "isobaricInhPa", "z", "lev"};

std::string text_or_empty(const char* text) { return text != nullptr ? text : ""; }

/// "hPa" of "850[hPa] ISBL (Isobaric surface)", "m/s" of "[m/s]"; a dash states no unit.
std::string in_brackets(const std::string& text) {
    const std::size_t begin = text.find('['), end = text.find(']', begin);
    if (begin == std::string::npos || end == std::string::npos) return "";
    const std::string unit = text.substr(begin + 1, end - begin - 1);
    return unit == "-" ? "" : unit;
}

/// Without the unit behind it; empty where GDAL does not know the variable.
std::string grib_comment(GDALRasterBand& band) {
    std::string text = text_or_empty(band.GetMetadataItem("GRIB_COMMENT"));
    text = text.substr(0, text.rfind(" ["));
    return text == "undefined" ? "" : text;
}

struct Level {
    double value = 0;
    std::string unit, kind;
};

/// GRIB 1 states pressures in hPa, GRIB 2 in Pa, and netCDF in either: each says so beside the number.
std::optional<Level> stated_level(GDALDataset& dataset, GDALRasterBand& band) {
    for (const char* const axis : kLevelAxes)
        if (const std::optional<double> value = number_of(band, CPLSPrintf("NETCDF_DIM_%s", axis)))
            return Level{*value, text_or_empty(dataset.GetMetadataItem((std::string(axis) + "#units").c_str())), ""};
    const char* const name = band.GetMetadataItem("GRIB_SHORT_NAME");
    if (name == nullptr) return std::nullopt;
    const std::string description = text_or_empty(band.GetDescription());
    Level level{CPLAtof(name), in_brackets(description), ""};
    const std::size_t begin = description.find_first_of("(\""), end = description.find_last_of(")\"");
    if (begin != std::string::npos && end > begin) level.kind = description.substr(begin + 1, end - begin - 1);
    return level;
}
/// Pressures in hPa, whatever the file's unit.
std::optional<Level> level_of(GDALDataset& dataset, GDALRasterBand& band) {
    std::optional<Level> level = stated_level(dataset, band);
    if (!level) return level;
    constexpr double kPascalsPerHectopascal = 100;
    if (level->unit == "Pa") level->value /= kPascalsPerHectopascal;
    for (const char* const pressure : {"Pa", "millibars", "millibar", "mbar", "mb"})
        if (level->unit == pressure) level->unit = "hPa";
    return level;
}

std::string variable_of(GDALRasterBand& band) {
    for (const char* const key : {"GRIB_ELEMENT", "NETCDF_VARNAME"})
        if (const char* const name = band.GetMetadataItem(key)) return name;
    return "";
}

/// "CH1903+ / LV95 (EPSG:2056)".
std::string system_text(const OGRSpatialReference& system) {
    const std::string name = text_or_empty(system.GetName()), number = text_or_empty(system.GetAuthorityCode(nullptr));
    return number.empty() ? name : name + " (" + text_or_empty(system.GetAuthorityName(nullptr)) + ":" + number + ")";
}

/// Of a radar composite (ODIM_H5, EUMETNET OPERA data model), as GDAL flattens its groups.
std::optional<double> odim_number(GDALDataset& dataset, const std::string& key) {
    const CPLStringList all(dataset.GetMetadata(), FALSE);
    for (int n = 0; n < all.size(); ++n) {
        const std::string line = all[n];
        const std::size_t equals = line.find('=');
        if (equals != std::string::npos && ends_with(line.substr(0, equals), "what_" + key)) return CPLAtof(&line[equals + 1]);
    }
    return std::nullopt;
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
    dataset_ = open_or_refuse(file);
    format_ = dataset_->GetDriverName();
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
    system_ = !crs.empty() ? crs : (stated != nullptr ? system_text(*stated) : "");
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
        throw UserError(file_ + ": has no " + variable + "; its bands are 1 to " + std::to_string(bands) + look_hint(file_));
    const GridTimes times(stating(), file_);
    for (int b = 1; b <= bands; ++b) {
        if (only && b != *only) continue;
        GDALRasterBand& band = *stating().GetRasterBand(b);  // the warped one says less
        const std::optional<Level> level = level_of(stating(), band);
        planes_.push_back(
            {b, times.of(band), level ? std::optional(level->value) : std::nullopt, times.reference_of(band), variable_of(band)});
    }
    if (!only && !variable.empty()) keep_variable(variable);
    for (const GridPlane& plane : planes_)
        if (unit_.empty()) unit_ = texts_of(plane).unit;
}

/// Bands of one file may be of several variables.
void GridSource::keep_variable(const std::string& variable) {
    std::vector<std::string> names;
    for (const GridPlane& plane : planes_)
        if (std::find(names.begin(), names.end(), plane.variable) == names.end()) names.push_back(plane.variable);
    if (names.size() < 2) return;
    const auto is_other = [&variable](const GridPlane& plane) { return plane.variable != variable; };
    planes_.erase(std::remove_if(planes_.begin(), planes_.end(), is_other), planes_.end());
    if (planes_.empty())
        throw UserError(file_ + ": has no variable '" + variable + "'; choose one of " + name_choices(names) + look_hint(file_));
}

PlaneTexts GridSource::texts_of(const GridPlane& plane) const {
    GDALRasterBand& band = *stating().GetRasterBand(plane.band);
    PlaneTexts texts;
    texts.unit = text_or_empty(band.GetUnitType());
    if (texts.unit.empty()) texts.unit = text_or_empty(band.GetMetadataItem("GRIB_UNIT"));
    if (texts.unit.rfind('[', 0) == 0) texts.unit = in_brackets(texts.unit);
    for (const char* const key : {"long_name", "standard_name"})
        if (texts.description.empty()) texts.description = text_or_empty(band.GetMetadataItem(key));
    if (texts.description.empty()) texts.description = grib_comment(band);
    if (texts.description.empty() && plane.variable.empty()) texts.description = text_or_empty(band.GetDescription());
    if (const std::optional<Level> level = level_of(stating(), band)) {
        texts.level_unit = level->unit;
        texts.level_kind = level->kind;
    }
    texts.missing = odim_number(stating(), "nodata");
    texts.undetected = odim_number(stating(), "undetect");
    return texts;
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

std::vector<std::string> rasters_inside(const std::string& file) {
    GDALAllRegister();
    require_regular_file(file);
    const QuietGdal quiet;
    const GdalDataset dataset = open_or_refuse(file);
    return dataset->GetRasterCount() > 0 ? std::vector<std::string>() : short_names(names_in(*dataset));
}

}  // namespace tedavis::host_sim
