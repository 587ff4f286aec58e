#include "render_core/raytrace/sight.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {
namespace {

/// Between the lowest and the highest post within two of a place: steeper no cell is there.
template <class Height>
double range_round(const HeightGrid<Height>& grid, double x, double y) {
    const auto first = [](double at, std::uint32_t posts) {
        return static_cast<std::uint32_t>(std::clamp(std::floor(at) - 1, 0.0, posts - 1.0));
    };
    const std::uint32_t left = first(x, grid.columns), top = first(y, grid.rows);
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (std::uint32_t row = top; row < std::min(top + 4, grid.rows); ++row)
        for (std::uint32_t column = left; column < std::min(left + 4, grid.columns); ++column) {
            if (grid.at(column, row) == HeightGrid<Height>::kVoid) continue;
            lowest = std::min(lowest, static_cast<double>(grid.at(column, row)));
            highest = std::max(highest, static_cast<double>(grid.at(column, row)));
        }
    return std::max(highest - lowest, 0.0);
}

/// Sixteen roundings of floats: of heights, of the way up or down, and of places on a slope, which are off by more the further
/// away they are (cast_shadow.hpp).
double lift_of(const glm::dvec3& end, const glm::dvec3& way, double range) {
    const double across = std::max(std::abs(way.x), std::abs(way.y));
    return 0x1p-20 * (std::abs(end.z) + std::abs(way.z) + range * (2 + across / 4) + 1);
}

template <class Height>
struct ViewshedWork {
    const TracedField<Height>* field;
    const Viewshed* viewshed;
    base::Span<std::uint8_t> seen;
};

template <class Height>
void find_viewshed_row(void* context, std::uint32_t line) {
    const auto& work = *static_cast<const ViewshedWork<Height>*>(context);
    const PostRegion& window = work.viewshed->window;
    const HeightGrid<Height>& grid = work.field->grid();
    const std::uint32_t columns = window.end_column - window.first_column, row = window.first_row + line;
    for (std::uint32_t n = 0; n < columns; ++n) {
        const std::uint32_t column = window.first_column + n;
        const Height height = grid.at(column, row);
        const glm::dvec3 target(column, row, static_cast<double>(height) + work.viewshed->target_height);
        const bool is_seen = height != HeightGrid<Height>::kVoid && is_visible(*work.field, work.viewshed->observer, target);
        work.seen.data()[std::size_t{line} * columns + n] = is_seen ? 1 : 0;
    }
}

}  // namespace

template <class Height>
bool is_visible(const TracedField<Height>& field, const glm::dvec3& from, const glm::dvec3& to) {
    glm::dvec3 a = from, b = to;
    a.z += lift_of(from, to - from, range_round(field.grid(), from.x, from.y));
    b.z += lift_of(to, to - from, range_round(field.grid(), to.x, to.y));
    return !is_occluded(field, a, b);
}

template <class Height>
void find_visible(const TracedField<Height>& field, const glm::dvec3& from, base::Span<const glm::dvec3> to,
                  base::Span<std::uint8_t> seen) {
    TEDAVIS_CHECK(to.size() == seen.size());
    for (std::size_t n = 0; n < to.size(); ++n) seen[n] = is_visible(field, from, to[n]) ? 1 : 0;
}

template <class Height>
void find_viewshed(const TracedField<Height>& field, const Viewshed& viewshed, base::Workers& workers,
                   base::Span<std::uint8_t> seen) {
    const PostRegion& window = viewshed.window;
    const HeightGrid<Height>& grid = field.grid();
    TEDAVIS_CHECK(window.first_column <= window.end_column && window.end_column <= grid.columns);
    TEDAVIS_CHECK(window.first_row <= window.end_row && window.end_row <= grid.rows);
    const std::uint32_t columns = window.end_column - window.first_column, rows = window.end_row - window.first_row;
    TEDAVIS_CHECK(seen.size() == std::size_t{columns} * rows);
    ViewshedWork<Height> work = {&field, &viewshed, seen};
    workers.parallel_for(rows, find_viewshed_row<Height>, &work);
}

template bool is_visible(const TracedField<std::int16_t>&, const glm::dvec3&, const glm::dvec3&);
template bool is_visible(const TracedField<float>&, const glm::dvec3&, const glm::dvec3&);
template void find_visible(const TracedField<std::int16_t>&, const glm::dvec3&, base::Span<const glm::dvec3>,
                           base::Span<std::uint8_t>);
template void find_visible(const TracedField<float>&, const glm::dvec3&, base::Span<const glm::dvec3>, base::Span<std::uint8_t>);
template void find_viewshed(const TracedField<std::int16_t>&, const Viewshed&, base::Workers&, base::Span<std::uint8_t>);
template void find_viewshed(const TracedField<float>&, const Viewshed&, base::Workers&, base::Span<std::uint8_t>);

}  // namespace tedavis::raytrace
