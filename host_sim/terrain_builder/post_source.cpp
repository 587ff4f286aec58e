#include "host_sim/terrain_builder/post_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kBoundRounding = 1e-9;  // of a step: what rounding may take

void require_size(double columns, double rows, const std::string& file, const RasterOptions& options) {
    if (options.bounds && (columns < 2 || rows < 2))
        throw UserError("--bounds: fewer than 2 by 2 posts of " + file + " lie inside; give W,S,E,N in degrees");
    if (columns < 2 || rows < 2) throw UserError(file + ": has fewer than 2 by 2 posts; give a larger raster");
    if (std::max(columns, rows) > PostSource::kMaxPostsOfASide)
        throw UserError(file + ": more than 2^24 posts a side; build parts of it with --bounds");
}

/// First and last post of an axis inside an interval, where post n lies at first + n * step.
std::pair<int, int> posts_within(double first, double step, int count, double low, double high) {
    const double from = std::ceil(std::min((low - first) / step, (high - first) / step) - kBoundRounding);
    const double to = std::floor(std::max((low - first) / step, (high - first) / step) + kBoundRounding);
    return {static_cast<int>(std::clamp(from, 0.0, static_cast<double>(count))),
            static_cast<int>(std::clamp(to, -1.0, count - 1.0))};
}

PostWindow window_of(const RasterSource& source, const RasterOptions& options) {
    if (!options.bounds) return {0, 0, source.columns, source.rows};
    const auto& t = source.transform;
    const GeoBounds& b = *options.bounds;
    // The same meridian has many names; the one nearest to the raster is meant.
    const double middle_deg = t[0] + 0.5 * source.columns * t[1];
    const double turns_deg = 360 * std::round((middle_deg - 0.5 * (b.west_deg + b.east_deg)) / 360);
    const auto [west, east] =
        posts_within(t[0] + 0.5 * t[1], t[1], source.columns, b.west_deg + turns_deg, b.east_deg + turns_deg);
    const auto [north, south] = posts_within(t[3] + 0.5 * t[5], t[5], source.rows, b.south_deg, b.north_deg);
    return {west, north, east - west + 1, south - north + 1};
}

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

/// Options that are meant for some of the files must meet one.
void require_options_used(const std::vector<RasterSource>& sources, const RasterOptions& options) {
    std::size_t placed = 0, encoded = 0;
    for (const RasterSource& source : sources) {
        placed += source.placed_by_options ? 1 : 0;
        encoded += source.encoding ? 1 : 0;
    }
    const std::string& first = sources.front().file;
    if (options.extent && placed == 0) throw UserError("--extent: " + first + " says itself where it lies; leave the option out");
    if (placed > 1)
        throw UserError("--extent: more than one file does not say where it lies; build from one of them, or georeference them");
    if (options.encoding && encoded == 0)
        throw UserError("--encoding: " + first + " has no three bands of 8 bits that could hold heights; leave the option out");
}

}  // namespace

PostSource::PostSource(const std::vector<std::string>& files, const RasterOptions& options) : options_(options) {
    if (files.empty()) throw UserError("terrain build: no raster named; give at least one height file");
    const QuietGdal quiet;
    GDALSetCacheMax64(kBlockCacheBytes);
    open_sources(files);
    require_options_used(sources_, options_);
    taken_ = sources_.size() == 1 && sources_.front().plain;
    if (taken_) {
        plan_taken();
    } else {
        plan_interpolated();
    }
    require_place(files.front());
    grid_.west_deg -= 360 * std::floor((grid_.west_deg + 180) / 360);
}

void PostSource::open_sources(const std::vector<std::string>& files) {
    std::size_t ellipsoidal = 0;
    for (const std::string& file : files) {
        sources_.push_back(open_raster_source(file, options_));
        RasterSource& source = sources_.back();
        notes_.insert(notes_.end(), source.notes.begin(), source.notes.end());
        grid_.source += (grid_.source.empty() ? "" : ", ") + base_name(file);
        ellipsoidal += source.datum == VerticalDatum::ellipsoid ? 1 : 0;
        (void)opened(sources_.size() - 1);
    }
    if (ellipsoidal > 0) geoid_ = GeoidEgm96::installed();
    if (ellipsoidal == files.size()) grid_.vertical_datum = VerticalDatum::ellipsoid;
}

void PostSource::plan_taken() {
    const RasterSource& source = sources_.front();
    taken_window_ = window_of(source, options_);
    require_size(taken_window_.columns, taken_window_.rows, source.file, options_);
    const auto& t = source.transform;
    grid_.columns = static_cast<std::uint32_t>(taken_window_.columns);
    grid_.rows = static_cast<std::uint32_t>(taken_window_.rows);
    grid_.step_lon_deg = t[1];
    grid_.step_lat_deg = -t[5];
    grid_.west_deg = t[0] + (taken_window_.i + 0.5) * t[1];
    grid_.north_deg = t[3] + (taken_window_.j + 0.5) * t[5];
}

void PostSource::plan_interpolated() {
    const GeoLattice lattice = plan_lattice(sources_, options_);
    require_size(static_cast<double>(lattice.columns), static_cast<double>(lattice.rows), sources_.front().file, options_);
    for (const RasterSource& source : sources_) interpolators_.emplace_back(source, lattice);
    grid_.columns = static_cast<std::uint32_t>(lattice.columns);
    grid_.rows = static_cast<std::uint32_t>(lattice.rows);
    grid_.step_lon_deg = lattice.step_lon_deg;
    grid_.step_lat_deg = lattice.step_lat_deg;
    grid_.west_deg = lattice.west_deg;
    grid_.north_deg = lattice.north_deg;
}

/// Coordinates that are not degrees on Earth betray a wrong coordinate system.
void PostSource::require_place(const std::string& file) const {
    const double south_deg = grid_.north_deg - grid_.step_lat_deg * (grid_.rows - 1),
                 width_deg = grid_.step_lon_deg * (grid_.columns - 1);
    if (!(grid_.north_deg <= 90 && south_deg >= -90 && std::abs(grid_.west_deg) <= 720 && width_deg <= 360))
        throw UserError(
            file + ": its posts lie beyond the poles or more than once round the Earth; give its coordinate system with --crs");
}

RasterSource& PostSource::opened(std::size_t source) {
    open_.erase(std::remove(open_.begin(), open_.end(), source), open_.end());
    open_.push_back(source);
    if (open_.size() > kMaxOpenFiles) {
        sources_[open_.front()].dataset.reset();
        open_.pop_front();
    }
    RasterSource& wanted = sources_[source];
    if (wanted.dataset == nullptr) wanted.dataset = open_raster_file(wanted.file);
    return wanted;
}

void PostSource::put(const Window& window, std::int64_t i, std::int64_t j, float height_m, VerticalDatum datum) const {
    if (std::isnan(height_m)) return;
    const std::size_t at = window.at(i, j);
    const bool is_sea = datum == VerticalDatum::egm96 && height_m == 0;
    if (datum == VerticalDatum::ellipsoid) {
        const double latitude_rad = base::radians(grid_.north_deg - grid_.step_lat_deg * static_cast<double>(j));
        const double longitude_rad = base::radians(grid_.west_deg + grid_.step_lon_deg * static_cast<double>(i));
        height_m -= static_cast<float>(geoid_->undulation(latitude_rad, longitude_rad).m);
    }
    window.heights_m[at] = height_m;
    window.classes[at] = is_sea ? terrain::PostClass::sea : terrain::PostClass::land;
}

void PostSource::take(const Window& window) {
    constexpr std::int64_t kPostsAtOnce = 1 << 20;
    const RasterSource& source = opened(0);
    const std::int64_t rows_at_once = std::max<std::int64_t>(1, kPostsAtOnce / window.columns),
                       end = std::int64_t{window.j} + window.rows;
    for (std::int64_t j = window.j; j < end; j += rows_at_once) {
        const std::int64_t rows = std::min(rows_at_once, end - j);
        const std::vector<float> heights =
            read_heights(source,
                         {taken_window_.i + static_cast<int>(window.i), taken_window_.j + static_cast<int>(j),
                          static_cast<int>(window.columns), static_cast<int>(rows)},
                         options_);
        for (std::int64_t n = 0; n < rows * window.columns; ++n)
            put(window, window.i + n % window.columns, j + n / window.columns, heights[static_cast<std::size_t>(n)],
                source.datum);
    }
}

void PostSource::interpolate_block(const Window& window, std::size_t source, std::int64_t cell_i, std::int64_t cell_j) {
    constexpr std::int64_t kBlock = PostInterpolator::kBlock;
    const std::int64_t i = std::max<std::int64_t>(cell_i, window.i), j = std::max<std::int64_t>(cell_j, window.j);
    const std::int64_t columns = std::min(cell_i + kBlock, std::int64_t{window.i} + window.columns) - i,
                       rows = std::min(cell_j + kBlock, std::int64_t{window.j} + window.rows) - j;
    const PostInterpolator& interpolator = interpolators_[source];
    const PostInterpolator::Block block = interpolator.locate(i, j, columns, rows);
    if (block.pixels.columns == 0) return;
    const RasterSource& raster = opened(source);
    const std::vector<float> heights = read_heights(raster, block.pixels, options_);
    for (std::int64_t n = 0; n < columns * rows; ++n)
        put(window, i + n % columns, j + n / columns, interpolator.height_at(block, static_cast<std::size_t>(n), heights),
            raster.datum);
}

void PostSource::interpolate(const Window& window, std::size_t source) {
    constexpr std::int64_t kBlock = PostInterpolator::kBlock;
    const std::int64_t south = std::int64_t{window.j} + window.rows, east = std::int64_t{window.i} + window.columns;
    for (std::int64_t j = window.j / kBlock * kBlock; j < south; j += kBlock)
        for (std::int64_t i = window.i / kBlock * kBlock; i < east; i += kBlock)
            if (interpolators_[source].reaches(i, j)) interpolate_block(window, source, i, j);
}

void PostSource::read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
                      base::Span<terrain::PostClass> classes) {
    TEDAVIS_CHECK(columns <= grid_.columns && i <= grid_.columns - columns && rows <= grid_.rows && j <= grid_.rows - rows);
    TEDAVIS_CHECK(heights_m.size() == std::size_t{columns} * rows && classes.size() == heights_m.size());
    const QuietGdal quiet;
    std::fill(heights_m.begin(), heights_m.end(), std::numeric_limits<float>::quiet_NaN());
    std::fill(classes.begin(), classes.end(), terrain::PostClass::void_);
    const Window window{i, j, columns, rows, heights_m, classes};
    if (taken_) {
        take(window);
    } else {
        for (std::size_t source = 0; source < sources_.size(); ++source) interpolate(window, source);
    }
}

}  // namespace tedavis::host_sim
