/// Draws the elements of the data aspect that were planned.
///
///   start(...) · prepare(planned) and draw(...) each frame
///
/// Memory    the rest of the lines scene_solids and scene_glyphs, and the lines of their vertices (GPU). Thread  the GL thread.
/// Failure   start() gives one message.
#pragma once

#include "render_core/display/planner/caster_set.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/draw/drawers/data/glyph_drawer.hpp"
#include "render_core/draw/drawers/data/solid_drawer.hpp"
#include "render_core/draw/drawers/quad_drawer.hpp"

namespace tedavis::display {

/// The drawers of the batches of a CasterSet, in its order.
struct CasterDrawers {
    const draw::SolidBuffers* solids[draw::kMaxSolidBuffers] = {};
    draw::GlyphDrawer* glyphs = nullptr;
};

class ElementPainter {
public:
    /// `planner` must have been started and must outlive the painter, which uploads from its memory. `typeface`: a drawer whose
    /// typeface is used; it must outlive the painter, too.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, const ElementPlanner::Memory& memory,
                                    const ElementPlanner& planner, const draw::QuadDrawer& typeface,
                                    const draw::DataVariant& variant = {});
    [[nodiscard]] bool is_started() const { return drawer_.is_started(); }
    /// Returns false where the design needs programs that were not built.
    [[nodiscard]] bool can_show(const design::DesignSettings& design) const {
        return !is_started() ||
               ((drawer_.has_grid() || !has_grid_on_data(design)) && (drawer_.can_magnify() || !design::magnifies(design)));
    }

    /// Uploads what is new; to be called before draw().
    void prepare(gl::Gl& gl, const PlannedElements& planned);
    /// Draws everything in the n-th depth range except the signs. Returns the number of draws.
    std::uint32_t draw(gl::Gl& gl, const PlannedElements& planned, const draw::DataFrame& frame, const draw::DepthPlan& depth,
                       std::size_t n);
    /// Draws the signs over the picture, after the last depth range. Leaves the depth test disabled. Returns the number of draws.
    std::uint32_t draw_signs(gl::Gl& gl, const PlannedElements& planned, std::uint32_t width, std::uint32_t height);
    /// Returns what draws the elements that cast shadows; to be called after prepare().
    [[nodiscard]] CasterDrawers caster_drawers() { return {{&standing_, &moving_}, &glyph_drawer_}; }
    void destroy(gl::Gl& gl);

private:
    const ElementPlanner* planner_ = nullptr;
    draw::SolidBuffers standing_, moving_;
    draw::SolidDrawer drawer_;
    draw::GlyphDrawer glyph_drawer_;
    draw::QuadDrawer sign_drawer_, link_drawer_;
    std::uint64_t standing_key_ = 0;  ///< of what is uploaded
    bool moving_is_uploaded_ = false;
};

}  // namespace tedavis::display
