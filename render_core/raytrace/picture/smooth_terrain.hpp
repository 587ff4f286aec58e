/// Terrain with any surface of surface/, traced ray by ray in double: exactly (search/trace_surface.hpp), or by one of the
/// approximate searches (search/search_settings.hpp).
#pragma once

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/picture/picture_sight.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"
#include "render_core/raytrace/search/cone_map.hpp"
#include "render_core/raytrace/search/search_settings.hpp"
#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::raytrace {

template <class Height>
class SmoothTerrain final : public TracedTerrain {
public:
    /// Mipmap and settings are borrowed; the mipmap's bounds must be those of the surface (surface_bounds.hpp).
    void start(const HeightMipmap<Height>& maxima, const SurfaceSettings& settings, std::uint32_t width);
    /// Replaces the exact search. `cones` are borrowed and needed by the search with cones only.
    void set_search(const SearchSettings& search, const ConeMap<Height>* cones);
    void set_view(const PictureSight& sight);

    void trace(const PixelRect& rect, const HitPicture& hits) const override;
    void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const override;
    [[nodiscard]] RayHit intersect(const Ray& ray) const override;
    [[nodiscard]] bool is_hidden(const Ray& ray) const override;

private:
    const HeightMipmap<Height>* maxima_ = nullptr;
    const SurfaceSettings* settings_ = nullptr;
    SearchSettings search_;
    const ConeMap<Height>* cones_ = nullptr;

    [[nodiscard]] double way_over_grid(const Ray& straight) const;
    [[nodiscard]] double whole_way(const Ray& ray) const;
    [[nodiscard]] SurfaceHit searched(const Ray& straight, double whole) const;
    [[nodiscard]] SurfaceHit hit_of(const Ray& straight, double whole) const;
    [[nodiscard]] SurfaceHit first_hit(const Ray& ray) const;

    PictureSight sight_;
    double highest_ = 0;  ///< of the surface
    std::uint32_t width_ = 0;
};

}  // namespace tedavis::raytrace
