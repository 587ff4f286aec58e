/// Terrain of flat scenes, traced by the vector kernels: the posts themselves, or a stored surface with `parts` posts to one of
/// the scene's.
///
/// Memory  none of its own. set_view() before a picture; then any thread.
#pragma once

#include "render_core/raytrace/picture/traced_terrain.hpp"

namespace tedavis::raytrace {

template <class Height>
class KernelTerrain final : public TracedTerrain {
public:
    /// The field is borrowed, its mipmaps too; pictures are of this size.
    void start(const TracedField<Height>& field, std::uint32_t parts, std::uint32_t width, std::uint32_t height);
    /// The camera is in the scene's grid space.
    void set_view(const GridCamera& camera, const ViewKernel<Height>& kernel);

    /// Rectangles of whole tiles of the kernel, or of its lanes in whole columns where those are swept, are traced by the kernel;
    /// others ray by ray, with the same result. Asks for u and v of hits.
    void trace(const PixelRect& rect, const HitPicture& hits) const override;
    void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const override;
    [[nodiscard]] RayMeeting meet(const Ray& ray) const override;
    [[nodiscard]] bool is_hidden(const Ray& ray) const override;

private:
    [[nodiscard]] Ray own_ray(const Ray& ray) const;

    TracedField<Height> field_;
    std::uint32_t parts_ = 1, width_ = 0, height_ = 0;
    GridCamera camera_;
    const ViewKernel<Height>* kernel_ = nullptr;
};

}  // namespace tedavis::raytrace
