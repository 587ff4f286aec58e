#include "render_core/raytrace/surface/surface_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {
namespace {

// Of control heights beyond the posts' range, in parts of it: they are sums of posts with weights whose magnitudes sum to at most
// 16/9, and 6/36 more where a corner of the ring is continued from sides that are continued themselves.
constexpr double kMaxOvershoot = 0.5;

template <class Height>
void bound_surface_row(const void* context, const HeightGrid<Height>& grid, HeightBound bound, std::uint32_t row,
                       std::uint32_t first, std::uint32_t end, Height* nodes) {
    const auto& settings = *static_cast<const SurfaceSettings*>(context);
    const double amplitude = amplitude_of(settings.micro);
    for (std::uint32_t column = first; column < end; ++column) {
        const CellPatch patch = cell_patch(grid, settings, column, row);
        if (!patch.has_surface) {
            nodes[column] = no_surface<Height>(bound);
            continue;
        }
        const HeightRange range = patch.range();
        nodes[column] = bound == HeightBound::maximum ? rounded_up<Height>(range.highest + amplitude)
                                                      : rounded_down<Height>(range.lowest - amplitude);
    }
}

}  // namespace

template <>
std::int16_t rounded_up(double height) {
    return static_cast<std::int16_t>(std::clamp(std::ceil(height), -32767.0, 32767.0));
}

template <>
std::int16_t rounded_down(double height) {
    return static_cast<std::int16_t>(std::clamp(std::floor(height), -32767.0, 32766.0));
}

template <>
float rounded_up(double height) {
    const auto nearest = static_cast<float>(height);
    return double{nearest} < height ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

template <>
float rounded_down(double height) {
    const auto nearest = static_cast<float>(height);
    return double{nearest} > height ? std::nextafter(nearest, -std::numeric_limits<float>::infinity()) : nearest;
}

template <class Height>
CellBounds<Height> surface_bounds(const SurfaceSettings& settings) {
    const bool by_posts = !is_cubic(settings.kind) && settings.micro.kind == MicroKind::none;
    if (by_posts) return {};
    return {bound_surface_row<Height>, &settings, is_cubic(settings.kind) ? 1u : 0u};
}

template <class Height>
bool surface_fits(const HeightGrid<Height>& grid, const SurfaceSettings& settings) {
    if (!std::numeric_limits<Height>::is_integer) return true;
    double lowest = std::numeric_limits<double>::max(), highest = -lowest;
    for (std::uint32_t row = 0; row < grid.rows; ++row)
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const Height height = grid.at(column, row);
            if (height == HeightGrid<Height>::kVoid) continue;
            lowest = std::min(lowest, static_cast<double>(height));
            highest = std::max(highest, static_cast<double>(height));
        }
    if (lowest > highest) return true;
    const double more = (is_cubic(settings.kind) ? kMaxOvershoot * (highest - lowest) : 0) + amplitude_of(settings.micro);
    return std::ceil(highest + more) <= 32767 && std::floor(lowest - more) >= -32767;
}

template CellBounds<std::int16_t> surface_bounds(const SurfaceSettings&);
template CellBounds<float> surface_bounds(const SurfaceSettings&);
template bool surface_fits(const HeightGrid<std::int16_t>&, const SurfaceSettings&);
template bool surface_fits(const HeightGrid<float>&, const SurfaceSettings&);

}  // namespace tedavis::raytrace
