/// A surface that is sampled once on a finer grid, with `parts` posts per post and bilinear between, so that the vector kernel
/// can trace it. It equals approximate_bicubic with as many subdivisions (heights rounded to float); micro-structure is sampled
/// at the fine posts.
///
/// Memory  an arena's: parts^2 floats per post. Thread  build() uses the workers.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/height_grid.hpp"
#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::raytrace {

template <class Height>
class StoredSurface {
public:
    /// Returns the bytes of the arena; 0 where the fine grid would have too many posts.
    [[nodiscard]] static std::uint64_t bytes_needed(const HeightGrid<Height>& grid, std::uint32_t parts);
    /// Allocates memory; returns false where the arena is too small or the fine grid would have too many posts. The grid must
    /// stay valid until build() has ended; `settings.subdivisions` is the number of parts.
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
