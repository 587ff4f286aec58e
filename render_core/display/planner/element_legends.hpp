/// Adds the legend entries of the data elements that a frame shows: each colour scale in use once, the scale of uncertainty
/// glyphs, and the symbols.
///
/// Memory  the caller's list; entries that do not fit are left out. Thread  any; the function is pure. Failure  none.
#pragma once

#include "render_core/display/planner/data_legends.hpp"
#include "render_core/display/planner/element_planner.hpp"

namespace tedavis::display {

/// `layers` are those of the scene: an attribute derived from another layer is listed with the time and the source of that layer.
void add_element_legends(const ElementReports& reports, base::Span<const scene::Layer> layers,
                         const design::DesignSettings& design, const flight::FlightTime& time,
                         draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
