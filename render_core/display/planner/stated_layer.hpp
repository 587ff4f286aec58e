/// Layers that the display makes from the signals of the aircraft: their names, and the properties that all of them have. Pure.
#pragma once

#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::display {

/// Fills in a layer that is valid at any time, has heights above the ellipsoid, and comes from on board.
void name_layer(scene::LayerEntry& entry, std::string_view name, std::string_view title);
/// Fills in a quantitative attribute with a value for each point, and without an uncertainty of its own.
void name_attribute(scene::AttributeEntry& entry, std::string_view name, std::string_view unit);
/// Sets the range to that of the values that are present; both ends are 0 where there are none.
void set_range(base::Span<const float> values, scene::AttributeEntry& entry);

}  // namespace tedavis::display
