#include "render_core/policy/predicted_track.hpp"

namespace tedavis::policy {
namespace {

/// sin(x) / x and (1 - cos(x)) / x, without loss where x is small.
struct Arc {
    double along, aside;
};
Arc arc_of(double x) {
    if (std::fabs(x) < 1e-4) return {1 - x * x / 6, x / 2};
    return {std::sin(x) / x, (1 - std::cos(x)) / x};
}

}  // namespace

earth::Geodetic PredictedTrack::at(double seconds, double right_m) const {
    const double speed_mps = ground_speed_mps(), turned = turn_radps * seconds;
    const Arc arc = arc_of(turned);
    const double aside_s = speed_mps > 0 ? right_m / speed_mps : 0;  // in the direction then, turned to its right
    const double ahead_s = arc.along * seconds - std::sin(turned) * aside_s;
    const double right_s = arc.aside * seconds + std::cos(turned) * aside_s;
    const double north_m = north_mps * ahead_s - east_mps * right_s, east_m = east_mps * ahead_s + north_mps * right_s;
    return {from.latitude_rad + north_m / metres_per_latitude_rad(),
            from.longitude_rad + east_m / metres_per_longitude_rad(),
            {from.height.m + up_mps * seconds}};
}

}  // namespace tedavis::policy
