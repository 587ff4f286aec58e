#include "render_core/policy/obstacle_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/earth/geodetic.hpp"
#include "render_core/scene/feature_values.hpp"
#include "render_core/scene/obstacle_stand.hpp"

namespace tedavis::policy {
namespace {

constexpr double kNotMet = std::numeric_limits<double>::infinity();

/// The part of a line that lies in a disc, in shares of it. Empty where `from` > `to`.
struct Part {
    double from = 1, to = 0;
};
Part part_within(double north_m, double east_m, double to_north_m, double to_east_m, double radius_m) {
    const double length2 = to_north_m * to_north_m + to_east_m * to_east_m;
    if (!(length2 > 0)) return std::hypot(north_m, east_m) <= radius_m ? Part{0, 1} : Part{};
    const double along = -(north_m * to_north_m + east_m * to_east_m) / length2;
    const double aside2 = std::fmax(north_m * north_m + east_m * east_m - along * along * length2, 0);
    const double half2 = (radius_m * radius_m - aside2) / length2;
    if (!(half2 >= 0)) return {};
    const double half = std::sqrt(half2);
    return {std::fmax(along - half, 0), std::fmin(along + half, 1)};
}

}  // namespace

ObstacleWatch::ObstacleWatch(TerrainWatch& watch, scene::Ground& ground)
    : track_(watch.track()), steps_(watch.steps()), ground_(ground), box_{kNotMet, -kNotMet, kNotMet, -kNotMet} {
    for (const TrackStep& step : steps_) {
        box_.south_m = std::fmin(box_.south_m, step.north_m - step.radius_m);
        box_.north_m = std::fmax(box_.north_m, step.north_m + step.radius_m);
        box_.west_m = std::fmin(box_.west_m, step.east_m - step.radius_m);
        box_.east_m = std::fmax(box_.east_m, step.east_m + step.radius_m);
    }
}

ObstacleWatch::Place ObstacleWatch::place_of(const scene::ScenePoint& point) const {
    return {(point.latitude_rad - track_.from.latitude_rad) * track_.metres_per_latitude_rad(),
            earth::angle_difference(point.longitude_rad, track_.from.longitude_rad) * track_.metres_per_longitude_rad()};
}

bool ObstacleWatch::is_aside(const Span& span, double margin_m) const {
    return std::fmax(span.from.north_m, span.to.north_m) < box_.south_m - margin_m ||
           std::fmin(span.from.north_m, span.to.north_m) > box_.north_m + margin_m ||
           std::fmax(span.from.east_m, span.to.east_m) < box_.west_m - margin_m ||
           std::fmin(span.from.east_m, span.to.east_m) > box_.east_m + margin_m;
}

double ObstacleWatch::seconds_to(const scene::Layer& layer, std::uint32_t feature) {
    if (steps_.empty()) return kNotMet;
    const scene::Run run = layer.points_of(feature);
    double soonest_s = kNotMet;
    for (std::uint32_t n = 0; n + 1 < std::max(run.count, 2u); ++n) {
        const scene::ScenePoint& first = layer.points[run.first + n];
        const scene::ScenePoint& last = layer.points[run.first + std::min(n + 1, run.count - 1)];
        soonest_s = std::fmin(soonest_s, seconds_to(layer, feature, {place_of(first), place_of(last), &first, &last}));
    }
    return soonest_s;
}

/// The ground is asked only of what lies in the way.
double ObstacleWatch::seconds_to(const scene::Layer& layer, std::uint32_t feature, const Span& span) {
    const scene::ObstacleAccuracy accuracy = scene::obstacle_accuracy(layer, feature);
    if (is_aside(span, accuracy.level_m)) return kNotMet;
    const double unknown_m = layer.entry->shape == scene::LayerShape::lines ? scene::kPole_m : scene::kUnknownObstacle_m;
    double from_top_m = std::nan(""), to_top_m = from_top_m;
    bool has_tops = false;
    for (const TrackStep& step : steps_) {
        const Part part =
            part_within(span.from.north_m - step.north_m, span.from.east_m - step.east_m, span.to.north_m - span.from.north_m,
                        span.to.east_m - span.from.east_m, step.radius_m + accuracy.level_m);
        if (part.from > part.to) continue;
        if (!has_tops) {
            const double height_m = scene::value_or_nan(layer, "height", feature);
            from_top_m = scene::obstacle_stand(layer, *span.first, height_m, unknown_m, ground_).top_m;
            to_top_m = scene::obstacle_stand(layer, *span.last, height_m, unknown_m, ground_).top_m;
            if (std::isnan(from_top_m)) from_top_m = to_top_m;
            if (std::isnan(to_top_m)) to_top_m = from_top_m;
            has_tops = true;
        }
        const double rise_m = to_top_m - from_top_m;
        const double top_m = from_top_m + std::fmax(part.from * rise_m, part.to * rise_m) + accuracy.height_m;
        if (top_m > step.floor_m) return step.from_s;
    }
    return kNotMet;
}

}  // namespace tedavis::policy
