/// Draws the terrain that was planned: by triangles, or by rays where the plan says so.
///
///   start(...) · set_design(...) when it changes · prepare(seen, input) and draw(...) each frame
///
/// Memory    the staging arena and GPU lines given to start(). Thread  the GL thread. Failure  start() gives one message.
#pragma once

#include "render_core/display/planner/terrain_planner.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/draw/drawers/traced_terrain.hpp"

namespace tedavis::display {

class TerrainPainter {
public:
    /// For designs that follow one another; the first is drawn first. `traced`: where terrain is traced, if a design wants it.
    /// The planner is started, and must outlive it: its chunks are uploaded from its store.
    [[nodiscard]] base::Error start(gl::Gl& gl, TerrainPlanner& planner, draw::DrawnDesigns designs,
                                    effects::DeviceSettings& device, base::Arena& staging, const draw::TracePlace& traced = {});
    /// Whether what start() built shows a design, too.
    [[nodiscard]] bool shows(const draw::DrawnDesign& design) const;
    /// From here on this design, which shows() has said it can.
    void set_design(gl::Gl& gl, const draw::DrawnDesign& design);
    /// Whether the designs, or a coast in the database, ask for attribute pages; after start().
    [[nodiscard]] bool reads_pages() const { return drawer_.reads_pages(); }
    /// What becomes of tracing on this device; after start().
    [[nodiscard]] draw::TraceState tracer() const { return traced_.state(); }

    /// The slice of the scene that colours the ground; null for none. False where the device has no room for it.
    [[nodiscard]] bool set_ground_data(gl::Gl& gl, const scene::GridSlice* slice) { return drawer_.set_ground_data(gl, slice); }
    /// Posts across and down that such a slice may have; 0 where no design asks for any.
    [[nodiscard]] std::uint32_t ground_side() const { return drawer_.ground_side(); }
    /// Uploads what is new. False when nothing of the terrain may be drawn.
    [[nodiscard]] bool prepare(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input);
    /// Not where it is traced.
    void draw(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
              draw::TerrainDrawResult& result);
    /// Where it is traced: its codes, into a picture.
    void draw_traced(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const gl::Texture& picture);
    /// The depths of what was drawn; colours are nothing.
    void draw_depths(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
                     draw::TerrainDrawResult& result);
    void destroy(gl::Gl& gl);

private:
    draw::TerrainDrawer drawer_;
    draw::TracedTerrain traced_;
    design::DesignSettings design_;  ///< that is drawn
    bool is_started_ = false;
};

}  // namespace tedavis::display
