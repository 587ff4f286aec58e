/// Draws the terrain with the heightfield ray tracer instead of the rasterizer: the same codes into the same picture, or, for
/// styles that codes cannot tell, a geometry picture that is then shaded; and the same depths for objects drawn over it. The
/// database's surface is drawn without simplification.
///
/// A picture is traced again only where it differs from the last one.
///
/// Memory    posts and a picture from the arena, textures from the budget line traced_pictures. Thread  the GL thread, and the
///           workers within a call. Failure  start(): one sentence; what keeps it from tracing is no failure, but said.
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

/// Resources of tracing, besides those of the terrain; without an arena nothing is traced.
struct TracePlace {
    base::Workers* workers = nullptr;  ///< null: the caller's thread
    base::Arena* memory = nullptr;
    std::uint32_t width_px = 0, height_px = 0;
    bool writes_words = false;  ///< for designs with deferred shading; else codes alone
};

class TracedTerrain {
public:
    /// Starts with the whole database of the query; state() returns whether it can be traced.
    [[nodiscard]] base::Error start(gl::Gl& gl, const terrain::TerrainDatabase& database, terrain::HeightQuery& heights,
                                    effects::DeviceSettings& device, const TracePlace& place);
    /// not_asked_for before start().
    [[nodiscard]] TraceState state() const { return state_; }

    /// Codes, into a whole picture of the size at start. No terrain lies beyond the view's far plane: the nearer it is, the less
    /// there is to trace. Where it cannot see there is nothing.
    void draw(gl::Gl& gl, const design::DesignSettings& design, const TerrainDrawInput& input, const gl::Texture& picture);
    /// The same as a geometry picture, whose words are returned; only where words are written. The depth of what is bound, which
    /// has the size of the picture, then has the numbers of the chunks.
    const gl::Texture& draw_words(gl::Gl& gl, base::Span<const terrain::SelectedChunk> chunks, const TerrainDrawInput& input);
    /// Depths in the range, over the whole of what is bound with its depth test on, as GeometryPicture::leave_depths(); colours
    /// are nothing.
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
    terrain::View seen_;       ///< by view_
    bool has_seen_ = false;    ///< anything
    bool has_depths_ = false;  ///< of seen_, in their texture
    bool has_words_ = false;   ///< the picture was drawn as words
    ScreenTriangle screen_;
    gl::Program program_;
    gl::Texture depths_;
    TracedWords words_;
    GeometryPicture geometry_;
};

}  // namespace tedavis::draw
