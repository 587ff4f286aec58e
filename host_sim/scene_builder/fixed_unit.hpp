/// Attributes that the display reads by their names, as places and motion: in which unit. Their values are drawn as such whatever
/// a scene file calls them.
#pragma once

#include <optional>
#include <string_view>

#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {

/// "m", "m/s" or "rad"; empty where attributes of this name and role mean what the scene file says.
[[nodiscard]] std::string_view fixed_unit(scene::LayerRole role, std::string_view attribute);

/// How many of `to` one `from` is, of the units that tables are often in (ft, km, NM, kt, km/h, ft/min, deg ...).
[[nodiscard]] std::optional<double> factor_between(std::string_view from, std::string_view to);

}  // namespace tedavis::host_sim
