/// The unit in which a scene should keep the values of a source: SI and radians, as the display computes with them.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// value = factor * stated + offset. `unit` is empty where the source states none; an unknown unit is kept as it is, unless it is
/// too long for a database, which makes it empty.
struct KeptUnit {
    std::string unit;
    double factor = 1, offset = 0;
};

[[nodiscard]] KeptUnit kept_unit(const std::string& stated);

/// A column's name without the unit at its end, and that unit: "height_ft" is "height" in "ft". Without such an end the unit is
/// empty.
struct UnitSuffix {
    std::string name, unit;
};
[[nodiscard]] UnitSuffix unit_suffix(const std::string& column);

}  // namespace tedavis::host_sim
