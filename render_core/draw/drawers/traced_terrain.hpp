/// Draws the terrain with the heightfield ray tracer instead of the rasterizer: the same codes into the same picture, or, for
/// styles that codes cannot represent, a geometry picture, which is shaded afterwards; and the same depths for objects drawn over
/// it. The database's surface is drawn without simplification.
///
/// A view is traced again only where it differs from the last one.
///
/// Memory    posts and a picture from the arena, textures from the budget line traced_pictures. Thread  the GL thread, and the
///           workers within a call. Failure  start(): one sentence. Where tracing is not possible there is no error, but state().
#pragma once

#include <string_view>

#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawers/screen_triangle.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/draw/drawers/traced_codes.hpp"
#include "render_core/draw/drawers/traced_words.hpp"
#include "render_core/draw/trace_state.hpp"
#include "render_core/draw/traced_view.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {

/// Resources of tracing, besides those of the terrain.
struct TracePlace {
    base::Workers* workers = nullptr;  ///< null: the caller's thread
    base::Arena* memory = nullptr;     ///< null: nothing is traced
    std::uint32_t width_px = 0, height_px = 0;
    bool writes_words = false;  ///< a design has deferred shading; else only codes are written
};

class TracedTerrain {
public:
    /// Reads all posts of the database through `heights`; state() then tells whether it can be traced.
    [[nodiscard]] base::Error start(gl::Gl& gl, const terrain::TerrainDatabase& database, terrain::HeightQuery& heights,
                                    effects::DeviceSettings& device, const TracePlace& place);
    /// not_asked_for before start().
    [[nodiscard]] TraceState state() const { return state_; }

    /// Uploads codes to `picture`, which has the size at start. Rays end at the view's far plane; a nearer far plane saves time.
    /// Views that cannot be traced (can_trace()) show no terrain.
    void draw(gl::Gl& gl, const design::DesignSettings& design, const TerrainDrawInput& input, const gl::Texture& picture);
    /// Uploads a geometry picture instead and returns its words; only with TracePlace::writes_words. Writes the chunk numbers
    /// into the depth of the bound framebuffer (GeometryPicture::leave_numbers()).
    const gl::Texture& draw_words(gl::Gl& gl, base::Span<const terrain::SelectedChunk> chunks, const TerrainDrawInput& input);
    /// Writes the ground's depths in the range into the bound framebuffer, as GeometryPicture::leave_depths() does. The caller
    /// switches the depth test on and masks the colours, which are meaningless.
    void draw_depths(gl::Gl& gl, const TerrainDrawInput& input, const DepthRange& range);
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] TraceState start_memory(terrain::HeightQuery& heights, const effects::DeviceSettings& device,
                                          const TracePlace& place);
    [[nodiscard]] base::Error start_pictures(gl::Gl& gl, base::BudgetTable& budget);
    [[nodiscard]] base::Workers& workers() { return place_.workers != nullptr ? *place_.workers : own_worker_; }
    [[nodiscard]] raytrace::GroundSpace space() const { return {*database_, TracedGround::all_of(database_->lattice()), 1.0}; }
    void see(const terrain::View& view);

    TraceState state_ = TraceState::not_asked_for;
    TracePlace place_;
    base::SerialWorkers own_worker_;
    const terrain::TerrainDatabase* database_ = nullptr;
    TracedGround ground_;
    TracedView view_;
    base::Span<std::uint8_t> codes_;
    terrain::View seen_;       ///< the view whose hits view_ holds
    bool has_seen_ = false;    ///< seen_ is valid
    bool has_depths_ = false;  ///< depths_ holds the depths of seen_
    bool has_words_ = false;   ///< the last picture was drawn as words
    ScreenTriangle screen_;
    gl::Program program_;
    gl::Texture depths_;
    TracedWords words_;
    GeometryPicture geometry_;
};

}  // namespace tedavis::draw
