/// Makes a scene file from grids of weather whose content can be recognized, for `fly --weather` without a scene file.
///
///   wind      eastward and northward wind: the layer `wind`, with its speed
///   radar     reflectivity: the layer `radar`
///   others    the only variable of a file: a field of its own name
///
/// The names and units are those that the shipped designs show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/reports/geo_extent.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// The part of the grids that a flight needs.
struct WeatherWindow {
    std::optional<base::Time> begin, end;  ///< of the flight; time steps outside are left out if the file has some inside
    GeoExtent region;                      ///< empty: everywhere
};

struct WeatherScene {
    std::string toml;
    std::vector<std::string> notes;  ///< sentences that the user should read
};

/// Throws UserError with the content of the file where a file has several variables and none is known.
[[nodiscard]] WeatherScene weather_scene(const std::vector<std::string>& files, const WeatherWindow& window);

}  // namespace tedavis::host_sim
