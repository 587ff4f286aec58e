/// Port: the terrain for a picture's stages: rectangles of primary rays, the surface at their hits, and single rays.
///
/// The implementation decides in which space rays are straight and which tracer is used. Results for a pixel do not depend on
/// the rectangle. Functions may be called by several threads at once.
#pragma once

#include "render_core/raytrace/shading/cast_shadow.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

struct PixelRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Adjacent pixels of a row.
struct PixelSpan {
    static constexpr std::uint32_t kMax = 64;
    std::uint32_t first = 0;  ///< y * width + x
    std::uint32_t count = 0;  ///< 0..kMax
};

/// The surface at the hits of up to PixelSpan::kMax rays: positions in posts of the scene's grid, heights in its steps, slopes
/// in steps per post. Values of rays without a hit are meaningless.
struct SpanSurface {
    static constexpr std::uint32_t kMax = PixelSpan::kMax;
    std::uint32_t count = 0;
    bool is_hit[kMax];
    double x[kMax], y[kMax];
    float height[kMax], slope_x[kMax], slope_y[kMax];
    float t[kMax];
};

/// The hit of a single ray.
struct RayHit {
    bool is_hit = false;
    float t = 0;
    double x = 0, y = 0;
    SurfacePoint point;
};

class TracedTerrain {
public:
    virtual ~TracedTerrain() = default;

    /// Writes t, cell, side, u and v of the pixels of a rectangle of whole tiles (kTileWidth x kTileHeight), clipped to the
    /// picture.
    virtual void trace(const PixelRect& rect, const HitPicture& hits) const = 0;
    /// Computes the surface of pixels that have been traced.
    virtual void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const = 0;
    /// Traces a ray in the scene's grid space.
    [[nodiscard]] virtual RayHit intersect(const Ray& ray) const = 0;
    [[nodiscard]] virtual bool is_hidden(const Ray& ray) const = 0;
};

}  // namespace tedavis::raytrace
