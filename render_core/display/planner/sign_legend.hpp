/// The legend's last entry: what signs mean that belong to no scale. Areas and how far their edges may be off, tubes and where
/// the aircraft may be, broken rims, states of other aircraft, barbs, icons of obstacles, and what sizes and heights stand for.
///
/// Pure; any thread. Memory  the caller's list; rows beyond kMaxLegendSamples are refused and counted there.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::display {

/// After all entries with scales; none where nothing that is shown asks for it.
void add_sign_legend(const ElementReports& reports, const design::DesignSettings& design, draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
