/// Drape pages on the GPU: one RGBA8 atlas with a fixed number of page slots, and a transparent texel for chunks without a
/// page.
///
/// Sampled with a linear filter between the centres of a page's first and last texel, so neighbours never bleed in. As the side
/// is a power of two and pages start at whole texels, a page looks the same to the last bit in every slot: see
/// terrain_image.frag. Pages of 129 texels leave room beside them in such a square; the transparent texel lies there.
///
/// Memory    GPU, from the budget line terrain_drape_pages. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::draw {

/// The middle of a page's first texel in the atlas, texels.
struct DrapeOrigin {
    float x = 0, y = 0;
};

class DrapeAtlas {
public:
    /// `slots` 1 or more.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t slots);
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t slots);
    [[nodiscard]] bool is_started() const { return texture_.valid(); }

    [[nodiscard]] bool upload(gl::Gl& gl, std::uint32_t slot, const terrain::DrapePage& page);
    void bind(gl::Gl& gl, std::uint32_t unit) const { texture_.bind(gl, unit); }

    [[nodiscard]] DrapeOrigin origin(std::uint32_t slot) const;
    /// A transparent texel, to be sampled at this position only.
    [[nodiscard]] DrapeOrigin nowhere() const;
    /// One over the side, texels.
    [[nodiscard]] float scale() const;
    void destroy(gl::Gl& gl) { texture_.destroy(gl); }

private:
    gl::Texture texture_;
};

}  // namespace tedavis::draw
