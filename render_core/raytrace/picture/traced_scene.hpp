/// The data that a picture's settings need, prepared at start: bounds, stored surface, averages, sky map; and their memory.
///
/// Call start(), then build() with workers, then set_view() before each picture. When posts have changed, call build() again.
/// Memory  from an arena, at start. Thread  reading from any thread.
#pragma once

#include "render_core/base/fault_text.hpp"
#include "render_core/base/result.hpp"
#include "render_core/raytrace/picture/kernel_terrain.hpp"
#include "render_core/raytrace/picture/smooth_terrain.hpp"
#include "render_core/raytrace/picture/stored_surface.hpp"
#include "render_core/raytrace/picture/trace_settings.hpp"
#include "render_core/raytrace/shading/sky_map.hpp"
#include "render_core/raytrace/surface/average_mipmap.hpp"

namespace tedavis::raytrace {

struct SceneSize {
    static constexpr std::uint32_t kMaxSide = 16384;
    std::uint32_t width = 0, height = 0;  ///< size of pictures
    std::uint32_t sky_azimuths = 16, sky_radius = 64;
};

struct PreparedItem {
    base::FixedString<31> name;
    std::uint64_t bytes = 0;
};

/// Maps for shading; null where the settings do not need them.
template <class Height>
struct ShadingMaps {
    const SkyMap<Height>* sky = nullptr;
    const AverageMipmap<Height>* averages = nullptr;
    GridScale scale;
};

template <class Height>
class TracedScene {
public:
    using Answer = base::Result<std::uint64_t, base::FaultText>;
    static constexpr std::size_t kMaxItems = 8;

    /// Bytes that suffice for start().
    [[nodiscard]] static std::uint64_t bytes_needed(const HeightGrid<Height>& grid, base::Span<const TraceSettings> settings);
    /// Prepares pictures with any of `settings`; settings that are not traced by the kernel on the posts must have the same
    /// surface and search. The grid must outlive the scene. Returns the allocated bytes, or one sentence.
    [[nodiscard]] Answer start(const HeightGrid<Height>& grid, const GridScale& scale, base::Span<const TraceSettings> settings,
                               const SceneSize& size, base::Arena& arena);
    /// Prepares pictures over another terrain, which must outlive the scene; `settings` need primary hits only
    /// (needs_primary_hits_only). Nothing is allocated; returns 0, or one sentence.
    [[nodiscard]] Answer start(const TracedTerrain& terrain, const GridScale& scale, const TraceSettings& settings,
                               const SceneSize& size);
    void build(base::Workers& workers);
    /// Sets the view. `kernel` and `fine_kernel` are from view_kernels().
    void set_view(const PictureSight& sight, const ViewKernel<Height>& kernel, const ViewKernel<float>& fine_kernel);

    /// Returns the terrain for settings with which the scene was started.
    [[nodiscard]] const TracedTerrain& terrain(const TraceSettings& settings) const;
    [[nodiscard]] ShadingMaps<Height> maps() const;
    [[nodiscard]] const PictureSight& sight() const { return sight_; }
    [[nodiscard]] const GridScale& scale() const { return scale_; }
    [[nodiscard]] const SceneSize& size() const { return size_; }
    /// The items in the arena, without the heights, which the caller owns.
    [[nodiscard]] base::Span<const PreparedItem> items() const { return {items_.data(), items_.size()}; }
    [[nodiscard]] std::uint64_t bytes() const;

private:
    struct Needs;
    [[nodiscard]] static Answer check_size(const SceneSize& size);
    [[nodiscard]] static Answer check_needs(const HeightGrid<Height>& grid, const Needs& needs);
    [[nodiscard]] static Needs needs_of(base::Span<const TraceSettings> settings);
    [[nodiscard]] bool start_posts(base::Arena& arena);
    [[nodiscard]] bool start_stored(base::Arena& arena);
    [[nodiscard]] bool start_smooth(base::Arena& arena);
    [[nodiscard]] bool start_maps(const Needs& needs, base::Arena& arena);
    void note(const char* name, std::uint64_t before, const base::Arena& arena);

    const TracedTerrain* other_terrain_ = nullptr;  ///< null: one of those below
    HeightGrid<Height> grid_;
    GridScale scale_;
    SceneSize size_;
    PictureSight sight_;
    SurfaceSettings stored_settings_, smooth_settings_;
    SearchSettings smooth_search_;
    bool has_triangles_ = false, has_bilinear_ = false, has_stored_ = false, has_smooth_ = false, has_cones_ = false,
         has_sky_ = false, has_averages_ = false;
    HeightMipmap<Height> maxima_, smooth_maxima_;
    StoredSurface<Height> stored_;
    HeightMipmap<float> stored_maxima_;
    ConeMap<Height> cones_;
    AverageMipmap<Height> averages_;
    SkyMap<Height> sky_;
    KernelTerrain<Height> triangles_, bilinear_;
    KernelTerrain<float> fine_;
    SmoothTerrain<Height> smooth_;
    base::FixedVector<PreparedItem, kMaxItems> items_;
};

}  // namespace tedavis::raytrace
