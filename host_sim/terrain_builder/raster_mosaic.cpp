#include "host_sim/terrain_builder/raster_mosaic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kEdgeSamples = 41;
constexpr double kStepRounding = 1e-6;  // of a step: what rounding may take

/// Edges of the area, not posts.
struct Extent {
    double west_deg = 0, south_deg = 0, east_deg = 0, north_deg = 0;
    double step_lon_deg = 0, step_lat_deg = 0;
};

[[noreturn]] void refuse(const RasterSource& source) {
    throw UserError(source.file + ": cannot be brought to geographic coordinates (" + QuietGdal::last_message() +
                    "); check its coordinate system");
}

struct MapPoint {
    double x = 0, y = 0;
};

MapPoint map_point(const RasterSource& source, double column, double row) {
    const auto& t = source.transform;
    return {t[0] + column * t[1] + row * t[2], t[3] + column * t[4] + row * t[5]};
}

/// What one pixel covers at the middle, in degrees; the hypotenuse makes it independent of how the grid is turned.
void measure_steps(const RasterSource& source, OGRCoordinateTransformation& to_wgs84, Extent& extent) {
    const double column = source.columns * 0.5, row = source.rows * 0.5;
    MapPoint here = map_point(source, column, row), east = map_point(source, column + 1, row),
             south = map_point(source, column, row + 1);
    for (MapPoint* point : {&here, &east, &south})
        if (to_wgs84.Transform(1, &point->x, &point->y) == 0) refuse(source);
    const auto turn = [](double degrees) { return std::remainder(degrees, 360.0); };
    extent.step_lon_deg = std::hypot(turn(east.x - here.x), turn(south.x - here.x));
    extent.step_lat_deg = std::hypot(east.y - here.y, south.y - here.y);
}

Extent extent_of(const RasterSource& source) {
    Extent e;
    const auto& t = source.transform;
    const double columns = source.columns, rows = source.rows;
    if (source.plain) return {t[0], t[3] + rows * t[5], t[0] + columns * t[1], t[3], t[1], -t[5]};
    const OGRSpatialReference wgs84 = wgs84_longitude_latitude();
    const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&source.crs, &wgs84));
    if (change == nullptr) refuse(source);
    double x0 = std::numeric_limits<double>::max(), y0 = x0, x1 = -x0, y1 = -x0;
    for (const MapPoint& p :
         {map_point(source, 0, 0), map_point(source, columns, 0), map_point(source, 0, rows), map_point(source, columns, rows)}) {
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    if (change->TransformBounds(x0, y0, x1, y1, &e.west_deg, &e.south_deg, &e.east_deg, &e.north_deg, kEdgeSamples) == 0)
        refuse(source);
    if (e.west_deg > e.east_deg) e.east_deg += 360;  // the antimeridian lies inside
    measure_steps(source, *change, e);
    const bool usable = e.west_deg < e.east_deg && e.south_deg < e.north_deg && e.step_lon_deg > 0 && e.step_lat_deg > 0 &&
                        std::isfinite(e.east_deg - e.west_deg) && std::isfinite(e.north_deg - e.south_deg);
    if (!usable) refuse(source);
    return e;
}

/// Whole turns that bring a longitude nearest to another.
double turns_towards(double longitude_deg, double target_deg) { return 360 * std::round((target_deg - longitude_deg) / 360); }

void shift(Extent& extent, double turns_deg) {
    extent.west_deg += turns_deg;
    extent.east_deg += turns_deg;
}

/// Of a list that is not empty; every extent comes to the turn of the first.
Extent unite(std::vector<Extent>& extents) {
    constexpr double kFar = 1e9;
    Extent all{kFar, kFar, -kFar, -kFar, kFar, kFar};
    double middle_deg = 0;
    for (std::size_t n = 0; n < extents.size(); ++n) {
        Extent& e = extents[n];
        if (n == 0) middle_deg = 0.5 * (e.west_deg + e.east_deg);
        shift(e, turns_towards(0.5 * (e.west_deg + e.east_deg), middle_deg));
        all = {std::min(all.west_deg, e.west_deg),         std::min(all.south_deg, e.south_deg),
               std::max(all.east_deg, e.east_deg),         std::max(all.north_deg, e.north_deg),
               std::min(all.step_lon_deg, e.step_lon_deg), std::min(all.step_lat_deg, e.step_lat_deg)};
    }
    return all;
}

/// Cut to posts inside the bounds, whole steps from where it began.
void cut(Extent& all, const GeoBounds& bounds) {
    const double turns = turns_towards(0.5 * (bounds.west_deg + bounds.east_deg), 0.5 * (all.west_deg + all.east_deg));
    const auto whole = [](double steps) { return std::max(0.0, std::ceil(steps - kStepRounding)); };
    const double from_west = whole((bounds.west_deg + turns - all.west_deg) / all.step_lon_deg - 0.5),
                 from_north = whole((all.north_deg - bounds.north_deg) / all.step_lat_deg - 0.5),
                 from_east = whole((all.east_deg - bounds.east_deg - turns) / all.step_lon_deg - 0.5),
                 from_south = whole((bounds.south_deg - all.south_deg) / all.step_lat_deg - 0.5);
    all.west_deg += from_west * all.step_lon_deg;
    all.north_deg -= from_north * all.step_lat_deg;
    all.east_deg -= from_east * all.step_lon_deg;
    all.south_deg += from_south * all.step_lat_deg;
}

}  // namespace

GeoBounds area_of(const RasterSource& source) {
    const Extent e = extent_of(source);
    return {e.west_deg, e.south_deg, e.east_deg, e.north_deg};
}

GeoLattice plan_lattice(const std::vector<RasterSource>& sources, const RasterOptions& options) {
    std::vector<Extent> extents;
    for (const RasterSource& source : sources) extents.push_back(extent_of(source));
    Extent all = unite(extents);
    const auto first_plain = std::find_if(sources.begin(), sources.end(), [](const RasterSource& s) { return s.plain; });
    const Extent anchor = first_plain == sources.end() ? all : extents[static_cast<std::size_t>(first_plain - sources.begin())];
    const auto steps = [](double distance, double step) { return std::ceil(distance / step - kStepRounding); };
    all.west_deg = anchor.west_deg - steps(anchor.west_deg - all.west_deg, all.step_lon_deg) * all.step_lon_deg;
    all.north_deg = anchor.north_deg + steps(all.north_deg - anchor.north_deg, all.step_lat_deg) * all.step_lat_deg;
    if (options.bounds) cut(all, *options.bounds);
    GeoLattice lattice{
        all.west_deg + 0.5 * all.step_lon_deg, all.north_deg - 0.5 * all.step_lat_deg, all.step_lon_deg, all.step_lat_deg, 0, 0};
    lattice.columns = static_cast<std::int64_t>(std::max(0.0, steps(all.east_deg - all.west_deg, all.step_lon_deg)));
    lattice.rows = static_cast<std::int64_t>(std::max(0.0, steps(all.north_deg - all.south_deg, all.step_lat_deg)));
    return lattice;
}

}  // namespace tedavis::host_sim
