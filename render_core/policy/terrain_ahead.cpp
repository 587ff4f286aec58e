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
constexpr double kStep_m = 60;
constexpr double kCloser = 0.75;         // of the height above ground now
constexpr double kRunwayGround_m = 30;   // ground round a runway is so much higher at most
constexpr double kRunwayRound_nm = 1.0;  // and so near
constexpr double kClimbing_mps = 0.5;    // 100 ft/min: who climbs is not landing
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

TerrainWatch::TerrainWatch(const TerrainWatchInput& input, scene::Ground& ground, GroundBound& bound)
    : track_(input.track), ground_(ground), bound_(bound) {
    find_runways(input.layers);
    const earth::Geodetic& from = track_.from;
    const double below_m = ground_.height_m(from.latitude_rad, from.longitude_rad);
    height_above_ground_m_ = std::isnan(below_m) ? kInfinite : from.height.m - below_m;
    const TrackUncertainty& uncertainty = input.uncertainty;
    const double speed_mps = track_.ground_speed_mps();
    radius_m_ = uncertainty.position_m;
    radius_mps_ = uncertainty.speed_mps + speed_mps * uncertainty.direction_rad;
    radius_mps2_ = speed_mps * uncertainty.turn_radps / 2;
    const double half_turn_s = base::kPi / std::fabs(track_.turn_radps);
    until_s_ = std::fmin(kLookAhead_s, half_turn_s);
    const double landing_s = seconds_to_landing(), clearance_m = required_clearance_m(input.phase, track_.up_mps);
    const double landing_clearance_m = required_clearance_m(flight::kApproachFinal, track_.up_mps);
    clearance_m_ = landing_s < until_s_ ? std::fmin(clearance_m, landing_clearance_m) : clearance_m;
    const double kept_m = clearance_m_ + uncertainty.height_m;
    until_s_ = std::fmin(until_s_, landing_s);
    const double near_m = kCloser * std::fmax(height_above_ground_m_, 0);
    const double share = std::fmin(1, near_m / (kept_m + uncertainty.climb_mps * until_s_));
    floor_m_ = from.height.m - share * kept_m;
    floor_mps_ = track_.up_mps - share * uncertainty.climb_mps;
    clearance_m_ *= share;
}

double counted_s(double on_track_s, double straight_s) noexcept { return std::fmin(on_track_s, 2 * straight_s); }

TerrainAhead level_within(double seconds) noexcept {
    if (seconds <= kTerrainWarning_s) return TerrainAhead::warning;
    return seconds <= kTerrainCaution_s ? TerrainAhead::caution : TerrainAhead::none;
}

/// Long enough for kMaxSteps, and where the track is wide, a quarter of its width.
double TerrainWatch::step_s(double seconds) const {
    return std::fmax(std::fmax(kStep_m, radius_at(seconds) / 2) / track_.ground_speed_mps(), kLookAhead_s / (kMaxSteps - 1));
}

double TerrainWatch::seconds_to_terrain() {
    if (!is_watching()) return kInfinite;
    double seconds = 0;
    for (int n = 0; n < kMaxSteps && seconds < until_s_; ++n) {
        const double next_s = std::fmin(seconds + step_s(seconds), until_s_);
        if (is_too_close(step_between(seconds, next_s))) return seconds;
        seconds = next_s;
    }
    return kInfinite;
}

bool TerrainWatch::is_watching() { return track_.ground_speed_mps() >= kSlowest_mps && until_s_ > 0 && !is_inhibited(); }

TrackSteps TerrainWatch::steps() {
    TrackSteps steps;
    if (track_.ground_speed_mps() < kSlowest_mps) return steps;
    double seconds = 0;
    while (!steps.full() && seconds < until_s_) {
        const double next_s = std::fmin(seconds + step_s(seconds), until_s_);
        TrackStep step = step_between(seconds, next_s);
        step.floor_m = floor_near_runway(step);
        static_cast<void>(steps.try_push_back(step));
        seconds = next_s;
    }
    return steps;
}

TerrainAlertZone TerrainWatch::zone(TerrainAhead alert) {
    const earth::Geodetic& from = track_.from;
    TerrainAlertZone zone;
    if (!std::isfinite(floor_m_ + floor_mps_ + track_.north_mps + track_.east_mps + track_.turn_radps)) return zone;
    zone.alert = alert;
    zone.from = from;
    zone.north_mps = track_.north_mps;
    zone.east_mps = track_.east_mps;
    zone.turn_radps = track_.turn_radps;
    zone.radius_m = radius_m_ + kShownMargin_m;
    zone.radius_mps = radius_mps_;
    zone.radius_mps2 = radius_mps2_;
    const double undulation_m = ground_.undulation_m(from.latitude_rad, from.longitude_rad);
    // The bound's discs hold ground that is passed earlier or later than their own time, at another floor.
    const double off_s = radius_at(until_s_) / std::fmax(track_.ground_speed_mps(), kSlowest_mps);
    zone.floor_msl_m = floor_m_ - undulation_m - std::fabs(floor_mps_) * off_s;
    zone.floor_mps = floor_mps_;
    zone.until_s = until_s_ < kLookAhead_s ? until_s_ : kLookAhead_s + off_s;
    const NearRunway runway = nearest_runway(track_.at(until_s_));
    if (std::isinf(runway.height_m) || std::isnan(runway.height_m)) return zone;
    zone.runway = {(runway.place.latitude_rad - from.latitude_rad) * track_.metres_per_latitude_rad(),
                   earth::angle_difference(runway.place.longitude_rad, from.longitude_rad) * track_.metres_per_longitude_rad(),
                   kRunwayRound_nm * kMetresPerNauticalMile, runway.height_m + kRunwayGround_m - undulation_m};
    return zone;
}

/// Infinite where the track does not reach a runway before it ends.
double TerrainWatch::seconds_to_landing() {
    if (runways_.empty() || track_.ground_speed_mps() < kSlowest_mps) return kInfinite;
    double seconds = 0;
    for (int n = 0; n < kMaxSteps && seconds < until_s_; ++n) {
        if (lands(seconds)) return seconds;
        seconds += step_s(seconds);
    }
    return kInfinite;
}

/// From there on the track would lead below the ground.
bool TerrainWatch::lands(double seconds) {
    if (track_.up_mps > kClimbing_mps) return false;
    const earth::Geodetic place = track_.at(seconds);
    const NearRunway runway = nearest_runway(place);
    if (!std::isfinite(runway.height_m)) return false;
    const double ground_m = ground_.height_m(place.latitude_rad, place.longitude_rad);
    return place.height.m < ground_m + kFlare_m && ground_m < runway.height_m + kRunwayGround_m;
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

/// A disc as wide as the track is at the end of the step; it contains the track on its way there.
TrackStep TerrainWatch::step_between(double from_s, double to_s) const {
    const earth::Geodetic middle = track_.at((from_s + to_s) / 2);
    return {from_s,
            to_s,
            (middle.latitude_rad - track_.from.latitude_rad) * track_.metres_per_latitude_rad(),
            (middle.longitude_rad - track_.from.longitude_rad) * track_.metres_per_longitude_rad(),
            radius_at(to_s) + track_.ground_speed_mps() * (to_s - from_s) / 2,
            std::fmin(floor_at(from_s), floor_at(to_s))};
}

/// As in low flight (kCloser), by the height there.
double TerrainWatch::floor_near_runway(const TrackStep& step) {
    const NearRunway runway = nearest_runway(track_.at((step.from_s + step.to_s) / 2));
    const double lowest_m = std::fmin(track_.at(step.from_s).height.m, track_.at(step.to_s).height.m);
    if (!std::isfinite(runway.height_m) || !(lowest_m > runway.height_m)) return step.floor_m;
    return std::fmax(step.floor_m, runway.height_m + (1 - kCloser) * (lowest_m - runway.height_m));
}

bool TerrainWatch::is_too_close(const TrackStep& step) {
    const earth::Geodetic place = track_.at((step.from_s + step.to_s) / 2);
    const double highest_m = bound_.highest_m(place.latitude_rad, place.longitude_rad, step.radius_m, step.floor_m);
    if (!(highest_m > step.floor_m)) return false;
    const NearRunway runway = nearest_runway(place);
    const bool is_at_runway = runway.distance_m + step.radius_m < kRunwayRound_nm * kMetresPerNauticalMile;
    return !is_at_runway || highest_m > std::fmax(step.floor_m, runway.height_m + kRunwayGround_m);
}

void TerrainWatch::find_runways(base::Span<const scene::Layer> layers) {
    const double reach_m = track_.ground_speed_mps() * kLookAhead_s + kRunwayRound_nm * kMetresPerNauticalMile;
    for (const scene::Layer& layer : layers) {
        if (layer.entry->role != scene::LayerRole::runway || layer.entry->shape == scene::LayerShape::grid) continue;
        for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature) {
            const scene::Run run = layer.points_of(feature);
            for (std::uint32_t n = 0; n + 1 < std::max(run.count, 2u); ++n) {
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
    if (!(nearest.distance_m < kRunwayRound_nm * kMetresPerNauticalMile)) return {nearest.distance_m, -kInfinite, nearest.at};
    return {nearest.distance_m, ground_.height_m(nearest.at.latitude_rad, nearest.at.longitude_rad), nearest.at};
}

}  // namespace tedavis::policy
