#include "render_core/display/element_painter.hpp"

#include "render_core/effects/device.hpp"

namespace tedavis::display {

base::Error ElementPainter::start(gl::Gl& gl, base::BudgetTable& budget, const ElementPlanner::Memory& memory,
                                  const ElementPlanner& planner, const draw::QuadDrawer& typeface,
                                  const draw::DataVariant& variant) {
    planner_ = &planner;
    const SolidRooms rooms = solid_rooms(budget);
    base::BudgetLine& solids = *budget.find(effects::kSceneSolidVertices);
    if (base::Error error = standing_.start(gl, solids, planner.standing(), rooms.standing, gl::BufferUse::fixed)) return error;
    if (base::Error error = moving_.start(gl, solids, planner.moving(), rooms.moving, gl::BufferUse::streamed)) return error;
    base::BudgetLine& glyphs = *budget.find(effects::kSceneGlyphVertices);
    if (base::Error error = glyph_drawer_.start(gl, glyphs, memory.glyphs, variant.air)) return error;
    if (variant.shadows)
        if (base::Error error = glyph_drawer_.start_casters(gl)) return error;
    if (base::Error error = link_drawer_.start_links(gl, budget, planner.links())) return error;
    if (base::Error error = sign_drawer_.start_signs(gl, budget, planner.signs(), typeface)) return error;
    return drawer_.start(gl, memory.solids, rooms.standing.pieces + rooms.moving.pieces, variant);
}

void ElementPainter::prepare(gl::Gl& gl, const PlannedElements& planned) {
    if (!planned.has_reports) return;
    if (standing_key_ != planned.standing_key && standing_.upload(gl)) standing_key_ = planned.standing_key;
    moving_is_uploaded_ = moving_.upload(gl);
    glyph_drawer_.upload(gl, planner_->glyphs());
    static_cast<void>(link_drawer_.upload(gl));
}

std::uint32_t ElementPainter::draw(gl::Gl& gl, const PlannedElements& planned, const draw::DataFrame& frame,
                                   const draw::DepthPlan& depth, std::size_t n) {
    if (standing_key_ != planned.standing_key || !moving_is_uploaded_ || planned.shown == 0) return 0;
    const draw::SolidBuffers* const solids[] = {&standing_, &moving_};
    const draw::DepthRange& range = depth.ranges[n];
    const draw::SolidFrame shown{frame, planned.shown, planned.time.utc.ns, planned.time.is_date};
    std::uint32_t draws = drawer_.draw(gl, solids, shown, range);
    if (!planner_->glyphs().instances().empty()) draws += glyph_drawer_.draw(gl, frame, range);
    return draws + link_drawer_.draw_within(gl, frame.view.width, frame.view.height, depth, n);
}

std::uint32_t ElementPainter::draw_signs(gl::Gl& gl, const PlannedElements& planned, std::uint32_t width, std::uint32_t height) {
    return planned.shown == 0 ? 0 : sign_drawer_.draw(gl, width, height);
}

void ElementPainter::destroy(gl::Gl& gl) {
    glyph_drawer_.destroy(gl);
    drawer_.destroy(gl);
    sign_drawer_.destroy(gl);
    link_drawer_.destroy(gl);
    standing_.destroy(gl);
    moving_.destroy(gl);
}

}  // namespace tedavis::display
