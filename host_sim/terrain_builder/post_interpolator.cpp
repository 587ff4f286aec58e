#include "host_sim/terrain_builder/post_interpolator.hpp"

#include <gdal.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
constexpr double kPostRounding = 1e-6;  // of a post: what rounding may take, so that aligned posts keep their heights

double snapped(double place) {
    const double nearest = std::round(place);
    return std::abs(place - nearest) < kPostRounding ? nearest : place;
}

int nearest_pixel(double place, int count) { return std::clamp(static_cast<int>(std::floor(place + 0.5)), 0, count - 1); }

}  // namespace

PostInterpolator::PostInterpolator(const RasterSource& source, const GeoLattice& lattice)
    : lattice_(lattice), columns_(source.columns), rows_(source.rows), transform_(source.transform) {
    plan_reach(source);
    middle_ = transform_[0] + 0.5 * columns_ * transform_[1] + 0.5 * rows_ * transform_[2];
    if (source.plain) {
        const double lattice_middle_deg = lattice.west_deg + 0.5 * lattice.step_lon_deg * static_cast<double>(lattice.columns);
        transform_[0] += 360 * std::round((lattice_middle_deg - middle_) / 360);
        return;
    }
    if (source.crs.IsGeographic() != 0) turn_ = 2 * base::kPi / source.crs.GetAngularUnits(nullptr);
    const OGRSpatialReference wgs84 = wgs84_longitude_latitude();
    change_.reset(OGRCreateCoordinateTransformation(&wgs84, &source.crs));
    if (change_ == nullptr || GDALInvGeoTransform(transform_.data(), to_pixel_.data()) == 0)
        throw UserError(source.file + ": cannot be brought to geographic coordinates (" + QuietGdal::last_message() +
                        "); check its coordinate system");
}

/// With a margin, because the area of a projected raster is known from samples of its edges.
void PostInterpolator::plan_reach(const RasterSource& source) {
    constexpr double kMarginShare = 0.01, kMarginPosts = 2;
    const GeoBounds area = area_of(source);
    const double middle_deg = lattice_.west_deg + 0.5 * lattice_.step_lon_deg * static_cast<double>(lattice_.columns);
    const double turns_deg = 360 * std::round((middle_deg - 0.5 * (area.west_deg + area.east_deg)) / 360);
    const double wide = (area.east_deg - area.west_deg) / lattice_.step_lon_deg,
                 high = (area.north_deg - area.south_deg) / lattice_.step_lat_deg;
    const double margin_i = kMarginPosts + kMarginShare * wide, margin_j = kMarginPosts + kMarginShare * high;
    first_i_ = (area.west_deg + turns_deg - lattice_.west_deg) / lattice_.step_lon_deg - margin_i;
    last_i_ = first_i_ + wide + 2 * margin_i;
    first_j_ = (lattice_.north_deg - area.north_deg) / lattice_.step_lat_deg - margin_j;
    last_j_ = first_j_ + high + 2 * margin_j;
}

bool PostInterpolator::reaches(std::int64_t i, std::int64_t j) const {
    const auto west = static_cast<double>(i), north = static_cast<double>(j);
    return west <= last_i_ && west + kBlock >= first_i_ && north <= last_j_ && north + kBlock >= first_j_;
}

void PostInterpolator::store(Block& block, double column, double row) const {
    column = snapped(column);
    row = snapped(row);
    const bool inside = column >= -0.5 && column <= columns_ - 0.5 && row >= -0.5 && row <= rows_ - 0.5;
    block.column.push_back(inside ? column : kNowhere);
    block.row.push_back(inside ? row : kNowhere);
}

void PostInterpolator::locate_plain(Block& block, std::int64_t first_i, std::int64_t first_j, std::int64_t columns,
                                    std::int64_t rows) const {
    for (std::int64_t j = first_j; j < first_j + rows; ++j) {
        const double latitude_deg = lattice_.north_deg - lattice_.step_lat_deg * static_cast<double>(j);
        const double row = (latitude_deg - transform_[3]) / transform_[5] - 0.5;
        for (std::int64_t i = first_i; i < first_i + columns; ++i) {
            const double longitude_deg = lattice_.west_deg + lattice_.step_lon_deg * static_cast<double>(i);
            store(block, (longitude_deg - transform_[0]) / transform_[1] - 0.5, row);
        }
    }
}

/// GDAL chooses among several transformations by the mean place of those that it is given together: always whole cells, so
/// that the choice is the same for every window.
void PostInterpolator::locate_row(Block& block, std::int64_t first_i, std::int64_t j, std::int64_t columns) const {
    const std::int64_t cell = first_i / kBlock * kBlock, count = std::min(kBlock, lattice_.columns - cell);
    std::array<double, kBlock> x, y;
    std::array<int, kBlock> known;
    for (std::int64_t n = 0; n < count; ++n) {
        x[static_cast<std::size_t>(n)] = lattice_.west_deg + lattice_.step_lon_deg * static_cast<double>(cell + n);
        y[static_cast<std::size_t>(n)] = lattice_.north_deg - lattice_.step_lat_deg * static_cast<double>(j);
    }
    change_->Transform(static_cast<int>(count), x.data(), y.data(), nullptr, known.data());
    for (std::int64_t i = first_i; i < first_i + columns; ++i) {
        const auto n = static_cast<std::size_t>(i - cell);
        if (turn_ > 0) x[n] += turn_ * std::round((middle_ - x[n]) / turn_);
        const auto& p = to_pixel_;
        const bool is_known = known[n] != 0 && std::isfinite(x[n]) && std::isfinite(y[n]);
        store(block, is_known ? p[0] + x[n] * p[1] + y[n] * p[2] - 0.5 : kNowhere,
              is_known ? p[3] + x[n] * p[4] + y[n] * p[5] - 0.5 : kNowhere);
    }
}

void PostInterpolator::bound(Block& block) const {
    double west = columns_, east = -1, north = rows_, south = -1;
    for (std::size_t n = 0; n < block.column.size(); ++n) {
        if (std::isnan(block.column[n])) continue;
        west = std::min(west, block.column[n]);
        east = std::max(east, block.column[n]);
        north = std::min(north, block.row[n]);
        south = std::max(south, block.row[n]);
    }
    if (east < west) return;
    const auto low = [](double place) { return std::max(0, static_cast<int>(std::floor(place))); };
    const auto high = [](double place, int count) { return std::min(count - 1, static_cast<int>(std::floor(place)) + 1); };
    block.pixels = {low(west), low(north), high(east, columns_) - low(west) + 1, high(south, rows_) - low(north) + 1};
}

PostInterpolator::Block PostInterpolator::locate(std::int64_t first_i, std::int64_t first_j, std::int64_t columns,
                                                 std::int64_t rows) const {
    Block block;
    block.column.reserve(static_cast<std::size_t>(columns * rows));
    block.row.reserve(static_cast<std::size_t>(columns * rows));
    if (change_ == nullptr) {
        locate_plain(block, first_i, first_j, columns, rows);
    } else {
        for (std::int64_t j = first_j; j < first_j + rows; ++j) locate_row(block, first_i, j, columns);
    }
    bound(block);
    return block;
}

float PostInterpolator::height_at(const Block& block, std::size_t post, const std::vector<float>& heights) const {
    const double column = block.column[post], row = block.row[post];
    if (std::isnan(column)) return std::numeric_limits<float>::quiet_NaN();
    const PostWindow& w = block.pixels;
    const auto height = [&](int i, int j) {
        return heights[static_cast<std::size_t>(j - w.j) * static_cast<std::size_t>(w.columns) +
                       static_cast<std::size_t>(i - w.i)];
    };
    const float nearest_m = height(nearest_pixel(column, columns_), nearest_pixel(row, rows_));
    if (std::isnan(nearest_m)) return nearest_m;
    const int west = static_cast<int>(std::floor(column)), north = static_cast<int>(std::floor(row));
    const double u = column - west, v = row - north;
    if (u == 0 && v == 0) return nearest_m;
    double sum = 0, weights = 0;
    for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
            const int i = west + a, j = north + b;
            const double weight = (a == 0 ? 1 - u : u) * (b == 0 ? 1 - v : v);
            if (weight == 0 || i < 0 || j < 0 || i >= columns_ || j >= rows_ || std::isnan(height(i, j))) continue;
            sum += weight * double{height(i, j)};
            weights += weight;
        }
    }
    return static_cast<float>(sum / weights);
}

}  // namespace tedavis::host_sim
