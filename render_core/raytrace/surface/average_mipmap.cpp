#include "render_core/raytrace/surface/average_mipmap.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"

namespace tedavis::raytrace {
namespace {

std::uint32_t posts_of_half(std::uint32_t posts) { return posts / 2 + 1; }  // cells halved, rounded up

template <class Height>
Height average_of(double sum, double weight) {
    if (std::numeric_limits<Height>::is_integer) return static_cast<Height>(std::floor(sum / weight + 0.5));
    return static_cast<Height>(sum / weight);
}

template <class Height>
Height averaged_post(const HeightGrid<Height>& fine, std::uint32_t column, std::uint32_t row) {
    double sum = 0, weights = 0;
    Height lowest = std::numeric_limits<Height>::max(), highest = std::numeric_limits<Height>::lowest();
    for (std::uint32_t j = 0; j < 3; ++j)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t c = column + i - 1, r = row + j - 1;  // -1 wraps beyond every grid
            if (c >= fine.columns || r >= fine.rows || fine.at(c, r) == HeightGrid<Height>::kVoid) continue;
            const Height height = fine.at(c, r);
            const double weight = (i == 1 ? 2.0 : 1.0) * (j == 1 ? 2.0 : 1.0);
            sum += weight * static_cast<double>(height);
            weights += weight;
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    if (weights == 0) return HeightGrid<Height>::kVoid;
    return std::clamp(average_of<Height>(sum, weights), lowest, highest);
}

template <class Height>
void bound_average_row(const void* context, const HeightGrid<Height>& grid, HeightBound bound, std::uint32_t row,
                       std::uint32_t first, std::uint32_t end, Height* nodes) {
    const auto& averages = *static_cast<const AverageMipmap<Height>*>(context);
    const bool is_maximum = bound == HeightBound::maximum;
    for (std::uint32_t column = first; column < end; ++column) {
        Height outer = no_surface<Height>(bound), least = std::numeric_limits<Height>::max();
        for (std::uint32_t n = 0; n < averages.levels(); ++n) {
            const HeightGrid<Height>& level = n == 0 ? grid : averages.level(n);
            for (std::uint32_t k = 0; k < 4; ++k) {
                const Height height = level.at((column >> n) + k % 2, (row >> n) + k / 2);
                if (n == 0) least = std::min(least, height);
                outer = is_maximum ? std::max(outer, height) : std::min(outer, height);
            }
        }
        nodes[column] = least == HeightGrid<Height>::kVoid ? no_surface<Height>(bound) : outer;
    }
}

}  // namespace

template <class Height>
std::uint64_t AverageMipmap<Height>::bytes_needed(std::uint32_t columns, std::uint32_t rows) {
    std::uint64_t bytes = 0;
    for (std::uint32_t n = 1; n < kMaxLevels && (columns > 2 || rows > 2); ++n) {
        columns = posts_of_half(columns);
        rows = posts_of_half(rows);
        bytes += std::uint64_t{columns} * rows * sizeof(Height) + alignof(Height);
    }
    return bytes;
}

template <class Height>
bool AverageMipmap<Height>::start(const HeightGrid<Height>& grid, base::Arena& arena, std::uint32_t levels) {
    TEDAVIS_CHECK(grid.is_valid() && levels > 0);
    grids_[0] = grid;
    levels_ = 1;
    while (levels_ < std::min(levels, kMaxLevels) && (grids_[levels_ - 1].columns > 2 || grids_[levels_ - 1].rows > 2)) {
        HeightGrid<Height>& next = grids_[levels_];
        next.columns = next.stride = posts_of_half(grids_[levels_ - 1].columns);
        next.rows = posts_of_half(grids_[levels_ - 1].rows);
        posts_[levels_] = arena.allocate_array<Height>(std::size_t{next.columns} * next.rows);
        if (posts_[levels_].empty()) return false;
        next.posts = posts_[levels_].data();
        ++levels_;
    }
    return true;
}

template <class Height>
void AverageMipmap<Height>::average_row(std::uint32_t row) {
    const HeightGrid<Height>& grid = grids_[in_work_];
    Height* const posts = posts_[in_work_].data() + std::size_t{row} * grid.stride;
    for (std::uint32_t n = 0; n < grid.columns; ++n) posts[n] = averaged_post(grids_[in_work_ - 1], 2 * n, 2 * row);
}

template <class Height>
void AverageMipmap<Height>::build(base::Workers& workers) {
    for (in_work_ = 1; in_work_ < levels_; ++in_work_)
        workers.parallel_for(
            grids_[in_work_].rows, [](void* self, std::uint32_t row) { static_cast<AverageMipmap*>(self)->average_row(row); },
            this);
}

template <class Height>
SurfacePoint AverageMipmap<Height>::at_level(std::uint32_t n, double x, double y) const {
    const double spacing = static_cast<double>(std::uint32_t{1} << n);
    CellPlace place;
    const bool is_inside = raytrace::find_cell(grids_[n], x / spacing, y / spacing, place);
    TEDAVIS_CHECK(is_inside);
    double corner[2][2];
    for (std::uint32_t k = 0; k < 4; ++k)
        corner[k / 2][k % 2] = static_cast<double>(grids_[n].at(place.column + k % 2, place.row + k / 2));
    SurfacePoint point = bilinear_at(corner, place.u, place.v);
    point.slope_x /= spacing;
    point.slope_y /= spacing;
    return point;
}

template <class Height>
bool AverageMipmap<Height>::find_surface(double x, double y, double footprint, SurfacePoint& point) const {
    CellPlace place;
    if (!find_cell(grids_[0], x, y, place)) return false;
    for (std::uint32_t k = 0; k < 4; ++k)
        if (grids_[0].at(place.column + k % 2, place.row + k / 2) == HeightGrid<Height>::kVoid) return false;
    // Levels n and n + 1 with 2^n <= footprint < 2^(n + 1), by comparisons.
    std::uint32_t level = 0;
    double spacing = 1;
    for (; level + 1 < levels_ && footprint >= 2 * spacing; ++level) spacing *= 2;
    const double share = std::clamp(footprint / spacing - 1, 0.0, 1.0);
    point = at_level(level, x, y);
    if (level + 1 == levels_ || !(share > 0)) return true;
    const SurfacePoint coarser = at_level(level + 1, x, y);
    const double low = std::min(point.height, coarser.height), high = std::max(point.height, coarser.height);
    point.height = std::clamp((1 - share) * point.height + share * coarser.height, low, high);
    point.slope_x = (1 - share) * point.slope_x + share * coarser.slope_x;
    point.slope_y = (1 - share) * point.slope_y + share * coarser.slope_y;
    return true;
}

template <class Height>
CellBounds<Height> average_bounds(const AverageMipmap<Height>& averages) {
    return {bound_average_row<Height>, &averages, std::uint32_t{2} << averages.levels()};
}

template class AverageMipmap<std::int16_t>;
template class AverageMipmap<float>;
template CellBounds<std::int16_t> average_bounds(const AverageMipmap<std::int16_t>&);
template CellBounds<float> average_bounds(const AverageMipmap<float>&);

}  // namespace tedavis::raytrace
