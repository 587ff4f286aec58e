#include "render_core/raytrace/shading/sky_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/shading/arc_functions.hpp"

namespace tedavis::raytrace {
namespace {

constexpr double kNoDirection = 1e-6;  // mean directions shorter than that point nowhere

/// Between two posts of a column or row, or void.
template <class Height>
bool height_between(Height first, Height second, double share, double& height) {
    if (first == HeightGrid<Height>::kVoid || (share > 0 && second == HeightGrid<Height>::kVoid)) return false;
    height =
        share > 0 ? (1 - share) * static_cast<double>(first) + share * static_cast<double>(second) : static_cast<double>(first);
    return true;
}

/// Central differences, one-sided where a neighbour is missing, level where both are.
template <class Height>
SurfacePoint slopes_at_post(const HeightGrid<Height>& grid, std::uint32_t column, std::uint32_t row) {
    const auto height_at = [&](std::uint32_t c, std::uint32_t r) {
        return c < grid.columns && r < grid.rows ? grid.at(c, r) : HeightGrid<Height>::kVoid;  // -1 wraps beyond
    };
    const Height here = grid.at(column, row);
    const auto slope = [&](Height before, Height behind) {
        const bool has_before = before != HeightGrid<Height>::kVoid, has_behind = behind != HeightGrid<Height>::kVoid;
        const double low = static_cast<double>(has_before ? before : here),
                     high = static_cast<double>(has_behind ? behind : here);
        return has_before && has_behind ? (high - low) / 2 : high - low;
    };
    return {static_cast<double>(here), slope(height_at(column - 1, row), height_at(column + 1, row)),
            slope(height_at(column, row - 1), height_at(column, row + 1))};
}

struct PostWeights {
    std::size_t post[4];
    double weight[4];
};

template <class Height>
PostWeights weights_round(const HeightGrid<Height>& grid, double x, double y) {
    const double inside_x = std::clamp(x, 0.0, grid.columns - 1.0), inside_y = std::clamp(y, 0.0, grid.rows - 1.0);
    const std::uint32_t column = std::min(static_cast<std::uint32_t>(inside_x), grid.columns - 2);
    const std::uint32_t row = std::min(static_cast<std::uint32_t>(inside_y), grid.rows - 2);
    const double u = inside_x - column, v = inside_y - row;
    const std::size_t first = std::size_t{row} * grid.columns + column;
    return {{first, first + 1, first + grid.columns, first + grid.columns + 1},
            {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

double rounded_to(double x, double most) { return std::floor(std::clamp(x, -1.0, 1.0) * most + 0.5); }

}  // namespace

template <class Height>
double horizon_slope(const HeightGrid<Height>& grid, const GridScale& scale, std::uint32_t column, std::uint32_t row,
                     const glm::dvec2& direction, std::uint32_t radius) {
    const double across = direction.x / scale.column_m, down = direction.y / scale.row_m;
    const bool by_columns = std::abs(across) >= std::abs(down);
    const double major = by_columns ? across : down, minor = (by_columns ? down : across) / std::abs(major);
    const int step = major < 0 ? -1 : 1;
    const double step_m = 1 / std::abs(major), here = static_cast<double>(grid.at(column, row));
    const std::int64_t most_major = by_columns ? grid.columns : grid.rows, most_minor = by_columns ? grid.rows : grid.columns;
    const std::int64_t start_major = by_columns ? column : row, start_minor = by_columns ? row : column;
    double steepest = 0;
    for (std::uint32_t n = 1; n <= radius; ++n) {
        const std::int64_t place = start_major + step * static_cast<std::int64_t>(n);
        const double beside = static_cast<double>(start_minor) + n * minor, line = std::floor(beside);
        const auto first = static_cast<std::int64_t>(line);
        if (place < 0 || place >= most_major || first < 0 || beside > static_cast<double>(most_minor - 1)) break;
        const auto a = static_cast<std::uint32_t>(place), b = static_cast<std::uint32_t>(first);
        const std::uint32_t next = std::min(b + 1, static_cast<std::uint32_t>(most_minor - 1));
        double height = 0;
        const bool is_there = by_columns ? height_between(grid.at(a, b), grid.at(a, next), beside - line, height)
                                         : height_between(grid.at(b, a), grid.at(next, a), beside - line, height);
        if (is_there) steepest = std::max(steepest, (height - here) * scale.height_m / (n * step_m));
    }
    return steepest;
}

template <class Height>
SkySeen sky_seen_at(const HeightGrid<Height>& grid, const SkyMapSettings& settings, std::uint32_t column, std::uint32_t row) {
    const glm::dvec3 normal = normal_of(slopes_at_post(grid, column, row), settings.scale);
    double view = 0, hidden = 0;
    glm::dvec3 mean(0);
    for (std::uint32_t n = 0; n < settings.azimuths; ++n) {
        const glm::dvec2 direction = direction_of_angle(2 * kArcPi * n / settings.azimuths);
        const double facing = normal.x * direction.x + normal.y * direction.y;
        const double of_terrain = horizon_slope(grid, settings.scale, column, row, direction, settings.radius);
        const double slope = std::max(of_terrain, -facing / normal.z);
        // With the horizon's angle H from the zenith: slope = cot H.
        const double sin2 = 1 / (1 + slope * slope), lune = (kArcPi / 2 - arc_tangent(slope)) - slope * sin2;
        view += normal.z * sin2 + facing * lune;
        hidden += slope * std::sqrt(sin2);
        mean += glm::dvec3(direction.x * lune, direction.y * lune, sin2);
    }
    SkySeen seen;
    seen.view = std::clamp(view / settings.azimuths, 0.0, 1.0);
    seen.aperture.cos_radius = std::clamp(hidden / settings.azimuths, 0.0, 1.0);
    const double length = glm::length(mean);
    seen.aperture.axis = length > kNoDirection * settings.azimuths ? mean / length : normal;
    return seen;
}

template <class Height>
std::uint64_t SkyMap<Height>::bytes_needed(std::uint32_t columns, std::uint32_t rows, bool has_apertures) {
    const std::uint64_t posts = std::uint64_t{columns} * rows;
    return posts * (1 + (has_apertures ? sizeof(StoredAperture) : 0)) + alignof(StoredAperture);
}

template <class Height>
bool SkyMap<Height>::start(const HeightGrid<Height>& grid, const SkyMapSettings& settings, base::Arena& arena) {
    TEDAVIS_CHECK(grid.is_valid() && settings.azimuths >= 4 && settings.azimuths <= SkyMapSettings::kMaxAzimuths);
    grid_ = grid;
    settings_ = settings;
    const std::size_t posts = std::size_t{grid.columns} * grid.rows;
    views_ = arena.allocate_array<std::uint8_t>(posts);
    if (settings.has_apertures) apertures_ = arena.allocate_array<StoredAperture>(posts);
    return !views_.empty() && (!settings.has_apertures || !apertures_.empty());
}

template <class Height>
void SkyMap<Height>::build_row(std::uint32_t row) {
    for (std::uint32_t column = 0; column < grid_.columns; ++column) {
        if (grid_.at(column, row) == HeightGrid<Height>::kVoid) continue;  // no surface is there to be lit
        const SkySeen seen = sky_seen_at(grid_, settings_, column, row);
        const std::size_t post = std::size_t{row} * grid_.columns + column;
        views_[post] = static_cast<std::uint8_t>(rounded_to(seen.view, 255));
        if (!settings_.has_apertures) continue;
        const glm::dvec3& axis = seen.aperture.axis;
        apertures_[post] = {static_cast<std::int16_t>(rounded_to(axis.x, 32767)),
                            static_cast<std::int16_t>(rounded_to(axis.y, 32767)),
                            static_cast<std::uint16_t>(rounded_to(seen.aperture.cos_radius, 65535))};
    }
}

template <class Height>
void SkyMap<Height>::build(base::Workers& workers) {
    workers.parallel_for(
        grid_.rows, [](void* self, std::uint32_t row) { static_cast<SkyMap*>(self)->build_row(row); }, this);
}

template <class Height>
double SkyMap<Height>::view_at(double x, double y) const {
    const PostWeights round = weights_round(grid_, x, y);
    double sum = 0;
    for (int n = 0; n < 4; ++n) sum += round.weight[n] * views_[round.post[n]];
    return sum / 255;
}

template <class Height>
Aperture SkyMap<Height>::aperture_at(double x, double y, const glm::dvec3& normal) const {
    const PostWeights round = weights_round(grid_, x, y);
    glm::dvec3 mean(0);
    double cos_radius = 0;
    for (int n = 0; n < 4; ++n) {
        const StoredAperture& stored = apertures_[round.post[n]];
        const double across = stored.x / 32767.0, down = stored.y / 32767.0;
        mean += round.weight[n] * glm::dvec3(across, down, std::sqrt(std::max(0.0, 1 - across * across - down * down)));
        cos_radius += round.weight[n] * stored.cos_radius / 65535.0;
    }
    const double length = glm::length(mean);
    return {length > kNoDirection ? mean / length : normal, std::min(cos_radius, 1.0)};
}

template double horizon_slope(const HeightGrid<std::int16_t>&, const GridScale&, std::uint32_t, std::uint32_t, const glm::dvec2&,
                              std::uint32_t);
template double horizon_slope(const HeightGrid<float>&, const GridScale&, std::uint32_t, std::uint32_t, const glm::dvec2&,
                              std::uint32_t);
template SkySeen sky_seen_at(const HeightGrid<std::int16_t>&, const SkyMapSettings&, std::uint32_t, std::uint32_t);
template SkySeen sky_seen_at(const HeightGrid<float>&, const SkyMapSettings&, std::uint32_t, std::uint32_t);
template class SkyMap<std::int16_t>;
template class SkyMap<float>;

}  // namespace tedavis::raytrace
