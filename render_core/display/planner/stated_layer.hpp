/// Layers that the display makes itself, of what the aircraft states: their names, and what all of them say. Pure.
#pragma once

#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::display {

/// Valid at any time, of heights over the ellipsoid, from on board.
void name_layer(scene::LayerEntry& entry, std::string_view name, std::string_view title);
/// Quantitative, by point, without an uncertainty of its own.
void name_attribute(scene::AttributeEntry& entry, std::string_view name, std::string_view unit);
/// Of the values that are there; both 0 where there are none.
void set_range(base::Span<const float> values, scene::AttributeEntry& entry);

}  // namespace tedavis::display
