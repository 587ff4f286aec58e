#include "render_core/display/terrain_painter.hpp"

namespace tedavis::display {
namespace {

/// Rays end behind the last of the terrain.
draw::TerrainDrawInput no_farther(const SeenTerrain& seen, draw::TerrainDrawInput input) {
    input.view.far_m = seen.depth.ranges[0].far_m;
    return input;
}

}  // namespace

/// Memory for tracing is used only where a design can be traced.
base::Error TerrainPainter::start(gl::Gl& gl, TerrainPlanner& planner, draw::DrawnDesigns designs,
                                  effects::DeviceSettings& device, base::Arena& staging, const draw::TracePlace& traced) {
    if (base::Error error = drawer_.start(gl, planner.store(), planner.chunk_indices(), designs, device, staging)) return error;
    draw::TracePlace place = traced;
    for (const draw::DrawnDesign& drawn : designs) place.writes_words = place.writes_words || drawn.is_deferred;
    writes_words_ = place.writes_words;
    for (const draw::DrawnDesign& drawn : designs)
        if (draw::trace_state_of(drawn) == draw::TraceState::traced && tracer() == draw::TraceState::not_asked_for)
            if (base::Error error = traced_.start(gl, planner.database(), planner.heights(), device, place)) return error;
    design_ = *designs[0].design;
    is_deferred_ = designs[0].is_deferred;
    is_started_ = true;
    return {};
}

bool TerrainPainter::shows(const draw::DrawnDesign& design) const {
    if (!is_started_) return true;
    const bool is_new_to_rays =
        draw::trace_state_of(design) == draw::TraceState::traced && tracer() == draw::TraceState::not_asked_for;
    const bool needs_words = design.is_deferred && !writes_words_;
    return drawer_.shows(design) && !is_new_to_rays && !needs_words;
}

void TerrainPainter::set_design(gl::Gl& gl, const draw::DrawnDesign& design) {
    if (!is_started_) return;
    drawer_.set_design(gl, design);
    if (tracer() != draw::TraceState::traced) return;
    design_ = *design.design;
    is_deferred_ = design.is_deferred;
}

bool TerrainPainter::prepare(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input) {
    return (seen.is_traced && !is_deferred_) || drawer_.prepare(gl, seen.chunks, input);
}

void TerrainPainter::draw(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
                          draw::TerrainDrawResult& result) {
    drawer_.draw(gl, seen.chunks, input, range, result);
}

void TerrainPainter::draw_traced(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input,
                                 const gl::Texture& picture) {
    traced_.draw(gl, design_, no_farther(seen, input), picture);
}

void TerrainPainter::draw_shaded(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input) {
    drawer_.shade(gl, seen.chunks, input, traced_.draw_words(gl, seen.chunks, no_farther(seen, input)));
}

void TerrainPainter::draw_depths(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input,
                                 const draw::DepthRange& range, draw::TerrainDrawResult& result) {
    if (seen.is_traced) return traced_.draw_depths(gl, no_farther(seen, input), range);
    drawer_.draw(gl, seen.chunks, input, range, result);
}

void TerrainPainter::destroy(gl::Gl& gl) {
    traced_.destroy(gl);
    drawer_.destroy(gl);
}

}  // namespace tedavis::display
