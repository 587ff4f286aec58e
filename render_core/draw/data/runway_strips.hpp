/// Builds runways: surface, outline, markings, PAPI and extended centre line, all on the drawn ground (runway_surface.hpp), from
/// back to front. They are drawn after all other solids and write no depths, so that they do not flicker, and translucent solids
/// and colours of the ground do not cover them; nearer terrain and nearer opaque solids hide them.
///
/// Outline      light, round the runway's edges: kMinOutline_px wide, or kOutline_m where that is wider, with a soft rim.
/// Markings     runway_marks.hpp; each fades with its size on the screen and is left out below kMinMark_px.
/// PAPI         papi.hpp, beside the aiming point; only where the own ship's position is valid. Lights are at least
///              kMinLight_px wide. The path is the attribute "glide_path" (rad), else 3 degrees.
/// Centre line  extended_centerline.hpp; dim, kExtended_px wide.
///
/// The width is the attribute "width"; else the element's size_m; else kRunwayWidth_m. Sizes on the screen are computed from the
/// distance of the eye, so runways are built every frame. A runway for which the batch has no room is drawn without markings,
/// else hidden, and so are those beyond kFarthestRunway_m.
///
/// Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/extended_centerline.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kRunwayWidth_m = 30;
inline constexpr double kMinOutline_px = 1.75, kOutline_m = 0.9, kExtended_px = 1.5;
inline constexpr double kMinMark_px = 0.4, kWholeMark_px = 1;  ///< marks fade in from the first width to the second
inline constexpr double kMinLight_px = 4.5;                    ///< width of a light; a red one is half as high as wide
inline constexpr float kRunwayRaised_px = 1.5f;                ///< along the vertical
inline constexpr float kRunwayNearer_m = 20;                   ///< SolidLook::nearer_m; covers ground between two sections
inline constexpr double kFarthestRunway_m = 100'000;

[[nodiscard]] ElementCount add_runways(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const ApproachFrame& frame);

}  // namespace tedavis::draw
