/// Terrain traced by the vector kernels: the scene's posts, or a stored surface with `parts` posts per post of the scene.
///
/// Memory  none of its own. set_view() before a picture; then any thread.
#pragma once

#include "render_core/raytrace/picture/picture_sight.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"

namespace tedavis::raytrace {

template <class Height>
class KernelTerrain final : public TracedTerrain {
public:
    /// The field and its mipmaps are borrowed; `width` and `height` are those of pictures.
    void start(const TracedField<Height>& field, std::uint32_t parts, std::uint32_t width, std::uint32_t height);
    /// Sets the view, in the scene's grid space; pictures of the world have its size. The object must not be moved afterwards.
    void set_view(const PictureSight& sight, const ViewKernel<Height>& kernel);

    /// Traces rectangles of whole kernel tiles, clipped to the picture. Needs u and v of hits.
    void trace(const PixelRect& rect, const HitPicture& hits) const override;
    void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const override;
    [[nodiscard]] RayHit intersect(const Ray& ray) const override;
    [[nodiscard]] bool is_hidden(const Ray& ray) const override;

private:
    /// A hit of a straight ray, with its position in the cell.
    struct PlacedHit {
        HitSide side = HitSide::none;
        float t = std::numeric_limits<float>::infinity();
        std::uint32_t column = 0, row = 0;
        double u = 0, v = 0;
    };
    [[nodiscard]] Ray own_ray(const Ray& ray) const;
    [[nodiscard]] PlacedHit hit_of(const Ray& straight) const;
    [[nodiscard]] PlacedHit first_hit(const Ray& ray) const;

    TracedField<Height> field_;
    std::uint32_t parts_ = 1, width_ = 0, height_ = 0;
    PictureSight sight_;
    GroundView<Height> ground_;  ///< used for pictures of the world
    const ViewKernel<Height>* kernel_ = nullptr;
};

}  // namespace tedavis::raytrace
