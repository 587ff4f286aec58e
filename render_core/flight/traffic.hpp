/// Other aircraft, as a receiver on board reports them. Plain data.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::flight {

inline constexpr std::size_t kMaxTraffic = 16;
/// An aircraft is dropped this long after its last report.
inline constexpr base::Duration kTrafficKept = base::Duration::seconds(60);

/// Reports farther apart than this are not joined to one track.
inline constexpr base::Duration kTrafficGap = base::Duration::seconds(30);
/// Number and spacing of the past positions kept for each aircraft.
inline constexpr std::size_t kMaxTrafficPlaces = 7;
inline constexpr base::Duration kTrafficSpacing = base::Duration::seconds(5);

struct TrafficPlace {
    double latitude_rad = 0, longitude_rad = 0;
    base::Time at;                                           ///< the source's time at this position
    float height_m = 0;                                      ///< above the ellipsoid
    float position_deviation_m = 0, height_deviation_m = 0;  ///< standard deviations: north and east each; up; 0: not stated
};

struct TrafficReport {
    std::uint32_t address = 0;      ///< 24-bit aircraft address, never 0
    base::FixedString<8> callsign;  ///< empty: not stated
    TrafficPlace place;
    float ground_speed_mps = 0, true_track_rad = 0, climb_mps = 0;
    base::FixedVector<TrafficPlace, kMaxTrafficPlaces> before;  ///< past positions, the oldest first
};

struct Traffic {
    bool is_received = false;  ///< false: there is no receiver, and nothing is known of other aircraft
    bool is_cut = false;       ///< there are, or were a moment ago, more than kMaxTraffic aircraft
    base::FixedVector<TrafficReport, kMaxTraffic> reports;  ///< the newest of each aircraft, at most kTrafficKept old
};
static_assert(std::is_trivially_copyable_v<Traffic>);

}  // namespace tedavis::flight
