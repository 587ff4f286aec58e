/// A scene file for grids of weather whose content is plain: what `fly --weather` shows without a scene file.
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

/// What of the grids is of use to a flight.
struct WeatherWindow {
    std::optional<base::Time> begin, end;  ///< of the flight; steps of other times are left out where the file has some of these
    GeoExtent region;                      ///< empty: everywhere
};

struct WeatherScene {
    std::string toml;
    std::vector<std::string> notes;  ///< sentences that the user should read
};

/// Throws UserError, which says what the file holds, for one that holds several variables of which none is known.
[[nodiscard]] WeatherScene weather_scene(const std::vector<std::string>& files, const WeatherWindow& window);

}  // namespace tedavis::host_sim
