#include "render_core/draw/data/planned_track.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

/// A map of the surroundings, true to a hundredth within 5 km; farther places come out far.
class Surroundings {
public:
    explicit Surroundings(const earth::Geodetic& middle)
        : middle_(middle),
          east_m_(earth::prime_vertical_radius_m(middle.latitude_rad) * std::cos(middle.latitude_rad)),
          north_m_(earth::meridian_radius_m(middle.latitude_rad)) {}

    [[nodiscard]] glm::dvec2 at(const scene::ScenePoint& point) const {
        return {std::remainder(point.longitude_rad - middle_.longitude_rad, 2 * base::kPi) * east_m_,
                (point.latitude_rad - middle_.latitude_rad) * north_m_};
    }

private:
    earth::Geodetic middle_;
    double east_m_, north_m_;
};

/// Of the leg's place that is nearest to the middle.
double nearest_part(const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from;
    const double square = glm::dot(along, along);
    return square > 0 ? std::clamp(-glm::dot(from, along) / square, 0.0, 1.0) : 0;
}

bool has_times(const scene::ScenePoint& a, const scene::ScenePoint& b) {
    return a.time_ns != scene::kNoTime && b.time_ns != scene::kNoTime && b.time_ns > a.time_ns;
}

/// Of some legs, nearer than `least_m`, which then is its distance.
void take_if_nearer(const scene::Layer& layer, const scene::Run& run, std::uint32_t first_leg, std::uint32_t legs,
                    const Surroundings& map, double& least_m, PlannedTrack& nearest) {
    for (std::uint32_t leg = first_leg; leg < first_leg + legs; ++leg) {
        const glm::dvec2 from = map.at(layer.points[run.first + leg]), to = map.at(layer.points[run.first + leg + 1]);
        const double part = nearest_part(from, to), distance_m = glm::length(glm::mix(from, to, part));
        if (!(distance_m < least_m)) continue;
        least_m = distance_m;
        nearest = {&layer, run, leg, part};
    }
}

void take_nearest(const scene::Layer& layer, const Surroundings& map, double& least_m, PlannedTrack& nearest) {
    for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature) {
        const scene::Run run = layer.points_of(feature);
        if (run.count > 1) take_if_nearer(layer, run, 0, run.count - 1, map, least_m, nearest);
    }
}

/// True where the time gives a place near the own ship, which the way then has.
bool follow_time(const Surroundings& map, std::int64_t time_ns, double farthest_m, PlannedTrack& way) {
    for (std::uint32_t leg = 0; leg + 1 < way.run.count; ++leg) {
        const scene::ScenePoint &from = way.layer->points[way.run.first + leg], &to = way.layer->points[way.run.first + leg + 1];
        if (!has_times(from, to) || time_ns < from.time_ns || time_ns > to.time_ns) continue;
        const double part = static_cast<double>(time_ns - from.time_ns) / static_cast<double>(to.time_ns - from.time_ns);
        if (glm::length(glm::mix(map.at(from), map.at(to), part)) > farthest_m) return false;
        way.leg = leg;
        way.part = part;
        return true;
    }
    return false;
}

/// The nearest place within `farthest_m` along the way of the one that it has.
void take_nearest_around(const Surroundings& map, double farthest_m, PlannedTrack& way) {
    const auto long_m = [&](std::uint32_t leg) {
        const base::Span<const scene::ScenePoint>& points = way.layer->points;
        return glm::length(map.at(points[way.run.first + leg + 1]) - map.at(points[way.run.first + leg]));
    };
    std::uint32_t first = way.leg, last = way.leg;
    for (double left_m = farthest_m; first > 0 && left_m > 0;) left_m -= long_m(--first);
    for (double left_m = farthest_m; last + 2 < way.run.count && left_m > 0;) left_m -= long_m(++last);
    double least_m = std::numeric_limits<double>::infinity();
    take_if_nearer(*way.layer, way.run, first, last - first + 1, map, least_m, way);
}

}  // namespace

PlannedTrack planned_track(const scene::Scene& scene, const earth::Geodetic& own_ship, std::int64_t time_ns, bool has_date,
                           double farthest_m) {
    const Surroundings map(own_ship);
    PlannedTrack nearest;
    double least_m = farthest_m;
    for (const scene::Layer& layer : scene.layers()) {
        if (layer.entry->role != scene::LayerRole::trajectory || layer.entry->shape != scene::LayerShape::lines) continue;
        take_nearest(layer, map, least_m, nearest);
    }
    if (nearest.layer != nullptr && has_date) static_cast<void>(follow_time(map, time_ns, farthest_m, nearest));
    return nearest;
}

PlannedTrack track_beside(const scene::Layer& layer, const earth::Geodetic& own_ship, std::int64_t time_ns, bool has_date,
                          double farthest_m) {
    const Surroundings map(own_ship);
    PlannedTrack nearest;
    double least_m = farthest_m;
    take_nearest(layer, map, least_m, nearest);
    if (nearest.layer != nullptr && has_date && follow_time(map, time_ns, farthest_m, nearest))
        take_nearest_around(map, farthest_m, nearest);
    return nearest;
}

scene::ScenePoint point_on(const PlannedTrack& way, std::uint32_t leg, double part) {
    const scene::ScenePoint &from = way.layer->points[way.run.first + leg], &to = way.layer->points[way.run.first + leg + 1];
    scene::ScenePoint point = from;
    point.latitude_rad += part * (to.latitude_rad - from.latitude_rad);
    point.longitude_rad =
        earth::wrap_longitude(from.longitude_rad + part * std::remainder(to.longitude_rad - from.longitude_rad, 2 * base::kPi));
    point.height_m += static_cast<float>(part) * (to.height_m - from.height_m);
    point.time_ns = scene::kNoTime;
    if (has_times(from, to)) point.time_ns = from.time_ns + std::llround(part * static_cast<double>(to.time_ns - from.time_ns));
    return point;
}

}  // namespace tedavis::draw
