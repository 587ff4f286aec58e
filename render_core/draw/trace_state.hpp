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
    not_by_style,   ///< its picture needs no pass of its own, or shows ground elsewhere than it is (drawn_design.hpp)
    not_flat,       ///< the design shows a plane
    not_on_lane,    ///< a shader of ES 2 can neither leave depths nor read words
    not_on_device,  ///< which has no memory for it
    database_too_large,
    database_round,
    database_damaged,
    place_too_polar,  ///< of the eye, in this frame
};
/// Returns why the rasterizer draws instead; empty where it does not.
[[nodiscard]] std::string_view reason_of(TraceState state);

/// Tests whether the tracer can draw a design, regardless of the position.
[[nodiscard]] TraceState trace_state_of(const DrawnDesign& design);

/// True where rays of a view can be traced over the whole database.
[[nodiscard]] bool can_trace(const terrain::TerrainDatabase& database, const terrain::View& view);

}  // namespace tedavis::draw
