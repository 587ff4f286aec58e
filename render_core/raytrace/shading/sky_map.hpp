/// The sky visible from each post: ambient occlusion (Zhukov et al. 1998; Pharr and Green 2004) and ambient apertures (Oat and
/// Sander 2007), precomputed from horizons.
///
/// The horizon is searched along a number of azimuths, out to a radius, where the ray crosses columns or rows of posts
/// (whichever are more), with heights interpolated linearly between posts. It is never below the horizontal, nor below the
/// tangent plane of the surface. Voids and the outside of the grid hide nothing.
///
/// - Sky view: the share of the light of a uniform sky that falls on the surface (Dozier and Frew 1990). It is exactly 1 for a
///   level plane, and (1 + cos slope) / 2 for a tilted one, because there is no sky below the horizontal.
/// - Aperture: a cone with the solid angle of the visible sky, about its mean direction. Where sky is visible in two separate
///   parts, between ridges, the cone lies between them: this error is due to the method, not to precision.
///
/// What is inexact: few azimuths (error about n^-1.6) and above all a short radius, with which results are too light. Results are
/// stored in 8 and 16 bits. Of the C library only sqrt is used, so maps are equal on every machine.
///
/// Memory  from an arena: 1 byte per post, 7 with apertures. Thread  build() uses the workers; reading any. Cost of build():
/// azimuths times radius posts per post.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/height_grid.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

struct SkyMapSettings {
    static constexpr std::uint32_t kMaxAzimuths = 128;

    std::uint32_t azimuths = 16;  ///< 4..kMaxAzimuths
    std::uint32_t radius = 64;    ///< posts, 1 or more
    GridScale scale;
    bool has_apertures = false;
};

/// A cone through which the sky is visible.
struct Aperture {
    glm::dvec3 axis{0, 0, 1};  ///< unit vector
    double cos_radius = 0;     ///< 0: a hemisphere; 1: nothing
};

/// The result for one point, in double precision.
struct SkySeen {
    double view = 1;
    Aperture aperture;
};

/// Returns the highest tangent of elevation over the posts along one azimuth, 0 or more. `direction` is a unit vector in
/// metres.
template <class Height>
[[nodiscard]] double horizon_slope(const HeightGrid<Height>& grid, const GridScale& scale, std::uint32_t column,
                                   std::uint32_t row, const glm::dvec2& direction, std::uint32_t radius);

/// Returns the sky visible from a post that has a height.
template <class Height>
[[nodiscard]] SkySeen sky_seen_at(const HeightGrid<Height>& grid, const SkyMapSettings& settings, std::uint32_t column,
                                  std::uint32_t row);

template <class Height>
class SkyMap {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows, bool has_apertures);
    /// Allocates memory; returns false where the arena is too small. The grid must stay valid until build() has ended.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, const SkyMapSettings& settings, base::Arena& arena);
    void build(base::Workers& workers);

    /// Returns the sky view at a point of grid space, interpolated between posts; outside the grid that of its border.
    [[nodiscard]] double view_at(double x, double y) const;
    /// Returns the aperture; only with apertures. Where there is no mean direction, `normal` is used.
    [[nodiscard]] Aperture aperture_at(double x, double y, const glm::dvec3& normal) const;

    struct StoredAperture {
        std::int16_t x, y;         ///< of the axis, 1 is 32767
        std::uint16_t cos_radius;  ///< 1 is 65535
    };
    /// The stored sky views of all posts, row by row, for bulk reading; 1 is 255.
    [[nodiscard]] base::Span<const std::uint8_t> stored_views() const { return views_; }
    /// Empty without apertures.
    [[nodiscard]] base::Span<const StoredAperture> stored_apertures() const { return apertures_; }
    [[nodiscard]] std::uint32_t columns() const { return grid_.columns; }
    [[nodiscard]] std::uint32_t rows() const { return grid_.rows; }

private:
    void build_row(std::uint32_t row);

    HeightGrid<Height> grid_;
    SkyMapSettings settings_;
    base::Span<std::uint8_t> views_;  ///< 1 is 255
    base::Span<StoredAperture> apertures_;
};

}  // namespace tedavis::raytrace
