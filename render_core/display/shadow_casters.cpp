#include "render_core/display/shadow_casters.hpp"

namespace tedavis::display {

base::Error ShadowCasters::start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t level_px) {
    if (base::Error error = map_.start(gl, line, level_px)) return error;
    return solids_.start(gl);
}

std::uint32_t ShadowCasters::draw(gl::Gl& gl, const CasterDrawers& drawers, const CasterSet& casters,
                                  const draw::ShadowFrame& frame, const glm::dvec3& eye) const {
    std::uint32_t draws = 0;
    for (std::size_t n = 0; n < draw::kShadowLevels; ++n) {
        if (!frame.levels[n].is_used) continue;
        map_.begin_level(gl, n);
        const draw::CasterView view{frame, n, draw::texel_m(frame.levels[n], map_.level_px()), eye};
        if (casters.solids[0] != nullptr) draws += solids_.draw(gl, drawers.solids, casters.groups, view);
        if (casters.glyph_slots != 0) draws += drawers.glyphs->draw_casters(gl, casters.glyph_slots, view);
    }
    map_.end(gl);
    return draws;
}

void ShadowCasters::destroy(gl::Gl& gl) {
    map_.destroy(gl);
    solids_.destroy(gl);
}

}  // namespace tedavis::display
