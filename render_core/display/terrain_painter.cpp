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
    for (const draw::DrawnDesign& drawn : designs)
        if (draw::trace_state_of(drawn) == draw::TraceState::traced && tracer() == draw::TraceState::not_asked_for)
            if (base::Error error = traced_.start(gl, planner.database(), planner.heights(), device, traced)) return error;
    design_ = *designs[0].design;
    is_started_ = true;
    return {};
}

bool TerrainPainter::shows(const draw::DrawnDesign& design) const {
    if (!is_started_) return true;
    const bool is_new_to_rays =
        draw::trace_state_of(design) == draw::TraceState::traced && tracer() == draw::TraceState::not_asked_for;
    return drawer_.shows(design) && !is_new_to_rays;
}

void TerrainPainter::set_design(gl::Gl& gl, const draw::DrawnDesign& design) {
    if (!is_started_) return;
    drawer_.set_design(gl, design);
    if (tracer() == draw::TraceState::traced) design_ = *design.design;
}

bool TerrainPainter::prepare(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input) {
    return seen.is_traced || drawer_.prepare(gl, seen.chunks, input);
}

void TerrainPainter::draw(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
                          draw::TerrainDrawResult& result) {
    drawer_.draw(gl, seen.chunks, input, range, result);
}

void TerrainPainter::draw_traced(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input,
                                 const gl::Texture& picture) {
    traced_.draw(gl, design_, no_farther(seen, input), picture);
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
