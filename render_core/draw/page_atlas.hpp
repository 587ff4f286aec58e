/// Attribute pages on the GPU: one atlas a map that the style reads, a fixed number of page slots in each.
///
/// Sampled with a linear filter between the centres of a page's first and last texel, so neighbours never bleed in. The
/// horizon atlas holds the horizon towards one azimuth, mixed from the two nearest baked directions when a page is uploaded.
/// Memory    GPU, from the budget line terrain_pages. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/terrain_style.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::draw {

/// Texture coordinates = place * scale + offset, both axes.
struct PageWindow {
    float scale = 0, offset_x = 0, offset_y = 0;
};

class PageAtlas {
public:
    /// `slots` 1 or more; `staging` holds one page of texels.
    [[nodiscard]] gl::GlError start(gl::Gl& gl, base::BudgetLine& line, const design::TerrainStyle& style, std::uint32_t slots,
                                    base::Arena& staging);
    [[nodiscard]] static std::uint64_t bytes_needed(const design::TerrainStyle& style, std::uint32_t slots);
    [[nodiscard]] bool is_started() const { return slots_ > 0; }
    [[nodiscard]] bool has(design::BakedMap map) const { return textures_[static_cast<std::size_t>(map)].valid(); }

    /// The maps of one page. `east_m`, `north_m`: its texels' spacing, for the azimuths of the baked directions.
    [[nodiscard]] bool upload(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page);
    [[nodiscard]] bool upload_horizon(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page, double azimuth_rad,
                                      double east_m, double north_m);
    void bind(gl::Gl& gl) const;

    /// From texels of the page (0 its first post) to the atlases of maps, and from there to the horizon's atlas.
    [[nodiscard]] PageWindow map_window(std::uint32_t slot) const;
    [[nodiscard]] PageWindow horizon_window(std::uint32_t slot) const;
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] std::uint32_t side() const;
    gl::Texture textures_[design::kBakedMaps];
    std::uint32_t slots_ = 0;
    base::Span<std::uint8_t> horizon_;
};

}  // namespace tedavis::draw
