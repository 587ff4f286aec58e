/// The legend's last entry: the meaning of signs that belong to no scale. It explains areas and the error of their edges, tubes
/// and the uncertainty of positions, broken rims, states of other aircraft, barbs, icons of obstacles, and the meaning of sizes
/// and heights.
///
/// Pure; any thread. Memory  the caller's list; rows beyond kMaxLegendSamples are refused and counted there.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::display {

/// Adds the entry, after all entries with scales, if something that is shown needs it.
void add_sign_legend(const ElementReports& reports, const design::DesignSettings& design, draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
