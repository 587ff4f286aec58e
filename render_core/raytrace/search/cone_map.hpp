/// **Inexact.** Finds the hit of a ray with a bilinear surface by steps that a cone over each post permits (relaxed cone
/// stepping: Policarpo and Oliveira 2007).
///
/// A post's cone has its tip at the post and opens upwards, as wide as possible so that a ray that descends inside it enters the
/// surface at most once, as far as the map has sampled. A step leads to where the ray leaves the cone of the nearest post; the
/// first step that ends below the surface is halved until the hit is precise. Cones are widest where steps of fixed length are
/// slowest: over valleys and flat ground.
///
/// What goes wrong: the map samples the surface along some azimuths, out to a radius, at distances of one post. Ground between
/// the samples may lie inside a cone, and a step may pass it. Relaxed cones are computed for rays from above the highest ground
/// within the radius; flatter rays may leave a ridge sooner, and pass it. Between posts the cone of the nearest post is used. A
/// step is never longer than the radius. A ray whose steps run out has no hit, most often near the horizon. A ray that begins
/// below the surface hits it at once.
///
/// Memory  from an arena: 4 bytes per post. Thread  build() uses the workers; searching any. Cost of build(), per post: azimuths
/// times half the square of the radius.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/search/surface_hit.hpp"

namespace tedavis::raytrace {

struct ConeSettings {
    std::uint32_t azimuths = 16;  ///< 4..64
    std::uint32_t radius = 16;    ///< posts, 1..256
    /// False: cones that contain no part of the surface (Dummer 2006). They are narrower, so that more steps are needed, but no
    /// sampled ground is passed, however flat the ray.
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
    /// Allocates memory; returns false where the arena is too small. The grid is borrowed and must outlive the map.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, const ConeSettings& settings, base::Arena& arena);
    void build(base::Workers& workers);

    /// Radius of a post's cone in posts, per height step above the post; 0 where the post has no height.
    [[nodiscard]] float ratio(std::uint32_t column, std::uint32_t row) const;
    /// Returns the hit found, or none after `search.steps` steps.
    [[nodiscard]] SurfaceHit search(const Ray& ray, const ConeSearch& search) const;

private:
    void build_row(std::uint32_t row);
    [[nodiscard]] float narrowest_along(std::uint32_t column, std::uint32_t row, double across, double down) const;

    HeightGrid<Height> grid_;
    ConeSettings settings_;
    base::Span<float> ratios_;
};

}  // namespace tedavis::raytrace
