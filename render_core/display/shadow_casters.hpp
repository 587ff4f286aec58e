/// Draws a frame's shadow casters into the shadow map, in the levels that have any.
///
/// Memory    the map's, from the budget line render_targets, at start(). Thread  the GL thread.
/// Failure   start() gives one message.
#pragma once

#include "render_core/display/element_painter.hpp"
#include "render_core/draw/drawers/shadow_map.hpp"

namespace tedavis::display {

class ShadowCasters {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t level_px);
    [[nodiscard]] bool is_started() const { return map_.is_started(); }
    [[nodiscard]] const draw::ShadowMap& map() const { return map_; }
    /// Draws the casters. `drawers`: the drawers to which they are uploaded. `eye`: the eye point of the picture, ECEF. Leaves
    /// another framebuffer bound. Returns the number of draws.
    std::uint32_t draw(gl::Gl& gl, const CasterDrawers& drawers, const CasterSet& casters, const draw::ShadowFrame& frame,
                       const glm::dvec3& eye) const;
    void destroy(gl::Gl& gl);

private:
    draw::ShadowMap map_;
    draw::SolidCasters solids_;
};

}  // namespace tedavis::display
