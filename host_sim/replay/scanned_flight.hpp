/// The positions of a whole recorded flight, for uses before a display is started.
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"
#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

/// A time with a valid position.
struct ScannedPlace {
    base::Time time;  ///< of the log
    double latitude_rad = 0, longitude_rad = 0;
    double height_m = 0;     ///< above the ellipsoid
    bool joins_next = true;  ///< false: no position was valid between it and the next one
};

struct ScannedFlight {
    std::string log;
    base::Time first, last;  ///< of the log
    base::Duration ahead;    ///< UTC minus the log's time; 0 where UTC is not known
    bool is_dated = false;
    std::vector<ScannedPlace> places;  ///< in the order of time
};

/// Scans a place each second, but at most kMaxScannedPlaces. Reads the log twice, without terrain. Throws UserError where it
/// cannot be read, or its pressure heights need the geoid's grid and that is not installed; Interrupted.
inline constexpr std::size_t kMaxScannedPlaces = 10'000;
[[nodiscard]] ScannedFlight scan_flight(const PlayerFiles& files, Console& console);

}  // namespace tedavis::host_sim
