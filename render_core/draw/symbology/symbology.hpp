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

/// Upper bounds over all inputs (tested): a batch with this capacity refuses nothing.
inline constexpr std::size_t kSymbologyVertices = 14592;
inline constexpr std::size_t kSymbologyIndices = kSymbologyVertices * 3 / 2;

/// Clears the batch and adds everything that the design shows, from back to front.
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
/// Wind and temperature as measured by the own aircraft. The arrow points where the wind blows to; up is the view's
/// heading, or the map's up. Stale values are amber and show their age.
void build_air(const Painter& painter, const SymbologyInput& input);
/// The angle that the picture shows across its width, in the lower right corner of the attitude's box; nothing without an
/// attitude, and in a recovery picture.
void build_field_of_view(const Painter& painter, const SymbologyInput& input);
[[nodiscard]] Rect field_of_view_box(const Layout& layout) noexcept;
/// Returns the room that the legends of this frame need, for make_layout().
[[nodiscard]] LegendNeed legend_need(const SymbologyInput& input) noexcept;
/// Titles, numbers and samples for every colour of the picture that has a meaning; nothing in a recovery picture.
void build_legend(const Painter& painter, const SymbologyInput& input);
/// The notices that are no warnings and no cautions, on the last line.
void build_information(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
