/// Attribute pages on the GPU: one atlas per map that styles read, each with a fixed number of page slots.
///
/// Sampled with a linear filter between the centres of a page's first and last texel, so neighbours never bleed in. Sides are
/// powers of two, so that a place in a page has the same fraction of a texel in every slot: see terrain_ground.frag. The horizon
/// atlas holds the horizon towards one azimuth, interpolated from the two nearest stored directions when a page is uploaded.
/// Memory    GPU, from the budget line terrain_pages. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/terrain_style.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::draw {

/// Position of the centre of a page's first texel in its atlases, in texels.
struct PageOrigin {
    float map_x = 0, map_y = 0, horizon_x = 0, horizon_y = 0;
};

class PageAtlas {
public:
    /// `slots` 1 or more; `staging` holds one page of texels. With `coast` there is also the map that separates sea from land.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, const design::MapSet& maps, bool coast,
                                    std::uint32_t slots, base::Arena& staging);
    [[nodiscard]] static std::uint64_t bytes_needed(const design::MapSet& maps, bool coast, std::uint32_t slots);
    [[nodiscard]] bool is_started() const { return slots_ > 0; }
    [[nodiscard]] bool has(design::BakedMap map) const { return textures_[static_cast<std::size_t>(map)].valid(); }

    /// Uploads the maps of one page; without `coast` the maps that only a coast needs are left out.
    [[nodiscard]] bool upload(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page, bool coast);
    /// Uploads the horizon towards an azimuth. The spacing of the page's texels determines the azimuths of the stored directions.
    [[nodiscard]] bool upload_horizon(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page, double azimuth_rad,
                                      double east_m, double north_m);
    void bind(gl::Gl& gl) const;

    [[nodiscard]] PageOrigin origin(std::uint32_t slot) const;
    /// One over the side of the atlases of maps and of horizons, texels.
    [[nodiscard]] float map_scale() const;
    [[nodiscard]] float horizon_scale() const;
    void destroy(gl::Gl& gl);

private:
    gl::Texture textures_[design::kBakedMaps];
    std::uint32_t slots_ = 0;
    bool light_is_for_coasts_ = false;  ///< no style itself reads the light map
    base::Span<std::uint8_t> horizon_;
};

}  // namespace tedavis::draw
