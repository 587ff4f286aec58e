/// Entries of the legend for the elements that a frame shows: every colour scale in use once, and that of glyphs of uncertainty.
///
/// Pure; any thread. Memory  the caller's list; what does not fit in it is refused and counted there.
#pragma once

#include "render_core/display/planner/data_legends.hpp"
#include "render_core/display/planner/element_planner.hpp"

namespace tedavis::display {

/// `layers` of the scene: an attribute that was made of another layer's values has that one's time and source.
void add_element_legends(const ElementReports& reports, base::Span<const scene::Layer> layers,
                         const design::DesignSettings& design, const flight::FlightTime& time,
                         draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
