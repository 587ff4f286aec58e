/// Uploads and draws planned frames. It decides nothing.
///
///   start...(...) · begin(surface) · prepare(frame) · draw_scene(...) · draw_over_scene(...) · finish(...)
///
/// Memory    GPU lines and arenas of the device's budget table, at start. Thread  the GL thread, on which the surface is current.
/// Failure   the start gives one message; prepare() returns false for terrain that cannot be uploaded.
#pragma once

#include "render_core/base/ports/surface.hpp"
#include "render_core/display/draw_inputs.hpp"
#include "render_core/display/element_painter.hpp"
#include "render_core/display/planner/display_memory.hpp"
#include "render_core/display/planner/frame_planner.hpp"
#include "render_core/display/scene_passes.hpp"
#include "render_core/display/work_scope.hpp"
#include "render_core/draw/drawers/dimmer.hpp"
#include "render_core/draw/drawers/picture_edges.hpp"
#include "render_core/draw/drawers/quad_drawer.hpp"
#include "render_core/draw/drawers/saliency_pass.hpp"
#include "render_core/draw/drawers/scene_fade.hpp"
#include "render_core/draw/drawers/stereo_pass.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::display {

/// The work of drawing a frame, and whether all of the plan could be drawn.
struct DrawnFrame {
    draw::TerrainDrawResult terrain;
    EffectWorkTable work;
    std::uint64_t uploaded_bytes = 0;
    bool ground_data_is_missing = false;  ///< the device has no room for it
};

/// What a painter is started with: the designs, of which the first is drawn first, and the size of the picture. References must
/// be valid until start() returns.
struct PainterStart {
    effects::DeviceSettings& device;
    draw::DrawnDesigns designs;
    const DeclutterControl& clutter;  ///< what the designs request
    std::uint32_t width_px = 0, height_px = 0, stereo_margin_px = 0;
};

class FramePainter {
public:
    [[nodiscard]] base::Error open(base::Surface& surface, const effects::DeviceSettings& device, base::ProgramStore* programs);
    /// The planner must outlive the painter: what it builds is drawn from its memory.
    [[nodiscard]] base::Error start(const PainterStart& start, const FramePlanner& planner, DisplayMemory& memory);
    [[nodiscard]] base::Error start_terrain(const PainterStart& start, TerrainPlanner& terrain, DisplayMemory& memory,
                                            base::Workers* workers);
    [[nodiscard]] base::Error start_elements(const FramePlanner& planner, DisplayMemory& memory);
    /// Ends the start: no GL object is created afterwards.
    void seal();
    void stop();
    [[nodiscard]] PainterAbilities abilities() const;
    /// Whether the started drawers can also draw a design; `possible` is the design as the device can show it.
    [[nodiscard]] bool can_show(const design::DesignSettings& possible) const;

    void begin(base::Surface& surface);
    /// Uploads what is new. Returns false where the planned terrain cannot be drawn.
    [[nodiscard]] bool prepare(const PlannedFrame& frame);
    void prepare_elements(const PlannedPicture& picture);
    /// Draws terrain, sky, data and signs as one camera of the frame sees them, up to a layer.
    draw::TerrainDrawResult draw_scene(const PlannedFrame& frame, const PlannedPicture& picture, const gl::DrawPlace& place,
                                       PictureLayer last = PictureLayer::symbology, bool has_shadow_map = false);
    /// Draws the frame into the picture from which later frames fade.
    draw::TerrainDrawResult draw_kept(const PlannedFrame& frame);
    /// Draws the picture of one eye of a pair; put_side() then puts it onto the surface.
    draw::TerrainDrawResult draw_side(const PlannedFrame& frame, const PlannedPicture& picture, PictureLayer last,
                                      draw::EyeSide side);
    void put_side(const base::Surface& surface, design::StereoMode mode, draw::EyeSide side, std::int32_t shift_px);
    /// Draws the kept picture, which fades out.
    void draw_fade(const PlannedFrame& frame);
    /// Draws the symbology, in the plane of the screen.
    void draw_symbology(const PlannedFrame& frame, const base::Surface& surface);
    /// Returns the edge density of the picture on the surface.
    [[nodiscard]] effects::ClutterMap measure_clutter(const base::Surface& surface);
    /// Draws edges and the saliency map over the picture on the surface, where the frame shows them.
    void draw_measures(const PlannedFrame& frame, const base::Surface& surface);
    /// Dims the picture to the brightness of the panel.
    void dim(const PlannedFrame& frame);

    /// bare_ground() removes the layers after `last` from the ground's colours; restore_ground() restores the frame's colours.
    void bare_ground(const PlannedFrame& frame, PictureLayer last);
    void restore_ground(const PlannedFrame& frame);

    [[nodiscard]] EffectWorkTable& work() { return drawn_.work; }
    [[nodiscard]] DrawnFrame drawn(const draw::TerrainDrawResult& terrain);
    [[nodiscard]] gl::Gl& gl() { return gl_; }
    [[nodiscard]] const gl::Gl& gl() const { return gl_; }

private:
    void draw_edges(const PlannedFrame& frame, const base::Surface& surface);
    void draw_saliency(const PlannedFrame& frame, const base::Surface& surface);
    [[nodiscard]] draw::DrawnDesign drawn_design(const design::DesignSettings& design, bool has_focus) const;
    void follow_look(const PlannedFrame& frame);

    gl::Gl gl_;
    effects::DeviceSettings* device_ = nullptr;
    std::uint32_t width_px_ = 0, height_px_ = 0;
    std::uint64_t look_key_ = 0, ground_key_ = 0;  ///< of what was prepared last
    bool has_terrain_ = false;
    TerrainPainter terrain_;
    ElementPainter elements_;
    ScenePasses passes_;
    draw::StereoPass stereo_;
    draw::SceneFade fade_;
    draw::SaliencyPass saliency_;
    draw::PictureEdges edges_;
    draw::Dimmer dimmer_;
    draw::QuadDrawer symbology_;
    DrawnFrame drawn_;
};

}  // namespace tedavis::display
