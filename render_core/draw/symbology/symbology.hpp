/// The flight symbology of a frame, as triangles in a batch.
///
/// Every builder draws within its boxes of the layout and follows the decisions: the value, the value with an amber flag, or a
/// red cross with text in the same place. Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/layout.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

/// Upper bounds over all inputs, tested; what a batch needs so that nothing is refused.
inline constexpr std::size_t kSymbologyVertices = 14592;
inline constexpr std::size_t kSymbologyIndices = kSymbologyVertices * 3 / 2;

/// Everything that the design shows, in the order in which it covers. Clears the batch first.
void build_symbology(QuadBatch& batch, const SymbologyInput& input, const Layout& layout);

void build_attitude(const Painter& painter, const SymbologyInput& input);
void build_flight_path(const Painter& painter, const SymbologyInput& input);
void build_airspeed(const Painter& painter, const SymbologyInput& input);
void build_altitude(const Painter& painter, const SymbologyInput& input);
void build_vertical_speed(const Painter& painter, const SymbologyInput& input);
/// The compass rose with course, lateral deviation, bearing, track and selected heading; in a recovery picture the rose alone.
void build_heading(const Painter& painter, const SymbologyInput& input);
void build_baro_setting(const Painter& painter, const SymbologyInput& input);
void build_ground_height(const Painter& painter, const SymbologyInput& input);
/// Wind and temperature that the own aircraft measures: the arrow points where
/// the wind blows, up is ahead, or the map's up. What is stale is amber and shows its age.
void build_air(const Painter& painter, const SymbologyInput& input);
/// The angle that the picture shows across its width, in the lower right corner of the attitude's box; nothing without an
/// attitude, and in a recovery picture.
void build_field_of_view(const Painter& painter, const SymbologyInput& input);
[[nodiscard]] Rect field_of_view_box(const Layout& layout) noexcept;
/// For make_layout(): what the legends of this frame would take.
[[nodiscard]] LegendNeed legend_need(const SymbologyInput& input) noexcept;
/// Titles, numbers and samples of every colour with a meaning that the picture has; nothing in a recovery picture.
void build_legend(const Painter& painter, const SymbologyInput& input);
/// The notices that are no warnings and no cautions, on the last line.
void build_information(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
