#include "render_core/raytrace/search/cone_map.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/search/node_walk.hpp"
#include "render_core/raytrace/shading/arc_functions.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kMaxConeRadius = 256;
constexpr float kWidest = 1e6f;     // posts a height step: as good as level
constexpr double kShortest = 0.02;  // posts of a step: where a cone has no width, the ray must still go on

template <class Height>
bool bilinear_height(const HeightGrid<Height>& grid, double x, double y, double& height) {
    SurfacePoint point;
    if (!find_surface(grid, SurfaceSettings{}, x, y, point)) return false;
    height = point.height;
    return true;
}

}  // namespace

template <class Height>
bool ConeMap<Height>::start(const HeightGrid<Height>& grid, const ConeSettings& settings, base::Arena& arena) {
    TEDAVIS_CHECK(grid.is_valid() && settings.radius >= 1 && settings.radius <= kMaxConeRadius && settings.azimuths >= 4);
    grid_ = grid;
    settings_ = settings;
    ratios_ = arena.allocate_array<float>(std::size_t{grid.columns} * grid.rows);
    return !ratios_.empty();
}

template <class Height>
float ConeMap<Height>::narrowest_along(std::uint32_t column, std::uint32_t row, double across, double down) const {
    const double tip = static_cast<double>(grid_.at(column, row));
    double heights[kMaxConeRadius + 1];
    std::uint32_t count = 0;
    for (heights[0] = tip; count < settings_.radius; ++count)
        if (!bilinear_height(grid_, column + (count + 1) * across, row + (count + 1) * down, heights[count + 1])) break;
    float narrowest = kWidest;
    const double top = *std::max_element(heights, heights + count + 1);
    // From above the post to each point of the surface, and on below it to where the surface is left again.
    for (std::uint32_t target = 1; target <= count; ++target) {
        if (!settings_.is_relaxed) {
            if (heights[target] > tip) narrowest = std::min(narrowest, static_cast<float>(target / (heights[target] - tip)));
            continue;
        }
        const double slope = (heights[target] - top) / target;
        const auto depth_at = [&](std::uint32_t n) { return heights[n] - (top + slope * n); };
        std::uint32_t out = target + 1;
        while (out <= count && depth_at(out) >= 0) ++out;
        if (out > count) continue;
        const double in_depth = std::max(depth_at(out - 1), 0.0);
        const double left_at = out - 1 + in_depth / (in_depth - depth_at(out));
        const double rise = top + slope * left_at - tip;
        if (rise > 0) narrowest = std::min(narrowest, static_cast<float>(left_at / rise));
    }
    return narrowest;
}

template <class Height>
void ConeMap<Height>::build_row(std::uint32_t row) {
    for (std::uint32_t column = 0; column < grid_.columns; ++column) {
        float& ratio = ratios_[std::size_t{row} * grid_.columns + column];
        ratio = 0;
        if (grid_.at(column, row) == HeightGrid<Height>::kVoid) continue;
        ratio = kWidest;
        for (std::uint32_t n = 0; n < settings_.azimuths; ++n) {
            const glm::dvec2 direction = direction_of_angle(2 * kArcPi * n / settings_.azimuths);
            ratio = std::min(ratio, narrowest_along(column, row, direction.x, direction.y));
        }
    }
}

template <class Height>
void ConeMap<Height>::build(base::Workers& workers) {
    workers.parallel_for(
        grid_.rows, [](void* self, std::uint32_t row) { static_cast<ConeMap*>(self)->build_row(row); }, this);
}

template <class Height>
float ConeMap<Height>::ratio(std::uint32_t column, std::uint32_t row) const {
    return ratios_[std::size_t{row} * grid_.columns + column];
}

template <class Height>
SurfaceHit ConeMap<Height>::search(const Ray& ray, const ConeSearch& search) const {
    constexpr std::uint32_t kWhole = 31;
    const NodeWalk walk(ray, grid_.columns - 1, grid_.rows - 1);
    if (!walk.is_inside()) return {};
    const glm::dvec3 direction(ray.direction);
    const double speed = std::max(std::hypot(direction.x, direction.y), 1e-12), end = walk.exit_t(kWhole);
    const double fall = -direction.z / speed;  // height steps a post
    const auto place_at = [&](double t) { return ray.origin + t * direction; };
    double t = walk.t(), before = t;
    for (std::uint32_t step = 0; step < search.steps; ++step) {
        const glm::dvec3 place = place_at(t);
        double height = 0, posts = 0.5;  // over a hole: by half a post
        if (bilinear_height(grid_, place.x, place.y, height)) {
            const double gap = place.z - height;
            if (gap <= 0) break;
            const auto nearest = [](double along) { return static_cast<std::uint32_t>(std::floor(along + 0.5)); };
            const double width = ratio(nearest(place.x), nearest(place.y));
            const double narrowing = 1 + width * fall;
            posts = narrowing > 0 ? width * gap / narrowing : settings_.radius;
        }
        if (t >= end) return {};
        before = t;
        t = std::min(t + std::clamp(posts, kShortest, static_cast<double>(settings_.radius)) / speed, end);
    }
    const auto is_below = [&](double at) {
        const glm::dvec3 place = place_at(at);
        double height = 0;
        return bilinear_height(grid_, place.x, place.y, height) && place.z <= height;
    };
    if (!is_below(t)) return {};
    for (std::uint32_t n = 0; n < std::min(search.halvings, 24u) && before < t; ++n) {
        const double middle = 0.5 * (before + t);
        (is_below(middle) ? t : before) = middle;
    }
    const glm::dvec3 place = place_at(t);
    SurfaceHit hit;
    SurfacePoint point;
    if (!find_cell(grid_, place.x, place.y, hit.place) || !find_surface(grid_, SurfaceSettings{}, place.x, place.y, point))
        return {};
    hit.side = HitSide::above;
    hit.t = t;
    hit.height = point.height;
    hit.slopes = {point.slope_x, point.slope_y};
    return hit;
}

template class ConeMap<std::int16_t>;
template class ConeMap<float>;

}  // namespace tedavis::raytrace
