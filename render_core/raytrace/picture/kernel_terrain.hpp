/// Terrain traced by the vector kernels: the posts themselves, or a stored surface with `parts` posts to one of
/// the scene's.
///
/// Memory  none of its own. set_view() before a picture; then any thread.
#pragma once

#include "render_core/raytrace/picture/picture_sight.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"

namespace tedavis::raytrace {

template <class Height>
class KernelTerrain final : public TracedTerrain {
public:
    /// The field is borrowed, its mipmaps too; pictures are of this size.
    void start(const TracedField<Height>& field, std::uint32_t parts, std::uint32_t width, std::uint32_t height);
    /// The sight is of the scene's grid space; pictures of the world are of its size. Stays where it is from then on.
    void set_view(const PictureSight& sight, const ViewKernel<Height>& kernel);

    /// Rectangles of whole tiles of the kernel, as far as the picture has them. Asks for u and v of hits.
    void trace(const PixelRect& rect, const HitPicture& hits) const override;
    void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const override;
    [[nodiscard]] RayHit meet(const Ray& ray) const override;
    [[nodiscard]] bool is_hidden(const Ray& ray) const override;

private:
    /// A meeting of a straight ray, and where in the cell.
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
    GroundView<Height> ground_;  ///< where the world is seen
    const ViewKernel<Height>* kernel_ = nullptr;
};

}  // namespace tedavis::raytrace
