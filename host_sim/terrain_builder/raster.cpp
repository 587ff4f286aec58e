#include "host_sim/terrain_builder/raster.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kLowestHeight_m = -500;
constexpr double kHighestHeight_m = 9000;
constexpr std::int64_t kMaxPosts = std::int64_t{1} << 30;

using Dataset = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

/// Collects what GDAL would print, so that a fault becomes one sentence.
class QuietGdal {
public:
    QuietGdal() { CPLPushErrorHandler(CPLQuietErrorHandler); }
    ~QuietGdal() { CPLPopErrorHandler(); }
};

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A zip archive is opened through its first raster.
std::string inside_zip(const std::string& file) {
    if (!ends_with(file, ".zip")) return file;
    const std::string archive = "/vsizip/" + file;
    char** names = VSIReadDirRecursive(archive.c_str());
    std::string found;
    for (char** name = names; name != nullptr && *name != nullptr && found.empty(); ++name) {
        const std::string candidate = archive + "/" + *name;
        if (Dataset(GDALDataset::Open(candidate.c_str(), GDAL_OF_RASTER)) != nullptr) found = candidate;
    }
    CSLDestroy(names);
    if (found.empty()) throw UserError(file + ": no raster inside this archive; unpack it and name the height file");
    return found;
}

Dataset open_raster(const std::string& file) {
    VSIStatBufL info;
    if (VSIStatL(file.c_str(), &info) != 0) throw UserError(file + ": no such file; check the name");
    Dataset dataset(GDALDataset::Open(inside_zip(file).c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (dataset == nullptr || dataset->GetRasterCount() < 1)
        throw UserError(file + ": not a raster that GDAL can read (" + CPLGetLastErrorMsg() +
                        "); give a height raster such as GeoTIFF, HGT, HF2, TER or BT");
    double transform[6];
    if (dataset->GetGeoTransform(transform) != CE_None)
        throw UserError(file + ": the raster does not say where on Earth it lies; georeference it first");
    return dataset;
}

struct SpatialReferences {
    OGRSpatialReference own, wgs84;
    SpatialReferences() {
        wgs84.importFromEPSG(4326);
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    }
};

void read_crs(GDALDataset& dataset, const std::string& file, const RasterOptions& options, SpatialReferences& references) {
    if (options.crs) {
        if (references.own.SetFromUserInput(options.crs->c_str()) != OGRERR_NONE)
            throw UserError("--crs " + *options.crs + ": unknown coordinate system; use for instance EPSG:2056");
    } else if (const OGRSpatialReference* stated = dataset.GetSpatialRef()) {
        references.own = *stated;
    } else {
        throw UserError(file + ": the raster names no coordinate system; give it with --crs, for instance --crs EPSG:4326");
    }
    references.own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
}

/// North-up and in degrees of a WGS84-like system: its posts can be taken as they are.
bool is_plain_geographic(GDALDataset& dataset, const OGRSpatialReference& reference) {
    double t[6];
    dataset.GetGeoTransform(t);
    return reference.IsGeographic() && t[2] == 0 && t[4] == 0 && t[1] > 0 && t[5] < 0;
}

Dataset warp_to_geographic(std::vector<Dataset>& sources, const std::vector<std::string>& files, const RasterOptions& options) {
    CPLStringList arguments;
    for (const char* argument :
         {"-of", "MEM", "-t_srs", "EPSG:4326", "-r", "bilinear", "-ot", "Float32", "-dstnodata", "nan", "-wo", "NUM_THREADS=2"})
        arguments.AddString(argument);
    if (options.crs) {
        arguments.AddString("-s_srs");
        arguments.AddString(options.crs->c_str());
    }
    std::vector<GDALDatasetH> handles;
    for (Dataset& source : sources) handles.push_back(GDALDataset::ToHandle(source.get()));
    GDALWarpAppOptions* warp = GDALWarpAppOptionsNew(arguments.List(), nullptr);
    int usage_error = 0;
    Dataset warped(
        GDALDataset::FromHandle(GDALWarp("", nullptr, static_cast<int>(handles.size()), handles.data(), warp, &usage_error)));
    GDALWarpAppOptionsFree(warp);
    if (warped == nullptr)
        throw UserError(files.front() + ": cannot be brought to geographic coordinates (" + CPLGetLastErrorMsg() +
                        "); check its coordinate system");
    return warped;
}

struct Window {
    int i = 0, j = 0, columns = 0, rows = 0;
};

Window window_of(const double* t, int columns, int rows, const RasterOptions& options) {
    Window window{0, 0, columns, rows};
    if (!options.bounds) return window;
    // Posts are pixel centres; the window takes those inside the bounds.
    const double west = t[0] + 0.5 * t[1], north = t[3] + 0.5 * t[5];
    const GeoBounds& b = *options.bounds;
    const int first_i = std::max(0, static_cast<int>(std::ceil((b.west_deg - west) / t[1] - 1e-9)));
    const int last_i = std::min(columns - 1, static_cast<int>(std::floor((b.east_deg - west) / t[1] + 1e-9)));
    const int first_j = std::max(0, static_cast<int>(std::ceil((b.north_deg - north) / t[5] - 1e-9)));
    const int last_j = std::min(rows - 1, static_cast<int>(std::floor((b.south_deg - north) / t[5] + 1e-9)));
    if (last_i - first_i < 1 || last_j - first_j < 1)
        throw UserError("--bounds: no posts of the rasters lie inside; give W,S,E,N in degrees");
    return {first_i, first_j, last_i - first_i + 1, last_j - first_j + 1};
}

void classify(Raster& raster, const RasterOptions& options, bool has_no_data, double no_data) {
    raster.post_class.resize(raster.height_m.size());
    for (std::size_t n = 0; n < raster.height_m.size(); ++n) {
        float& height = raster.height_m[n];
        const bool is_void = !(height >= kLowestHeight_m && height <= kHighestHeight_m) ||
                             (has_no_data && height == static_cast<float>(no_data)) ||
                             (options.void_value && height == static_cast<float>(*options.void_value));
        if (is_void) {
            height = std::numeric_limits<float>::quiet_NaN();
            ++raster.void_posts;
        }
        raster.post_class[n] = is_void       ? terrain::PostClass::void_
                               : height == 0 ? terrain::PostClass::sea
                                             : terrain::PostClass::land;
    }
}

void to_msl(Raster& raster) {
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    for (std::uint32_t j = 0; j < raster.rows; ++j)
        for (std::uint32_t i = 0; i < raster.columns; ++i)
            raster.height_m[raster.at(i, j)] -=
                static_cast<float>(geoid
                                       .undulation(base::radians(raster.north_deg - raster.step_lat_deg * j),
                                                   base::radians(raster.west_deg + raster.step_lon_deg * i))
                                       .m);
}

Raster read_posts(GDALDataset& dataset, const std::string& file, const RasterOptions& options) {
    double t[6];
    dataset.GetGeoTransform(t);
    const Window window = window_of(t, dataset.GetRasterXSize(), dataset.GetRasterYSize(), options);
    if (window.columns < 2 || window.rows < 2) throw UserError(file + ": a raster needs at least 2 by 2 posts");
    if (std::int64_t{window.columns} * window.rows > kMaxPosts)
        throw UserError(file + ": more than 2^30 posts; build parts of it with --bounds");
    Raster raster;
    raster.columns = static_cast<std::uint32_t>(window.columns);
    raster.rows = static_cast<std::uint32_t>(window.rows);
    raster.step_lon_deg = t[1];
    raster.step_lat_deg = -t[5];
    raster.west_deg = t[0] + (window.i + 0.5) * t[1];
    raster.north_deg = t[3] + (window.j + 0.5) * t[5];
    raster.height_m.resize(std::size_t{raster.columns} * raster.rows);
    GDALRasterBand* band = dataset.GetRasterBand(1);
    if (band->RasterIO(GF_Read, window.i, window.j, window.columns, window.rows, raster.height_m.data(), window.columns,
                       window.rows, GDT_Float32, 0, 0) != CE_None)
        throw UserError(file + ": the raster ends early or is damaged (" + CPLGetLastErrorMsg() + "); get a whole copy");
    int has_no_data = 0;
    const double no_data = band->GetNoDataValue(&has_no_data);
    classify(raster, options, has_no_data != 0, no_data);
    return raster;
}

/// Scale and offset must be applied before heights are ranged or warped.
Dataset unscaled(Dataset dataset) {
    GDALRasterBand* band = dataset->GetRasterBand(1);
    int has_scale = 0, has_offset = 0;
    const double scale = band->GetScale(&has_scale), offset = band->GetOffset(&has_offset);
    if ((has_scale == 0 || scale == 1) && (has_offset == 0 || offset == 0)) return dataset;
    CPLStringList arguments;
    for (const char* argument : {"-of", "MEM", "-unscale", "-ot", "Float32"}) arguments.AddString(argument);
    GDALTranslateOptions* translate = GDALTranslateOptionsNew(arguments.List(), nullptr);
    int usage_error = 0;
    Dataset result(GDALDataset::FromHandle(GDALTranslate("", GDALDataset::ToHandle(dataset.get()), translate, &usage_error)));
    GDALTranslateOptionsFree(translate);
    return result;
}

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

Raster load_rasters(const std::vector<std::string>& files, const RasterOptions& options) {
    if (files.empty()) throw UserError("terrain build: no raster named; give at least one height file");
    GDALAllRegister();
    const QuietGdal quiet;
    std::vector<Dataset> sources;
    std::string names;
    bool plain = files.size() == 1;
    for (const std::string& file : files) {
        Dataset source = unscaled(open_raster(file));
        if (source == nullptr)
            throw UserError(file + ": the raster ends early or is damaged (" + CPLGetLastErrorMsg() + "); get a whole copy");
        SpatialReferences references;
        read_crs(*source, file, options, references);
        plain = plain && is_plain_geographic(*source, references.own);
        sources.push_back(std::move(source));
        names += (names.empty() ? "" : ", ") + base_name(file);
    }
    Dataset warped = plain ? nullptr : warp_to_geographic(sources, files, options);
    Raster raster = read_posts(plain ? *sources.front() : *warped, files.front(), options);
    raster.source = names;
    raster.resampled = !plain;
    if (raster.void_posts == raster.height_m.size())
        throw UserError(files.front() + ": no post has a height from -500 to 9000 m; check the file or its void value");
    if (options.vertical_datum == VerticalDatum::ellipsoid) to_msl(raster);
    return raster;
}

}  // namespace tedavis::host_sim
