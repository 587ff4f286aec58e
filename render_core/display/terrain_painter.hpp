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
    /// Starts the drawers for the designs that the display changes between; the first is drawn first. `traced`: where terrain is
    /// traced, if a design requests it. `planner` must have been started and must outlive the painter, which uploads chunks from
    /// its store.
    [[nodiscard]] base::Error start(gl::Gl& gl, TerrainPlanner& planner, draw::DrawnDesigns designs,
                                    effects::DeviceSettings& device, base::Arena& staging, const draw::TracePlace& traced = {});
    /// Whether the started drawers can also draw a design.
    [[nodiscard]] bool shows(const draw::DrawnDesign& design) const;
    /// Draws in this design from now on; shows() must have returned true for it.
    void set_design(gl::Gl& gl, const draw::DrawnDesign& design);
    /// Whether the designs, or a coast in the database, request attribute pages; valid after start().
    [[nodiscard]] bool reads_pages() const { return drawer_.reads_pages(); }
    /// Whether terrain is traced on this device, or why not; valid after start().
    [[nodiscard]] draw::TraceState tracer() const { return traced_.state(); }

    /// Sets the slice of the scene that colours the ground; null for none. Returns false where the device has no room for it.
    [[nodiscard]] bool set_ground_data(gl::Gl& gl, const scene::GridSlice* slice) { return drawer_.set_ground_data(gl, slice); }
    /// Returns the number of posts across and down that such a slice may have; 0 where no design requests one.
    [[nodiscard]] std::uint32_t ground_side() const { return drawer_.ground_side(); }
    /// Uploads what is new. Returns false where the terrain must not be drawn.
    [[nodiscard]] bool prepare(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input);
    /// Draws a depth range of the terrain as triangles; not to be called where it is traced.
    void draw(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
              draw::TerrainDrawResult& result);
    /// Traces the terrain, and draws its codes into a picture.
    void draw_traced(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const gl::Texture& picture);
    /// Traces the terrain for a design with deferred shading, and shades it into the picture that is bound, which holds the sky
    /// and has a depth.
    void draw_shaded(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input);
    /// Draws the depths of the terrain; the colours have no meaning. Traced ground that is nearer than the range hides all of it.
    void draw_depths(gl::Gl& gl, const SeenTerrain& seen, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
                     draw::TerrainDrawResult& result);
    void destroy(gl::Gl& gl);

private:
    draw::TerrainDrawer drawer_;
    draw::TracedTerrain traced_;
    design::DesignSettings design_;  ///< the design that is drawn
    bool is_deferred_ = false;       ///< whether its shading is deferred
    bool writes_words_ = false;      ///< whether the shading of any design of start() is deferred
    bool is_started_ = false;
};

}  // namespace tedavis::display
