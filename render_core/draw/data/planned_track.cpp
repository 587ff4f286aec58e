#include "render_core/draw/data/planned_track.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

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

/// Nearer than `least_m`, which then is its distance.
void take_if_nearer(const scene::Layer& layer, const scene::Run& run, const Surroundings& map, double& least_m,
                    PlannedTrack& nearest) {
    for (std::uint32_t leg = 0; leg + 1 < run.count; ++leg) {
        const glm::dvec2 from = map.at(layer.points[run.first + leg]), to = map.at(layer.points[run.first + leg + 1]);
        const double part = nearest_part(from, to), distance_m = glm::length(glm::mix(from, to, part));
        if (!(distance_m < least_m)) continue;
        least_m = distance_m;
        nearest = {&layer, run, leg, part};
    }
}

void follow_time(const Surroundings& map, std::int64_t time_ns, double farthest_m, PlannedTrack& way) {
    for (std::uint32_t leg = 0; leg + 1 < way.run.count; ++leg) {
        const scene::ScenePoint &from = way.layer->points[way.run.first + leg], &to = way.layer->points[way.run.first + leg + 1];
        if (!has_times(from, to) || time_ns < from.time_ns || time_ns > to.time_ns) continue;
        const double part = static_cast<double>(time_ns - from.time_ns) / static_cast<double>(to.time_ns - from.time_ns);
        if (glm::length(glm::mix(map.at(from), map.at(to), part)) > farthest_m) return;
        way.leg = leg;
        way.part = part;
        return;
    }
}

}  // namespace

PlannedTrack planned_track(const scene::Scene& scene, const earth::Geodetic& own_ship, std::int64_t time_ns, bool has_date,
                           double farthest_m) {
    const Surroundings map(own_ship);
    PlannedTrack nearest;
    double least_m = farthest_m;
    for (const scene::Layer& layer : scene.layers()) {
        if (layer.entry->role != scene::LayerRole::trajectory || layer.entry->shape != scene::LayerShape::lines) continue;
        for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature)
            take_if_nearer(layer, layer.points_of(feature), map, least_m, nearest);
    }
    if (nearest.layer != nullptr && has_date) follow_time(map, time_ns, farthest_m, nearest);
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
