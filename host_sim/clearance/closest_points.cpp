#include "host_sim/clearance/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSlowestFlight_mps = 15, kStandingHeight_m = 30;
constexpr int kFineSteps = 32;  ///< between a sample and the next, round a closest one

double seconds_between(const TrackSample& a, const TrackSample& b) { return std::fabs((b.time - a.time).to_seconds()); }

bool is_far_from(const std::vector<TrackSample>& track, const std::vector<std::size_t>& chosen, std::size_t n) {
    return std::all_of(chosen.begin(), chosen.end(),
                       [&](std::size_t other) { return seconds_between(track[n], track[other]) >= kApart_s; });
}

/// The flight's first and last samples have one neighbour.
bool is_least(const std::vector<TrackSample>& track, const std::vector<double>& values, std::size_t n) {
    const auto is_beyond = [&](std::size_t other) {
        return seconds_between(track[n], track[other]) <= kLongestGap_s && values[other] >= values[n];
    };
    return (n == 0 || is_beyond(n - 1)) && (n + 1 == track.size() || is_beyond(n + 1));
}

/// The least value on the way to the neighbours of a sample.
template <class Value>
TrackSample least_round(const std::vector<TrackSample>& track, std::size_t n, const Value& value) {
    TrackSample least = track[n];
    double least_value = value(least);
    for (const std::size_t from : {n - 1, n}) {
        if (from + 1 == 0 || from + 1 >= track.size() || seconds_between(track[from], track[from + 1]) > kLongestGap_s) continue;
        for (int step = 1; step < kFineSteps; ++step) {
            const TrackSample sample = between(track[from], track[from + 1], step / double{kFineSteps});
            const double here = value(sample);
            if (!(here < least_value)) continue;
            least = sample;
            least_value = here;
        }
    }
    return least;
}

}  // namespace

bool stands_on_ground(flight::FlightPhase phase, double ground_speed_mps, double height_above_terrain_m) {
    if (phase.scenario != flight::Scenario::unknown) return phase.scenario == flight::Scenario::ground;
    return ground_speed_mps < kSlowestFlight_mps && height_above_terrain_m < kStandingHeight_m;
}

std::vector<bool> counted_samples(const std::vector<TrackSample>& track) {
    std::vector<bool> counts(track.size());
    for (std::size_t n = 0; n < track.size(); ++n) counts[n] = !std::isnan(track[n].height_above_terrain_m);
    const auto leave_out = [&](std::size_t from, int way) {
        for (std::size_t n = from; n < track.size() && seconds_between(track[from], track[n]) < kApart_s;
             n += static_cast<std::size_t>(way))
            counts[n] = false;  // below the first sample the index wraps beyond the last
    };
    for (std::size_t n = 0; n < track.size(); ++n) {
        if (!track[n].is_on_ground) continue;
        counts[n] = false;
        if (n == 0 || !track[n - 1].is_on_ground) leave_out(n, -1);
        if (n + 1 == track.size() || !track[n + 1].is_on_ground) leave_out(n, 1);
    }
    return counts;
}

std::vector<std::size_t> closest_samples(const std::vector<TrackSample>& track, const std::function<double(std::size_t)>& value) {
    const std::vector<bool> counts = counted_samples(track);
    std::vector<double> values(track.size(), std::nan(""));
    for (std::size_t n = 0; n < track.size(); ++n)
        if (counts[n]) values[n] = value(n);
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < track.size(); ++n)
        if (!std::isnan(values[n]) && is_least(track, values, n)) order.push_back(n);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<std::size_t> chosen;
    for (const std::size_t n : order)
        if (chosen.size() < kMaxClosest && is_far_from(track, chosen, n)) chosen.push_back(n);
    return chosen;
}

TrackSample between(const TrackSample& a, const TrackSample& b, double share) {
    TrackSample sample = share < 0.5 ? a : b;
    sample.time = a.time + base::Duration::from_seconds(share * (b.time - a.time).to_seconds());
    const earth::Geodetic &from = a.own.place, &to = b.own.place;
    earth::Geodetic& place = sample.own.place;
    place.latitude_rad = from.latitude_rad + share * (to.latitude_rad - from.latitude_rad);
    place.longitude_rad =
        earth::wrap_longitude(from.longitude_rad + share * earth::angle_difference(to.longitude_rad, from.longitude_rad));
    place.height.m = from.height.m + share * (to.height.m - from.height.m);
    sample.own.height_msl_m = a.own.height_msl_m + share * (b.own.height_msl_m - a.own.height_msl_m);
    sample.along_m = a.along_m + share * (b.along_m - a.along_m);
    return sample;
}

ClosestPoints closest_points(const std::vector<TrackSample>& track, ClearanceMeter& meter) {
    const auto above_m = [&](const TrackSample& sample) { return meter.height_above_terrain_m(sample.own); };
    const auto distance_m = [&](const TrackSample& sample) {
        const std::optional<GroundPlace> ground = meter.nearest(sample.own);
        return ground ? ground->distance_m : std::nan("");
    };
    ClosestPoints points;
    const auto add = [&](std::vector<ClosestPoint>& to, TrackSample sample) {
        sample.height_above_terrain_m = above_m(sample);
        if (const std::optional<GroundPlace> ground = meter.nearest(sample.own)) to.push_back({sample, *ground});
    };
    for (const std::size_t n : closest_samples(track, [&](std::size_t at) { return track[at].height_above_terrain_m; }))
        add(points.by_height, least_round(track, n, above_m));
    for (const std::size_t n : closest_samples(track, [&](std::size_t at) { return distance_m(track[at]); }))
        add(points.by_distance, least_round(track, n, distance_m));
    return points;
}

}  // namespace tedavis::host_sim
