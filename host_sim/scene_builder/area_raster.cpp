#include "host_sim/scene_builder/area_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using scene::ScenePoint;

constexpr double kEarthRadius_m = 6'371'000;
constexpr double kMaxSide = 8192, kWidest_rad = base::radians(180);
constexpr std::int64_t kNoArea = -1;

struct Bounds {
    double west = std::numeric_limits<double>::infinity(), south = west, east = -west, north = -west;
};

Bounds bounds_of(const std::vector<ScenePoint>& points, const std::optional<RegionRecipe>& region) {
    Bounds bounds;
    for (const ScenePoint& point : points) {
        bounds.west = std::min(bounds.west, point.longitude_rad);
        bounds.east = std::max(bounds.east, point.longitude_rad);
        bounds.south = std::min(bounds.south, point.latitude_rad);
        bounds.north = std::max(bounds.north, point.latitude_rad);
    }
    if (!region || region->west_deg > region->east_deg) return bounds;
    bounds.west = std::max(bounds.west, base::radians(region->west_deg));
    bounds.east = std::min(bounds.east, base::radians(region->east_deg));
    bounds.south = std::max(bounds.south, base::radians(region->south_deg));
    bounds.north = std::min(bounds.north, base::radians(region->north_deg));
    return bounds;
}

scene::GridShape grid_over(const Bounds& bounds, double cell_m, const std::string& name) {
    const double step_lat = cell_m / kEarthRadius_m, step_lon = step_lat / std::cos(0.5 * (bounds.south + bounds.north));
    const double columns = std::floor((bounds.east - bounds.west) / step_lon) + 1,
                 rows = std::floor((bounds.north - bounds.south) / step_lat) + 1;
    if (!(columns >= 1 && rows >= 1))
        throw UserError(name + ": there are no areas to make a raster of; move 'region', or leave 'raster_m' out");
    if (!(bounds.east - bounds.west <= kWidest_rad))
        throw UserError(name + ": its areas lie half a turn of the Earth apart or more; choose a region");
    if (columns > kMaxSide || rows > kMaxSide)
        throw UserError(name + ": a raster of " + std::to_string(std::llround(columns)) + " x " +
                        std::to_string(std::llround(rows)) + " posts is too large; give a larger 'raster_m', or a region");
    return {bounds.west,
            bounds.north,
            step_lon,
            step_lat,
            static_cast<std::uint32_t>(columns),
            static_cast<std::uint32_t>(rows),
            1,
            1};
}

/// Which area covers each post.
class Cover {
public:
    explicit Cover(const scene::GridShape& grid) : grid_(grid), areas_(std::size_t{grid.columns} * grid.rows, kNoArea) {}

    void fill(const ScenePoint* points, std::size_t count, std::int64_t area) {
        double south = points[0].latitude_rad, north = south;
        for (std::size_t n = 1; n < count; ++n) {
            south = std::min(south, points[n].latitude_rad);
            north = std::max(north, points[n].latitude_rad);
        }
        const double first = std::ceil((grid_.north_rad - north) / grid_.step_lat_rad),
                     last = std::floor((grid_.north_rad - south) / grid_.step_lat_rad);
        for (double row = std::max(first, 0.0); row <= std::min(last, grid_.rows - 1.0); ++row) {
            find_crossings(points, count, grid_.north_rad - row * grid_.step_lat_rad);
            for (std::size_t n = 0; n + 1 < crossings_.size(); n += 2)
                fill(static_cast<std::size_t>(row), crossings_[n], crossings_[n + 1], area);
        }
    }
    [[nodiscard]] const std::vector<std::int64_t>& areas() const { return areas_; }

private:
    /// Sides are half open, so that a corner on the row counts once.
    void find_crossings(const ScenePoint* points, std::size_t count, double latitude_rad) {
        crossings_.clear();
        for (std::size_t n = 0; n < count; ++n) {
            const ScenePoint &a = points[n], &b = points[(n + 1) % count];
            if ((a.latitude_rad > latitude_rad) == (b.latitude_rad > latitude_rad)) continue;
            const double share = (latitude_rad - a.latitude_rad) / (b.latitude_rad - a.latitude_rad);
            crossings_.push_back(a.longitude_rad + share * (b.longitude_rad - a.longitude_rad));
        }
        std::sort(crossings_.begin(), crossings_.end());
    }
    void fill(std::size_t row, double from_rad, double to_rad, std::int64_t area) {
        const double first = std::ceil((from_rad - grid_.west_rad) / grid_.step_lon_rad),
                     end = std::ceil((to_rad - grid_.west_rad) / grid_.step_lon_rad);
        for (double column = std::max(first, 0.0); column < std::min(end, static_cast<double>(grid_.columns)); ++column)
            areas_[row * grid_.columns + static_cast<std::size_t>(column)] = area;
    }

    const scene::GridShape grid_;
    std::vector<std::int64_t> areas_;
    std::vector<double> crossings_;
};

AttributeDraft spread_over(const AttributeDraft& of_areas, const std::vector<std::int64_t>& cover) {
    AttributeDraft attribute = of_areas;
    attribute.of = scene::AttributeOf::point;
    attribute.values.clear();
    attribute.uncertainties.clear();
    for (const std::int64_t area : cover) {
        const auto n = static_cast<std::size_t>(area);
        attribute.values.push_back(area == kNoArea ? std::numeric_limits<float>::quiet_NaN() : of_areas.values[n]);
        if (!of_areas.uncertainties.empty())
            attribute.uncertainties.push_back(area == kNoArea ? scene::Uncertainty() : of_areas.uncertainties[n]);
    }
    return attribute;
}

}  // namespace

LayerDraft rasterized(const LayerDraft& areas, double cell_m, const std::optional<RegionRecipe>& region) {
    if (areas.shape != scene::LayerShape::areas)
        throw UserError(areas.name + ": 'raster_m' is for areas; leave it out, or give role = \"land_cover\"");
    if (areas.attributes.empty()) throw UserError(areas.name + ": a raster of areas needs an [[layer.attribute]]; bind one");
    LayerDraft grid = areas;
    grid.shape = scene::LayerShape::grid;
    grid.grid = grid_over(bounds_of(areas.points, region), cell_m, areas.name);
    grid.points.clear();
    grid.starts.clear();
    grid.names.clear();
    grid.attributes.clear();
    Cover cover(grid.grid);
    for (std::size_t n = 0; n + 1 < areas.starts.size(); ++n)
        cover.fill(&areas.points[areas.starts[n]], areas.starts[n + 1] - areas.starts[n], static_cast<std::int64_t>(n));
    for (const AttributeDraft& attribute : areas.attributes) {
        if (attribute.of != scene::AttributeOf::feature)
            throw UserError(areas.name + ": '" + attribute.name +
                            "' has values by point, which areas of a raster cannot have; leave it out");
        grid.attributes.push_back(spread_over(attribute, cover.areas()));
    }
    return grid;
}

}  // namespace tedavis::host_sim
