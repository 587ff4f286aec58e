#include "host_sim/terrain_builder/raster.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster_mosaic.hpp"
#include "host_sim/terrain_builder/raster_source.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kMostPosts = 1u << 30;
constexpr double kSnap = 1e-9;  // of a step: what rounding may take

void require_size(double columns, double rows, const std::string& file, const RasterOptions& options) {
    if (options.bounds && (columns < 2 || rows < 2))
        throw UserError("--bounds: fewer than 2 by 2 posts of " + file + " lie inside; give W,S,E,N in degrees");
    if (columns < 2 || rows < 2) throw UserError(file + ": a raster needs at least 2 by 2 posts");
    if (columns * rows > kMostPosts) throw UserError(file + ": more than 2^30 posts; build parts of it with --bounds");
}

/// First and last post of an axis inside an interval, where post n lies at first + n * step.
std::pair<int, int> posts_within(double first, double step, int count, double low, double high) {
    const double from = std::ceil(std::min((low - first) / step, (high - first) / step) - kSnap);
    const double to = std::floor(std::max((low - first) / step, (high - first) / step) + kSnap);
    return {static_cast<int>(std::clamp(from, 0.0, static_cast<double>(count))),
            static_cast<int>(std::clamp(to, -1.0, count - 1.0))};
}

PostWindow window_of(const RasterSource& source, const RasterOptions& options) {
    const int columns = source.dataset->GetRasterXSize(), rows = source.dataset->GetRasterYSize();
    if (!options.bounds) return {0, 0, columns, rows};
    const auto& t = source.transform;
    const GeoBounds& b = *options.bounds;
    // The same meridian has many names; the one nearest to the raster is meant.
    const double middle_deg = t[0] + 0.5 * columns * t[1];
    const double turns_deg = 360 * std::round((middle_deg - 0.5 * (b.west_deg + b.east_deg)) / 360);
    const auto [west, east] = posts_within(t[0] + 0.5 * t[1], t[1], columns, b.west_deg + turns_deg, b.east_deg + turns_deg);
    const auto [north, south] = posts_within(t[3] + 0.5 * t[5], t[5], rows, b.south_deg, b.north_deg);
    return {west, north, east - west + 1, south - north + 1};
}

/// Coordinates that are not degrees on Earth betray a wrong coordinate system.
void require_place(const Raster& raster, const std::string& file) {
    const double south_deg = raster.north_deg - raster.step_lat_deg * (raster.rows - 1),
                 width_deg = raster.step_lon_deg * (raster.columns - 1);
    if (!(raster.north_deg <= 90 && south_deg >= -90 && std::abs(raster.west_deg) <= 720 && width_deg <= 360))
        throw UserError(
            file + ": its posts lie beyond the poles or more than once round the Earth; give its coordinate system with --crs");
}

Raster take_posts(const RasterSource& source, const RasterOptions& options) {
    const PostWindow window = window_of(source, options);
    require_size(window.columns, window.rows, source.file, options);
    const auto& t = source.transform;
    Raster raster;
    raster.columns = static_cast<std::uint32_t>(window.columns);
    raster.rows = static_cast<std::uint32_t>(window.rows);
    raster.step_lon_deg = t[1];
    raster.step_lat_deg = -t[5];
    raster.west_deg = t[0] + (window.i + 0.5) * t[1];
    raster.north_deg = t[3] + (window.j + 0.5) * t[5];
    raster.height_m = read_heights(source, window, options);
    return raster;
}

Raster interpolate_posts(const std::vector<RasterSource>& sources, const RasterOptions& options) {
    const GeoLattice lattice = plan_lattice(sources, options);
    require_size(static_cast<double>(lattice.columns), static_cast<double>(lattice.rows), sources.front().file, options);
    Raster raster;
    raster.columns = static_cast<std::uint32_t>(lattice.columns);
    raster.rows = static_cast<std::uint32_t>(lattice.rows);
    raster.step_lon_deg = lattice.step_lon_deg;
    raster.step_lat_deg = lattice.step_lat_deg;
    raster.west_deg = lattice.west_deg;
    raster.north_deg = lattice.north_deg;
    raster.height_m = warp_heights(sources, lattice, options);
    raster.resampled = true;
    return raster;
}

void to_msl(Raster& raster) {
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    for (std::uint32_t j = 0; j < raster.rows; ++j) {
        const double latitude_rad = base::radians(raster.north_deg - raster.step_lat_deg * j);
        for (std::uint32_t i = 0; i < raster.columns; ++i) {
            const double longitude_rad = base::radians(raster.west_deg + raster.step_lon_deg * i);
            raster.height_m[raster.at(i, j)] -= static_cast<float>(geoid.undulation(latitude_rad, longitude_rad).m);
        }
    }
}

void classify(Raster& raster, VerticalDatum datum) {
    using terrain::PostClass;
    raster.post_class.resize(raster.height_m.size());
    for (std::size_t n = 0; n < raster.height_m.size(); ++n) {
        const float height_m = raster.height_m[n];
        const bool is_void = std::isnan(height_m), is_sea = datum == VerticalDatum::egm96 && height_m == 0;
        raster.post_class[n] = is_void ? PostClass::void_ : is_sea ? PostClass::sea : PostClass::land;
        raster.void_posts += is_void ? 1 : 0;
    }
}

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

Raster load_rasters(const std::vector<std::string>& files, const RasterOptions& options) {
    if (files.empty()) throw UserError("terrain build: no raster named; give at least one height file");
    const QuietGdal quiet;
    std::vector<RasterSource> sources;
    std::string names;
    std::vector<std::string> notes;
    for (const std::string& file : files) {
        sources.push_back(open_raster_source(file, options));
        const int bands = sources.back().dataset->GetRasterCount();
        if (bands > 1) notes.push_back(file + ": has " + std::to_string(bands) + " bands; heights are taken from the first");
        names += (names.empty() ? "" : ", ") + base_name(file);
    }
    const bool as_they_are = sources.size() == 1 && sources.front().plain;
    Raster raster = as_they_are ? take_posts(sources.front(), options) : interpolate_posts(sources, options);
    require_place(raster, files.front());
    raster.west_deg -= 360 * std::floor((raster.west_deg + 180) / 360);
    raster.source = names;
    raster.notes = std::move(notes);
    if (options.vertical_datum == VerticalDatum::ellipsoid) to_msl(raster);
    classify(raster, options.vertical_datum);
    if (raster.void_posts == raster.height_m.size())
        throw UserError(files.front() + ": no post has a height from -500 to 9000 m; check the file or its void value");
    return raster;
}

}  // namespace tedavis::host_sim
