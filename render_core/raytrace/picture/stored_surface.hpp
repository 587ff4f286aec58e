/// A surface sampled more finely than its posts, once, so that the vector kernel can trace it: `parts` posts to one of the grid,
/// bilinear between. Of approximate_bicubic with as many subdivisions it is the very same surface (heights rounded to float);
/// micro-structure is what it is at the fine posts.
///
/// Memory  an arena's: parts^2 floats a post. Thread  build() uses the workers.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/height_grid.hpp"
#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::raytrace {

template <class Height>
class StoredSurface {
public:
    /// 0 where the fine grid would have too many posts.
    [[nodiscard]] static std::uint64_t bytes_needed(const HeightGrid<Height>& grid, std::uint32_t parts);
    /// False where the arena has no room, or too many posts would come of it. The grid is borrowed until build() has ended; of
    /// the settings, `subdivisions` are the parts.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, const SurfaceSettings& settings, base::Arena& arena);
    void build(base::Workers& workers);

    [[nodiscard]] const HeightGrid<float>& grid() const { return fine_; }
    [[nodiscard]] std::uint32_t parts() const { return settings_.subdivisions; }

private:
    void build_row(std::uint32_t row);

    HeightGrid<Height> grid_;
    SurfaceSettings settings_;
    HeightGrid<float> fine_;
    base::Span<float> posts_;
};

}  // namespace tedavis::raytrace
