/// Units of attributes that the display reads by their names, such as positions and motion. The display interprets their values
/// in these units, whatever a scene file states.
#pragma once

#include <optional>
#include <string_view>

#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {

/// Returns "m", "m/s" or "rad"; empty if the scene file states the unit of attributes of this name and role.
[[nodiscard]] std::string_view fixed_unit(scene::LayerRole role, std::string_view attribute);

/// Returns the factor that converts `from` to `to`, for common units of tables (ft, km, NM, kt, km/h, ft/min, deg ...); nothing
/// for others.
[[nodiscard]] std::optional<double> factor_between(std::string_view from, std::string_view to);

}  // namespace tedavis::host_sim
