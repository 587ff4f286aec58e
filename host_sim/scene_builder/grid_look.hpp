/// Examines the content of a raster file, with the names that a scene file uses.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/scene_builder/grid_source.hpp"

namespace tedavis::host_sim {

struct ValueRange {
    double least = 0, greatest = 0;
};

/// One variable. Values are in the unit that the file states.
struct VariableLook {
    std::string name;  ///< for `variable` of an attribute
    std::string description, unit, level_unit, level_kind;
    GridPlaces places;
    std::vector<double> levels;                       ///< ascending, as `levels` takes them; empty: the file states none
    std::vector<std::int64_t> times_ns;               ///< ascending; empty: the file states none
    std::size_t least_members = 1, most_members = 1;  ///< grids of the same time and level
    bool is_whole = true;                             ///< every level has every time
    double fullest_level = 0;                         ///< the level with the most times, where not all have them
    std::optional<ValueRange> range;                  ///< over the first grid, without special numbers; empty: it has no value
    double missing_share = 0;                         ///< of the posts of the first grid, 0..1
    double first_spread = 0;                          ///< largest standard deviation of the members of that grid's time and level
    std::vector<double> special;                      ///< numbers that mean "no value", or are likely to
    std::optional<double> undetected;                 ///< the number that means "nothing detected", as the file states it
    std::optional<std::int64_t> computed_ns;          ///< of the last forecast, if the file states it
};

struct GridLook {
    std::string format, system;
    bool is_assumed = false;  ///< the file states no reference system
    bool is_warped = false;   ///< its values are interpolated in longitude and latitude
    std::vector<VariableLook> variables;
    std::size_t more_variables = 0;  ///< number of further variables of the file
};

/// Variables beyond this number are only counted.
inline constexpr std::size_t kMaxVariablesLooked = 64;

/// Throws UserError where the file is no raster or has no place on the Earth.
[[nodiscard]] GridLook look_at_grid(const std::string& file, const std::string& crs);

}  // namespace tedavis::host_sim
