/// Draws a frame's scene to the surface in this order: terrain, sky and spatial data (directly, or through pictures off screen),
/// effects on the finished picture, signs. The symbology is drawn afterwards.
///
/// Terrain, data and symbology are layers that are drawn one after the other; an effect applies to the layers that provide its
/// input, such as their distances. A picture off screen that no effect of the frame reads is not drawn.
///
/// Memory    the budget line render_targets (GPU), at start(). Thread  the GL thread, with a surface that is current.
/// Failure   start() gives one message.
#pragma once

#include "render_core/display/draw_inputs.hpp"
#include "render_core/display/element_painter.hpp"
#include "render_core/display/shadow_casters.hpp"
#include "render_core/display/terrain_painter.hpp"
#include "render_core/display/work_scope.hpp"
#include "render_core/draw/drawers/light_shafts.hpp"
#include "render_core/draw/drawers/picture_pass.hpp"
#include "render_core/draw/drawers/sky_drawer.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::display {

/// A planned frame and what is drawn of it, as references to the display's objects.
struct PassInput {
    const DrawContext& frame;
    const effects::FramePlan& plan;
    TerrainPainter& terrain;
    const SeenTerrain& seen;  ///< from the frame's eye
    ElementPainter& elements;
    const PlannedElements& data;
    const CasterSet& casters;
    EffectWorkTable& work;
    bool has_void = false;        ///< ground without data is in view
    bool has_shadow_map = false;  ///< the frame's other picture has drawn the shadow map
    bool has_terrain = false;     ///< the picture drawn before has the same terrain
};

class ScenePasses {
public:
    /// Starts the drawers for the designs that the display changes between; the first is drawn first. Either all of them have air
    /// or none.
    [[nodiscard]] base::Error start(gl::Gl& gl, effects::DeviceSettings& device, draw::DrawnDesigns designs,
                                    std::uint32_t width_px, std::uint32_t height_px);
    /// Whether the started drawers can also draw a design.
    [[nodiscard]] bool shows(const draw::DrawnDesign& design) const;
    /// Draws in this design from now on; shows() must have returned true for it.
    void set_design(const draw::DrawnDesign& design);
    /// Draws the scene. Leaves the place bound and the depth test disabled. Returns what the terrain drew.
    draw::TerrainDrawResult draw(gl::Gl& gl, const gl::DrawPlace& place, const PassInput& input);
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] draw::ShadowRead draw_shadows(gl::Gl& gl, const PassInput& input);
    [[nodiscard]] draw::AirFrame update_air(gl::Gl& gl, const PassInput& input);
    void draw_off_screen(gl::Gl& gl, const PassInput& input);
    void draw_scene(gl::Gl& gl, const gl::DrawPlace& place, const PassInput& input, draw::TerrainDrawResult& drawn);
    void finish_effects(gl::Gl& gl, const gl::DrawPlace& place, const draw::ViewEffectsInput& asked, bool is_of_context,
                        EffectWorkTable& work);
    void draw_ranges(gl::Gl& gl, const PassInput& input, draw::TerrainDrawResult& drawn);
    void draw_elements_over_picture(gl::Gl& gl, const PassInput& input);
    void draw_shafts(gl::Gl& gl, const PassInput& input, const draw::ShadowRead& shadow);
    [[nodiscard]] base::Error start_view_effects(gl::Gl& gl, effects::DeviceSettings& device, draw::DrawnDesigns designs);
    [[nodiscard]] static draw::PictureInput picture_input(const PassInput& input);

    draw::PicturePass picture_;
    bool goes_off_screen_ = false;        ///< the design's terrain, for picture_
    bool is_deferred_ = false;            ///< the shading of its traced terrain
    draw::TerrainDrawResult off_screen_;  ///< of the terrain in picture_
    draw::SkyDrawer sky_;
    draw::AirTable air_;
    ShadowCasters shadows_;
    draw::ViewEffectsPass view_effects_;
    draw::LightShafts shafts_;
    bool smooths_ = false, blurs_ = false;  ///< there are programs that do
    bool has_air_ = false;
    std::uint32_t width_px_ = 0, height_px_ = 0;
};

}  // namespace tedavis::display
