/// **Inexact.** Finds the hit of a ray with a bilinear surface by steps that a cone over each post permits (relaxed cone
/// stepping: Policarpo and Oliveira 2007).
///
/// The cone of a post stands on its tip there, so wide that a ray which is lowered within it enters the surface at most once, as
/// far as the map looked. A step goes to where the ray leaves the cone of the nearest post; the first step that ends below the
/// surface is halved until the place is precise. Cones are widest where stepping by fixed lengths is slowest: over valleys and
/// flats.
///
/// What goes wrong: the map looks along some azimuths, out to a radius, at posts; what it does not see, cones may hold, and a
/// step may pass. Relaxed cones are made for rays from above the highest ground around; flatter ones may leave a ridge sooner,
/// and pass it. Rays between posts use the cone of the nearest. A step is never longer than the radius. Where the steps run out
/// the ray meets nothing, most of all near the horizon. Rays that begin below the surface meet it where they are.
///
/// Memory  from an arena: 4 bytes a post. Thread  build() uses the workers; searching any. Cost of build(): azimuths times half
/// the square of the radius heights a post.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/search/surface_hit.hpp"

namespace tedavis::raytrace {

struct ConeSettings {
    std::uint32_t azimuths = 16;  ///< 4..64
    std::uint32_t radius = 16;    ///< posts, 1..256
    /// False: cones that hold none of the surface (Dummer 2006). Narrower, so that more steps are needed, but what they see is
    /// not passed, however flat the ray.
    bool is_relaxed = true;
};

struct ConeSearch {
    std::uint32_t steps = 96;     ///< 1 or more
    std::uint32_t halvings = 12;  ///< 0..24
};

template <class Height>
class ConeMap {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows) {
        return std::uint64_t{columns} * rows * sizeof(float) + alignof(float);
    }
    /// False where the arena has no room. The grid is borrowed and must stay.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, const ConeSettings& settings, base::Arena& arena);
    void build(base::Workers& workers);

    /// Posts of distance to a height step of the cone over a post; 0 where it has no height.
    [[nodiscard]] float ratio(std::uint32_t column, std::uint32_t row) const;
    [[nodiscard]] SurfaceHit search(const Ray& ray, const ConeSearch& search) const;

private:
    void build_row(std::uint32_t row);
    [[nodiscard]] float narrowest_along(std::uint32_t column, std::uint32_t row, double across, double down) const;

    HeightGrid<Height> grid_;
    ConeSettings settings_;
    base::Span<float> ratios_;
};

}  // namespace tedavis::raytrace
