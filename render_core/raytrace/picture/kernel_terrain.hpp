/// Terrain of flat scenes, traced by the vector kernels: the posts themselves, or a stored surface with `parts` posts to one of
/// the scene's.
///
/// Memory  an arena's, at start: what the kernel's beams take. set_view() before a picture; then any thread.
#pragma once

#include "render_core/raytrace/picture/traced_terrain.hpp"

namespace tedavis::raytrace {

template <class Height>
class KernelTerrain final : public TracedTerrain {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t width, std::uint32_t height);
    /// False where the arena has no room. The field is borrowed, its mipmaps too.
    [[nodiscard]] bool start(const TracedField<Height>& field, std::uint32_t parts, std::uint32_t width, std::uint32_t height,
                             base::Arena& arena);
    /// The camera is in the scene's grid space.
    void set_view(const GridCamera& camera, const ViewKernel<Height>& kernel);

    /// Bands of kBandRows rows of the whole width, or groups of the kernel's lanes of columns where those are swept, are traced
    /// by the kernel; other rectangles ray by ray, with the same result.
    void trace(const PixelRect& rect, const HitPicture& hits) const override;
    void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const override;
    [[nodiscard]] RayMeeting meet(const Ray& ray) const override;
    [[nodiscard]] bool is_hidden(const Ray& ray) const override;

private:
    [[nodiscard]] Ray own_ray(const Ray& ray) const;

    TracedField<Height> field_;
    std::uint32_t parts_ = 1, width_ = 0, height_ = 0;
    BeamStarts beams_[kBeamSizes];
    GridCamera camera_;
    const ViewKernel<Height>* kernel_ = nullptr;
};

}  // namespace tedavis::raytrace
