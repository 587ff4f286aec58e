/// The interface of the core: it turns the aircraft state into pixels and a FrameRecord.
///
///   start(settings, memory, surface, terrain) · each frame: plan(input) · draw(surface) · stop()
///
/// Further state is available from its owners: memory() returns the state that one frame passes to the next, planned() the frame
/// that is drawn, and planner() the terrain, the data and the free camera.
///
/// Memory    all of it is taken at start(), from the arena and the GPU lines of the device's budget table.
/// Thread    one, on which the surface is current. Time comes from the source with plan(); no clock is read.
/// Failure   start() returns one error message. Later faults of data remove what is not trustworthy, flag it and keep running.
#pragma once

#include "render_core/display/frame_painter.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/record_of.hpp"

namespace tedavis::display {

class Display {
public:
    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// `memory` holds DisplayMemory::bytes_needed(). The surface must be current. An empty message means success. `scene`: a
    /// scene database, or null; start() reads all of it.
    [[nodiscard]] base::Error start(const DisplaySettings& settings, base::Arena memory, base::Surface& surface,
                                    const TerrainInput& terrain, base::ByteSource* scene = nullptr);
    void stop();

    /// Plans the frame, without GL. The input's trail must stay valid until the frame is drawn.
    void plan(const flight::FrameInput& input);
    /// Draws the planned frame. The pictures of it that are measured before it is shown (PlannedClutter::probe) are drawn first.
    void draw(base::Surface& surface);
    /// Draws the last frame again with its layers up to `last`, for programs that measure pictures; up to the symbology the
    /// picture is the same. It does not count as a frame, and changes neither the record nor the next frame. A frame that later
    /// frames show (PlannerMemory::must_be_drawn()) must be drawn up to the symbology before the next one is planned.
    void draw_up_to(base::Surface& surface, PictureLayer last);

    /// Replaces the design and the designs of the phases; no GL object is created. It takes effect with the next plan(), at which
    /// a transition to another view mode begins. Returns false and changes nothing if a design needs techniques that the display
    /// was not started with.
    [[nodiscard]] bool set_design(const design::DesignSettings& design, const design::PhaseDesigns* phases = nullptr);
    /// Takes over a scene that was loaded into `planner().data().spare()`, with the next plan(). Returns false and changes
    /// nothing where it is no newer revision, or where the display was started without a scene and expected none.
    [[nodiscard]] bool take_scene(const scene::Scene& scene);

    /// Returns the record of the last drawn frame; after plan() it holds only what the plan states.
    [[nodiscard]] const FrameRecord& record() const { return record_; }
    [[nodiscard]] const PlannedFrame& planned() const { return *frame_; }
    /// To plan a frame again, copy this memory before plan(), and restore the copy afterwards.
    [[nodiscard]] PlannerMemory& memory() { return *memory_; }
    [[nodiscard]] FramePlanner& planner() { return planner_; }
    [[nodiscard]] gl::Gl& gl() { return painter_.gl(); }

private:
    [[nodiscard]] base::Error start_all(const TerrainInput& terrain, base::ByteSource* scene);
    [[nodiscard]] bool can_show(const design::DesignSettings& possible) const;
    void keep_scene();
    [[nodiscard]] draw::TerrainDrawResult paint_measured(base::Surface& surface);
    [[nodiscard]] draw::TerrainDrawResult paint_next(base::Surface& surface);
    [[nodiscard]] draw::TerrainDrawResult paint(base::Surface& surface, PictureLayer last);
    [[nodiscard]] draw::TerrainDrawResult draw_scene(base::Surface& surface, PictureLayer last);
    [[nodiscard]] draw::TerrainDrawResult draw_side(const StereoCameras& pair, draw::EyeSide side, PictureLayer last);
    [[nodiscard]] draw::TerrainDrawResult draw_sides(base::Surface& surface, PictureLayer last);

    DisplayMemory arenas_;
    FramePlanner planner_;
    FramePainter painter_;
    PlannedFrame* frame_ = nullptr;
    PlannerMemory* memory_ = nullptr;
    FrameRecord record_;
};

}  // namespace tedavis::display
