/// Removes fixes and heights from a recorded flight that cannot have been flown, and counts them.
#pragma once

#include <cstddef>

#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

struct CleaningCounts {
    std::size_t out_of_order = 0;       ///< fixes that had to be sorted
    std::size_t duplicates = 0;         ///< fixes with the time of another one
    std::size_t position_jumps = 0;     ///< fixes too far from their neighbours for the time between them
    std::size_t gnss_height_jumps = 0;  ///< heights far off the line of their neighbours; the fix stays
    std::size_t pressure_jumps = 0;
};

/// Sorts by time, drops duplicates and position jumps, empties height outliers. A position is a jump when reaching it needs more
/// than 1.6 times the speed that 98 % of the flight stay below (plus 20 m/s and 60 m); five such in a row that agree with each
/// other are kept. A height is an outlier when it lies off the robust line (Theil-Sen) through itself and the four fixes on
/// either side by more than 40 m plus 8 m/s times the interval.
CleaningCounts clean_fixes(RecordedFlight& flight);

}  // namespace tedavis::host_sim
