/// The terrain as a picture's stages ask for it: whole rectangles of primary rays, the surface that these met, single rays.
///
/// Whoever implements it decides in which space rays are straight and which tracer runs. Functions give the same for a pixel
/// whatever rectangle it is asked in, and may be called by several threads at once.
#pragma once

#include "render_core/raytrace/shading/cast_shadow.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

struct PixelRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Neighbours in a row.
struct PixelSpan {
    static constexpr std::uint32_t kMax = 64;
    std::uint32_t first = 0;  ///< y * width + x
    std::uint32_t count = 0;  ///< to kMax
};

/// The surface where up to PixelSpan::kMax rays met it. Places in posts of the scene's grid, heights in its steps, slopes in
/// steps a post. What was not met means nothing.
struct SpanSurface {
    static constexpr std::uint32_t kMax = PixelSpan::kMax;
    std::uint32_t count = 0;
    bool is_met[kMax];
    double x[kMax], y[kMax];
    float height[kMax], slope_x[kMax], slope_y[kMax];
    float t[kMax];
};

/// What a single ray met.
struct RayHit {
    bool is_met = false;
    float t = 0;
    double x = 0, y = 0;
    SurfacePoint point;
};

class TracedTerrain {
public:
    virtual ~TracedTerrain() = default;

    /// t, cell, side, u and v of the pixels of a rectangle of whole tiles (kTileWidth x kTileHeight), as far as the picture has
    /// them.
    virtual void trace(const PixelRect& rect, const HitPicture& hits) const = 0;
    /// Of pixels that have been traced.
    virtual void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const = 0;
    /// A ray in the scene's grid space.
    [[nodiscard]] virtual RayHit meet(const Ray& ray) const = 0;
    [[nodiscard]] virtual bool is_hidden(const Ray& ray) const = 0;
};

}  // namespace tedavis::raytrace
