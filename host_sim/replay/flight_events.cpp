#include "host_sim/replay/flight_events.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

/// Evenly by their number.
std::vector<base::Time> thinned_events(const std::vector<base::Time>& all, std::uint64_t most) {
    if (all.size() <= most) return all;
    std::vector<base::Time> kept;
    for (std::uint64_t n = 0; n < most; ++n) kept.push_back(all[static_cast<std::size_t>(n * all.size() / most)]);
    return kept;
}

}  // namespace

std::vector<base::Time> alert_instants(FramePreroll& preroll, const TimeRanges& parts, const ReachedTime& reached) {
    std::vector<base::Time> begins;
    policy::TerrainAhead before = policy::TerrainAhead::none;
    preroll.look_ahead(parts.back().to, [&](base::Time begin, policy::TerrainAhead alert) {
        if (alert > before && contains(parts, begin)) begins.push_back(begin);
        before = alert;
        if (reached) reached(begin);
    });
    return begins;
}

std::vector<base::Time> event_instants(FlightPlayer& player, FramePreroll& preroll, const TimeRanges& parts, std::uint64_t most,
                                       const ReachedTime& reached) {
    std::vector<base::Time> events = thinned_events(alert_instants(preroll, parts, reached), most);
    std::vector<base::Time> changes;
    for (const base::Time change : player.outline().phase_changes())
        if (contains(parts, change)) changes.push_back(change);
    changes = thinned_events(changes, most - events.size());
    events.insert(events.end(), changes.begin(), changes.end());
    std::sort(events.begin(), events.end());
    return events;
}

}  // namespace tedavis::host_sim
