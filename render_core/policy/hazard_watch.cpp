#include "render_core/policy/hazard_watch.hpp"

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/scene/area_limits.hpp"
#include "render_core/scene/feature_values.hpp"

namespace tedavis::policy {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kParts = 8;

/// From a place to the straight line between two others.
double distance_m(double east, double north, double to_east, double to_north) {
    const double length2 = to_east * to_east + to_north * to_north;
    const double along = length2 > 0 ? -(east * to_east + north * to_north) / length2 : 0;
    const double kept = std::fmin(std::fmax(along, 0), 1);
    return std::hypot(east + kept * to_east, north + kept * to_north);
}

}  // namespace

HazardWatch::HazardWatch(const design::PrioritySettings& settings, const PredictedTrack& track, scene::Ground& ground,
                         std::int64_t time_ns)
    : settings_(settings),
      track_(track),
      ground_(ground),
      time_ns_(time_ns),
      metres_per_latitude_(track.metres_per_latitude_rad()),
      metres_per_longitude_(track.metres_per_longitude_rad()) {}

double HazardWatch::share_of(double seconds) const {
    const double left = 2 * (1 - seconds / settings_.hazard_ahead_s);
    return std::floor(kParts * std::fmin(std::fmax(left, 0), 1)) / kParts;
}

double HazardWatch::note(double seconds) {
    const double share = share_of(seconds);
    if (share > 0) soonest_s_ = std::fmin(soonest_s_, seconds);
    return share;
}

bool HazardWatch::first_met(earth::Geodetic& place) const {
    if (!(soonest_s_ < kNever)) return false;
    place = track_.at(soonest_s_);
    return true;
}

HazardWatch::Place HazardWatch::place_of(const scene::ScenePoint& point) const {
    double east_rad = point.longitude_rad - track_.from.longitude_rad;
    if (std::fabs(east_rad) > base::kPi) east_rad -= std::copysign(2 * base::kPi, east_rad);
    return {east_rad * metres_per_longitude_, (point.latitude_rad - track_.from.latitude_rad) * metres_per_latitude_};
}

/// Between two steps nothing is flown past.
double HazardWatch::reach_m() const {
    return settings_.hazard_within_m + 0.5 * std::hypot(track_.east_mps, track_.north_mps) * settings_.hazard_ahead_s / kSteps;
}

/// Beyond one side of a box round the whole way.
bool HazardWatch::is_aside(const scene::Layer& layer, scene::Run run, Place drift) const {
    const Place end = track_at(settings_.hazard_ahead_s);
    double west = kNever, east = -kNever, south = kNever, north = -kNever;
    for (std::uint32_t n = 0; n < run.count; ++n) {
        const Place at = place_of(layer.points[run.first + n]);
        west = std::fmin(west, at.east_m + drift.east_m);
        east = std::fmax(east, at.east_m + drift.east_m);
        south = std::fmin(south, at.north_m + drift.north_m);
        north = std::fmax(north, at.north_m + drift.north_m);
    }
    const double reach = reach_m();
    return west > std::fmax(end.east_m, 0) + reach || east < std::fmin(end.east_m, 0) - reach ||
           south > std::fmax(end.north_m, 0) + reach || north < std::fmin(end.north_m, 0) - reach;
}

double HazardWatch::terrain_share() {
    constexpr int kFiner = 4;
    for (int step = 0; step < kFiner * kSteps; ++step)
        if (is_at_terrain(time_of(step) / kFiner)) return note(time_of(step) / kFiner);
    return 0;
}

/// Below the way and aside of it, across its track.
bool HazardWatch::is_at_terrain(double seconds) {
    constexpr int kAside = 2;
    for (int n = -kAside; n <= kAside; ++n) {
        const earth::Geodetic place = track_.at(seconds, settings_.hazard_within_m * n / kAside);
        if (place.height.m < ground_.height_m(place.latitude_rad, place.longitude_rad) + clearance_m()) return true;
    }
    return false;
}

double HazardWatch::layer_share(const scene::Layer& layer) {
    double share = 0;
    for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature)
        share = std::fmax(share, note(seconds_to(layer, feature)));
    return share;
}

double HazardWatch::seconds_to(const scene::Layer& layer, std::uint32_t feature) {
    const glm::dvec2 drift = scene::drift_m(layer, feature, time_ns_, true);
    const scene::Run run = layer.points_of(feature);
    if (is_aside(layer, run, {drift.x, drift.y})) return kNever;
    for (int step = 0; step < kSteps; ++step)
        if (is_near(layer, run, {drift.x, drift.y}, time_of(step)) && is_at_height(layer, feature, time_of(step)))
            return time_of(step);
    return kNever;
}

/// Within an area by how often its border is crossed to the east.
bool HazardWatch::is_near(const scene::Layer& layer, scene::Run run, Place drift, double seconds) const {
    const Place own = track_at(seconds);
    const double reach = reach_m();
    const bool is_area = layer.entry->shape == scene::LayerShape::areas;
    bool is_inside = false;
    for (std::uint32_t n = 0; n < run.count; ++n) {
        const bool is_last = n + 1 == run.count;
        const Place a = place_of(layer.points[run.first + n]);
        const Place b = is_last && !is_area ? a : place_of(layer.points[run.first + (is_last ? 0 : n + 1)]);
        const double east = a.east_m + drift.east_m - own.east_m, north = a.north_m + drift.north_m - own.north_m;
        const double to_east = b.east_m - a.east_m, to_north = b.north_m - a.north_m;
        if (distance_m(east, north, to_east, to_north) <= reach) return true;
        const bool crosses = (north > 0) != (north + to_north > 0);
        if (crosses && east - north * to_east / to_north > 0) is_inside = !is_inside;
    }
    return is_area && is_inside;
}

double HazardWatch::over_ellipsoid_m(double height_m, scene::HeightDatum datum, const earth::Geodetic& at) {
    if (datum == scene::HeightDatum::ellipsoid) return height_m;
    if (datum == scene::HeightDatum::msl) return height_m + ground_.undulation_m(at.latitude_rad, at.longitude_rad);
    return height_m + ground_.height_m(at.latitude_rad, at.longitude_rad);
}

/// Comparisons with what is not a number are false: it is in the way.
bool HazardWatch::is_at_height(const scene::Layer& layer, std::uint32_t feature, double seconds) {
    const earth::Geodetic at = track_.at(seconds);
    if (layer.entry->shape != scene::LayerShape::areas) {
        const scene::Run run = layer.points_of(feature);
        double top_m = static_cast<double>(layer.points[run.first].height_m);
        for (std::uint32_t n = 1; n < run.count; ++n) {
            const auto height_m = static_cast<double>(layer.points[run.first + n].height_m);
            if (!(height_m <= top_m)) top_m = height_m;
        }
        return !(at.height.m > over_ellipsoid_m(top_m, layer.entry->height_datum, at) + clearance_m());
    }
    const scene::AreaLimits limits = scene::area_limits(layer, feature);
    const bool is_over = at.height.m > over_ellipsoid_m(limits.ceiling.m, limits.ceiling.datum, at) + clearance_m();
    const bool is_under = at.height.m < over_ellipsoid_m(limits.floor.m, limits.floor.datum, at) - clearance_m();
    return !is_over && !is_under;
}

}  // namespace tedavis::policy
