/// The colours of terrain codes (terrain_code.frag), one texel per code, so that palette and warning bands are not mixed per
/// pixel.
///
/// Rows 0..253 and columns are a height's steps of 1/254 of the span and of 1/255 of such a step: the palette or the plain colour
/// under the current warning bands. During an alert there are 85 steps in three columns each: as it is, then under the
/// colours of caution and of warning in place of bands; the sea's row has them as well. Row 254 is the sea. Row 255 holds in
/// alpha the haze by distance code, and in its colours the sky: the ground to column 64, from there to 128 the horizon's pixels,
/// to 255 the zenith. Only the rows that a band entered or left since the last update are computed and uploaded again.
///
/// Memory    256 x 256 texels from the line render_targets. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/draw/alert_zone_look.hpp"
#include "render_core/draw/height_span.hpp"
#include "render_core/draw/terrain_bands.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::draw {

class ColorTable {
public:
    static constexpr std::uint32_t kSide = 256, kHeightRows = 254, kSeaRow = 254, kSkyRow = 255;
    static constexpr std::uint32_t kGroundAtHorizon = 64, kSkyAtHorizon = 128;  ///< columns; see sky_color.frag

    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line);
    [[nodiscard]] bool is_started() const { return texture_.valid(); }
    /// Updates the table. `bands` are all bands of the design, or none. `haze_per_m` is 1 / distance at which haze hides
    /// 1 - 1/e, 0 for none. `alert` is that with which the codes were drawn.
    void update(gl::Gl& gl, const design::TerrainSettings& terrain, const HeightSpan& span, const TerrainBands& bands,
                const design::SkySettings& sky, double haze_per_m, const AlertColors& alert = {});
    /// Makes the next update compute all rows; to be called when the design changes.
    void forget() { known_ = false; }
    [[nodiscard]] const gl::Texture& texture() const { return texture_; }
    void destroy(gl::Gl& gl) { texture_.destroy(gl); }

    /// Returns the height of a code; during an alert the middle of its step.
    [[nodiscard]] static double height_m(const HeightSpan& span, std::uint32_t row, std::uint32_t column, bool in_alert = false);

private:
    void upload_row(gl::Gl& gl, std::uint32_t row, const std::uint8_t* texels) const;
    void update_heights(gl::Gl& gl, const design::TerrainSettings& terrain, const HeightSpan& span, const TerrainBands& bands,
                        std::uint32_t row) const;
    void update_sea(gl::Gl& gl, const design::TerrainSettings& terrain, const TerrainBands& bands) const;
    void update_sky(gl::Gl& gl, const design::SkySettings& sky, double haze_per_m) const;

    gl::Texture texture_;
    bool known_ = false;
    HeightSpan span_;
    TerrainBands bands_;
    AlertColors alert_;
    design::SkySettings sky_;
    double haze_per_m_ = 0;
};

}  // namespace tedavis::draw
