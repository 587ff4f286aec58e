/// The face of the core: aircraft state in, pixels and a FrameRecord out.
///
///   start(settings, memory, surface, terrain) · each frame: plan(input) · draw(surface) · stop()
///
/// What may be asked besides lies where it is decided: memory() is what one frame leaves to the next, planned() the frame that is
/// drawn, planner() the terrain, the data and the free camera.
///
/// Memory    everything from the arena and the GPU lines of the device's budget table, at start(); nothing later.
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

    /// `memory` holds DisplayMemory::bytes_needed(). The surface must be current. An empty message means success.
    /// `scene`: a scene database, or null; it is read whole, now.
    [[nodiscard]] base::Error start(const DisplaySettings& settings, base::Arena memory, base::Surface& surface,
                                    const TerrainInput& terrain, base::ByteSource* scene = nullptr);
    void stop();

    /// Plans the frame, without GL. The input's trail must stay until the frame is drawn.
    void plan(const flight::FrameInput& input);
    /// Draws the planned frame, after the pictures of it that are measured before it can be shown.
    void draw(base::Surface& surface);
    /// Draws the frame that was drawn last again, without the layers that lie before `last`: for those who measure pictures.
    /// Counts as no frame, and changes neither its record nor the next one; up to the symbology it is the same picture. A frame
    /// that later ones show (PlannerMemory::must_be_drawn()) must be drawn up to there before the next one is planned.
    void draw_up_to(base::Surface& surface, PictureLayer last);

    /// Colors, thresholds and views of other designs, and which phases have them; no new objects. Takes effect with the next
    /// plan(), from which the camera travels to another mode of view. False, and nothing changes, when one needs techniques that
    /// the display was not started with.
    [[nodiscard]] bool set_design(const design::DesignSettings& design, const design::PhaseDesigns* phases = nullptr);
    /// Takes over a scene that lies whole in `planner().data().spare()`, with the next plan(). False, and nothing changes, where
    /// it is no newer revision, or the display was started without a scene and expected none.
    [[nodiscard]] bool take_scene(const scene::Scene& scene);

    /// Of the frame that was drawn last; after plan() only what the plan states.
    [[nodiscard]] const FrameRecord& record() const { return record_; }
    [[nodiscard]] const PlannedFrame& planned() const { return *frame_; }
    /// A copy of it, taken before a plan() and put back, makes the next frame follow from the same.
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
