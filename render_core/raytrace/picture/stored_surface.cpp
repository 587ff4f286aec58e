#include "render_core/raytrace/picture/stored_surface.hpp"

#include "render_core/raytrace/surface/surface_height.hpp"

namespace tedavis::raytrace {
namespace {

/// No posts where they would be too many.
template <class Height>
HeightGrid<float> fine_grid_of(const HeightGrid<Height>& grid, std::uint32_t parts) {
    HeightGrid<float> fine;
    const std::uint64_t columns = std::uint64_t{grid.columns - 1} * parts + 1, rows = std::uint64_t{grid.rows - 1} * parts + 1;
    if (columns > HeightGrid<float>::kMaxPosts || rows > HeightGrid<float>::kMaxPosts ||
        columns * rows > HeightGrid<float>::kMaxInAll)
        return fine;
    fine.columns = fine.stride = static_cast<std::uint32_t>(columns);
    fine.rows = static_cast<std::uint32_t>(rows);
    return fine;
}

}  // namespace

template <class Height>
std::uint64_t StoredSurface<Height>::bytes_needed(const HeightGrid<Height>& grid, std::uint32_t parts) {
    const HeightGrid<float> fine = fine_grid_of(grid, parts);
    return std::uint64_t{fine.columns} * fine.rows * sizeof(float);
}

template <class Height>
bool StoredSurface<Height>::start(const HeightGrid<Height>& grid, const SurfaceSettings& settings, base::Arena& arena) {
    TEDAVIS_CHECK(grid.is_valid() && settings.subdivisions > 0);
    grid_ = grid;
    settings_ = settings;
    fine_ = fine_grid_of(grid, settings.subdivisions);
    if (fine_.columns == 0) return false;
    posts_ = arena.allocate_array<float>(std::size_t{fine_.columns} * fine_.rows);
    fine_.posts = posts_.data();
    return !posts_.empty();
}

/// Fine posts on a side of cells are taken of the cell before, which has the same heights there; where that has no surface, of
/// the one behind.
template <class Height>
void StoredSurface<Height>::build_row(std::uint32_t row) {
    const std::uint32_t parts = settings_.subdivisions, cells = grid_.columns - 1;
    float* const posts = posts_.data() + std::size_t{row} * fine_.columns;
    for (std::uint32_t n = 0; n < fine_.columns; ++n) posts[n] = HeightGrid<float>::kVoid;
    for (std::uint32_t side = 0; side < 2; ++side) {
        if (side == 1 && row % parts != 0) break;
        const std::uint32_t line = row / parts - side;  // -1 wraps beyond
        if (line >= grid_.rows - 1) continue;
        const double v = side == 1 ? 1.0 : static_cast<double>(row % parts) / parts;
        for (std::uint32_t column = 0; column < cells; ++column) {
            const CellPatch patch = cell_patch(grid_, settings_, column, line);
            if (!patch.has_surface) continue;
            for (std::uint32_t n = 0; n <= parts; ++n) {
                float& post = posts[column * parts + n];
                if (post != HeightGrid<float>::kVoid) continue;
                const CellPlace place = {column, line, static_cast<double>(n) / parts, v};
                post = static_cast<float>(surface_on(patch, settings_.micro, place).height);
            }
        }
    }
}

template <class Height>
void StoredSurface<Height>::build(base::Workers& workers) {
    workers.parallel_for(
        fine_.rows, [](void* self, std::uint32_t row) { static_cast<StoredSurface*>(self)->build_row(row); }, this);
}

template class StoredSurface<std::int16_t>;
template class StoredSurface<float>;

}  // namespace tedavis::raytrace
