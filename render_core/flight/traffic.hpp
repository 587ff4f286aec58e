/// Other aircraft, as a receiver on board reports them. Plain data.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::flight {

inline constexpr std::size_t kMaxTraffic = 16;
/// So long after its last report nobody knows any more where an aircraft is.
inline constexpr base::Duration kTrafficKept = base::Duration::seconds(60);

/// Reports farther apart belong to no common way: the aircraft may have gone anywhere between.
inline constexpr base::Duration kTrafficGap = base::Duration::seconds(30);
/// Of the way that an aircraft has come, so many places are kept, so far apart.
inline constexpr std::size_t kMaxTrafficPlaces = 7;
inline constexpr base::Duration kTrafficSpacing = base::Duration::seconds(5);

struct TrafficPlace {
    double latitude_rad = 0, longitude_rad = 0;
    base::Time at;                                           ///< when it was there, by the source's time
    float height_m = 0;                                      ///< over the ellipsoid
    float position_deviation_m = 0, height_deviation_m = 0;  ///< standard deviations, north and east each, and up; 0: not stated
};

struct TrafficReport {
    std::uint32_t address = 0;      ///< who it is: 24 bits, never 0
    base::FixedString<8> callsign;  ///< empty: not stated
    TrafficPlace place;
    float ground_speed_mps = 0, true_track_rad = 0, climb_mps = 0;
    base::FixedVector<TrafficPlace, kMaxTrafficPlaces> before;  ///< the way to it, the oldest first
};

struct Traffic {
    bool is_received = false;  ///< false: there is no receiver, and nothing is known of other aircraft
    bool is_cut = false;       ///< there are more, or were a moment ago, than kMaxTraffic
    base::FixedVector<TrafficReport, kMaxTraffic> reports;  ///< the newest of each aircraft, none older than kTrafficKept
};
static_assert(std::is_trivially_copyable_v<Traffic>);

}  // namespace tedavis::flight
