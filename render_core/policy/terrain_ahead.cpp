#include "render_core/policy/terrain_ahead.hpp"

#include <algorithm>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::policy {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMetresPerNauticalMile = 1852;
constexpr double kDescent_mps = -2.5;  // 500 ft/min
constexpr double kHalfWidth_m = 200;
constexpr double kStep_m = 60;
constexpr double kCloser = 0.75;         // of the height above ground now
constexpr double kRunwayGround_m = 30;   // ground round a runway is so much higher at most
constexpr double kRunwayRound_nm = 1.0;  // and so near
constexpr double kFlare_m = 15;          // 50 ft over the ground of a runway a landing begins
struct NearGround {
    double height_ft, distance_nm;
};
constexpr NearGround kInhibits[] = {{200, 0.5}, {125, 1.0}};

struct PlaceOnLine {
    double distance_m;
    earth::Geodetic at;
};

/// The place on a line from `a` to `b` that is nearest to another one.
PlaceOnLine nearest_on(const scene::ScenePoint& a, const scene::ScenePoint& b, const earth::Geodetic& place,
                       const PredictedTrack& track) {
    const double per_latitude = track.metres_per_latitude_rad(), per_longitude = track.metres_per_longitude_rad();
    const double to_north_rad = b.latitude_rad - a.latitude_rad;
    const double to_east_rad = earth::angle_difference(b.longitude_rad, a.longitude_rad);
    const double north_m = (a.latitude_rad - place.latitude_rad) * per_latitude;
    const double east_m = earth::angle_difference(a.longitude_rad, place.longitude_rad) * per_longitude;
    const double to_north_m = to_north_rad * per_latitude, to_east_m = to_east_rad * per_longitude;
    const double length2 = to_north_m * to_north_m + to_east_m * to_east_m;
    const double along = length2 > 0 ? -(north_m * to_north_m + east_m * to_east_m) / length2 : 0;
    const double share = std::fmin(std::fmax(along, 0), 1);
    return {std::hypot(north_m + share * to_north_m, east_m + share * to_east_m),
            {a.latitude_rad + share * to_north_rad, a.longitude_rad + share * to_east_rad, {}}};
}

}  // namespace

double required_clearance_m(flight::FlightPhase phase, double up_mps) noexcept {
    struct Clearance {
        double level_ft, descending_ft;
    };
    constexpr Clearance kEnRoute{700, 500}, kTerminal{350, 300}, kApproach{150, 100}, kDeparture{100, 100};
    Clearance required = kTerminal;
    switch (phase.scenario) {
        case flight::Scenario::cruise: required = kEnRoute; break;
        case flight::Scenario::ground:
        case flight::Scenario::takeoff: required = kDeparture; break;
        case flight::Scenario::approach:
            if (phase == flight::kApproachFinal || phase == flight::kApproachLanding) required = kApproach;
            break;
        case flight::Scenario::go_around: required = phase == flight::kGoAroundReplanning ? kEnRoute : kDeparture; break;
        case flight::Scenario::unknown: break;
    }
    return (up_mps < kDescent_mps ? required.descending_ft : required.level_ft) * base::kMetresPerFoot;
}

TerrainWatch::TerrainWatch(const PredictedTrack& track, flight::FlightPhase phase, base::Span<const scene::Layer> layers,
                           scene::Ground& ground)
    : track_(track), ground_(ground) {
    find_runways(layers);
    const double below_m = ground_.height_m(track.from.latitude_rad, track.from.longitude_rad);
    height_above_ground_m_ = std::isnan(below_m) ? kInfinite : track.from.height.m - below_m;
    clearance_m_ = std::fmin(required_clearance_m(phase, track.up_mps), kCloser * height_above_ground_m_);
}

TerrainAhead TerrainWatch::ahead() {
    const double seconds = seconds_to_terrain();
    if (seconds <= kWarning_s) return TerrainAhead::warning;
    return seconds <= kLookAhead_s ? TerrainAhead::caution : TerrainAhead::none;
}

double TerrainWatch::seconds_to_terrain() {
    if (track_.ground_speed_mps() < kSlowest_mps || is_inhibited()) return kInfinite;
    const double steps = std::ceil(track_.ground_speed_mps() * kLookAhead_s / kStep_m);
    const int count = static_cast<int>(std::fmin(steps, kMaxSteps));
    for (int n = 0; n <= count; ++n) {
        const double seconds = kLookAhead_s * n / count;
        if (lands(seconds)) return kInfinite;
        if (is_too_close(seconds)) return seconds;
    }
    return kInfinite;
}

/// From there on the track would lead below the ground.
bool TerrainWatch::lands(double seconds) {
    const earth::Geodetic place = track_.at(seconds);
    const double ground_m = ground_.height_m(place.latitude_rad, place.longitude_rad);
    return place.height.m < ground_m + kFlare_m && is_ground_of_runway(place, ground_m);
}

bool TerrainWatch::is_inhibited() {
    double highest_m = 0;
    for (const NearGround& inhibit : kInhibits) highest_m = std::fmax(highest_m, inhibit.height_ft * base::kMetresPerFoot);
    if (!(height_above_ground_m_ < highest_m)) return false;
    const double distance_m = nearest_runway(track_.from).distance_m;
    return std::any_of(std::begin(kInhibits), std::end(kInhibits), [&](const NearGround& inhibit) {
        return height_above_ground_m_ < inhibit.height_ft * base::kMetresPerFoot &&
               distance_m < inhibit.distance_nm * kMetresPerNauticalMile;
    });
}

bool TerrainWatch::is_too_close(double seconds) {
    for (int line = 0; line < kLines; ++line) {
        const earth::Geodetic place = track_.at(seconds, kHalfWidth_m * (2.0 * line / (kLines - 1) - 1));
        const double ground_m = ground_.height_m(place.latitude_rad, place.longitude_rad);
        if (place.height.m < ground_m + clearance_m_ && !is_ground_of_runway(place, ground_m)) return true;
    }
    return false;
}

bool TerrainWatch::is_ground_of_runway(const earth::Geodetic& place, double ground_m) {
    const NearRunway runway = nearest_runway(place);
    return runway.distance_m < kRunwayRound_nm * kMetresPerNauticalMile && ground_m < runway.height_m + kRunwayGround_m;
}

void TerrainWatch::find_runways(base::Span<const scene::Layer> layers) {
    const double reach_m = track_.ground_speed_mps() * kLookAhead_s + kRunwayRound_nm * kMetresPerNauticalMile;
    for (const scene::Layer& layer : layers) {
        if (layer.entry->role != scene::LayerRole::runway || layer.entry->shape == scene::LayerShape::grid) continue;
        for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature) {
            const scene::Run run = layer.points_of(feature);
            for (std::uint32_t n = 0; n < run.count; ++n) {
                const RunwayLine line{&layer.points[run.first + n], &layer.points[run.first + std::min(n + 1, run.count - 1)]};
                if (nearest_on(*line.from, *line.to, track_.from, track_).distance_m < reach_m)
                    static_cast<void>(runways_.try_push_back(line));
            }
        }
    }
}

TerrainWatch::NearRunway TerrainWatch::nearest_runway(const earth::Geodetic& place) {
    PlaceOnLine nearest{kInfinite, {}};
    for (const RunwayLine& line : runways_)
        if (const PlaceOnLine on = nearest_on(*line.from, *line.to, place, track_); on.distance_m < nearest.distance_m)
            nearest = on;
    if (!(nearest.distance_m < kRunwayRound_nm * kMetresPerNauticalMile)) return {nearest.distance_m, -kInfinite};
    return {nearest.distance_m, ground_.height_m(nearest.at.latitude_rad, nearest.at.longitude_rad)};
}

}  // namespace tedavis::policy
