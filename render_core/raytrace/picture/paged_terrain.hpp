/// Terrain that need not be in memory, for pictures of the world whose settings need primary hits only
/// (needs_primary_hits_only): shading gets the cells of the hits from the paged tracer. The same bits as KernelTerrain.
///
/// Call start(), then trace_picture() before a picture is drawn; then any thread.
/// Memory  from an arena at start: 40 bytes per pixel, besides that of the tracer.
#pragma once

#include "render_core/raytrace/paged/trace_paged_ground.hpp"
#include "render_core/raytrace/picture/picture_sight.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"

namespace tedavis::raytrace {

class PagedTerrain final : public TracedTerrain {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t width, std::uint32_t height);
    /// Returns false where the arena is too small. The tracer is started for a picture's rays and must outlive the terrain.
    [[nodiscard]] bool start(PagedTracer<float>& tracer, CellSurface surface, std::uint32_t width, std::uint32_t height,
                             base::Arena& arena);
    /// Traces the primary rays of a picture of the world, which has the size of start(), and loads the chunks that they need.
    PagedWork trace_picture(const PictureSight& sight, const PacketKernel<float>& kernel, base::Workers& workers);

    /// Copies hits of the picture. The number of a cell may exceed 31 bits: `cell` is 0 for a hit.
    void trace(const PixelRect& rect, const HitPicture& hits) const override;
    void find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const override;
    /// Single rays are not available: a scene over this terrain refuses settings that need them.
    [[nodiscard]] RayHit intersect(const Ray& ray) const override;
    [[nodiscard]] bool is_hidden(const Ray& ray) const override;

private:
    PagedTracer<float>* tracer_ = nullptr;
    CellSurface surface_ = CellSurface::two_triangles;
    std::uint32_t width_ = 0, height_ = 0;
    base::Span<GridCamera> cameras_;
    base::Span<Hit> hits_;
    base::Span<HitCell<float>> cells_;
};

}  // namespace tedavis::raytrace
