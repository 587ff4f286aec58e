/// Whether terrain can be ray-traced for a design that requests it, and why not. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/draw/drawn_design.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// The state of ray tracing for a design that requests it.
enum class TraceState : std::uint8_t {
    not_asked_for,
    traced,
    not_by_style,   ///< terrain is not drawn off-screen for the picture pass, or foci displace it (drawn_design.hpp)
    not_flat,       ///< the design shows a plane
    not_on_lane,    ///< shaders of ES 2 can neither write depths nor read words
    not_on_device,  ///< too little memory, too few texture units, or too many chunk slots (ability_of())
    database_too_large,
    database_round,
    database_damaged,
    place_too_polar,  ///< the eye point of this frame is too close to a pole
    not_by_cost,      ///< the design leaves the choice to the display, which draws triangles in this frame
};
/// Returns why the rasterizer draws instead; empty where it does not.
[[nodiscard]] std::string_view reason_of(TraceState state);

/// Tests whether the tracer can draw a design, regardless of the position.
[[nodiscard]] TraceState trace_state_of(const DrawnDesign& design);

/// True where rays of a view can be traced over the whole database.
[[nodiscard]] bool can_trace(const terrain::TerrainDatabase& database, const terrain::View& view);

}  // namespace tedavis::draw
