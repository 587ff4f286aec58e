#include "render_core/draw/data/traffic_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

double seconds_between(const scene::ScenePoint& from, const scene::ScenePoint& to) {
    return from.time_ns == scene::kNoTime || to.time_ns == scene::kNoTime ? 0
                                                                          : 1e-9 * static_cast<double>(to.time_ns - from.time_ns);
}

glm::dvec2 metres_per_rad(const scene::ScenePoint& at) {
    return {std::cos(at.latitude_rad) * earth::prime_vertical_radius_m(at.latitude_rad),
            earth::meridian_radius_m(at.latitude_rad)};
}

/// Of two reports, that between them holds.
void take_velocity(const scene::ScenePoint& from, const scene::ScenePoint& to, TrafficState& state) {
    const double seconds = seconds_between(from, to);
    if (!(seconds > 0) || seconds > kLongestReportGap_s) return;
    const glm::dvec2 metres = metres_per_rad(from);
    state.east = std::remainder(to.longitude_rad - from.longitude_rad, 2 * base::kPi) * metres.x / seconds;
    state.north = (to.latitude_rad - from.latitude_rad) * metres.y / seconds;
    const double climb = static_cast<double>(to.height_m - from.height_m) / seconds;
    state.up = std::isfinite(climb) ? climb : 0;
    state.has_velocity = true;
}

void go_on(TrafficState& state, double seconds) {
    const glm::dvec2 metres = metres_per_rad(state.point);
    if (metres.x > 0) state.point.longitude_rad += state.east * seconds / metres.x;
    state.point.latitude_rad += state.north * seconds / metres.y;
    state.point.height_m += static_cast<float>(state.up * seconds);
}

struct Going {
    double speed_mps, gain_mps2;
};

double grown_m(double stated_m, const TrafficState& state, const Going& going) {
    if (!(stated_m > 0)) return 0;
    const double goes_on_s = state.has_velocity ? std::min(state.age_s, kExtrapolated_s) : 0;
    const double gained_mps = going.gain_mps2 * goes_on_s;
    return stated_m + gained_mps * goes_on_s / 2 + (going.speed_mps + gained_mps) * (state.age_s - goes_on_s);
}

/// Of unknown age, anything may be.
void take_accuracy(const PlaceAccuracy& stated, TrafficState& state) {
    if (std::isnan(state.age_s)) return;
    const bool is_moving = state.has_velocity;
    state.accuracy.level_m =
        grown_m(stated.level_m, state, {is_moving ? std::hypot(state.east, state.north) : kAnySpeed_mps, kManoeuvre_mps2});
    state.accuracy.height_m = grown_m(stated.height_m, state, {is_moving ? std::abs(state.up) : kAnyClimb_mps, kClimbing_mps2});
}

/// Number of reports up to a time. Where times run back it is a number of some, never more than there are.
std::uint32_t reports_until(base::Span<const scene::ScenePoint> points, std::int64_t time_ns) {
    const auto* const end =
        std::upper_bound(points.begin(), points.end(), time_ns,
                         [](std::int64_t time, const scene::ScenePoint& point) { return time < point.time_ns; });
    return static_cast<std::uint32_t>(end - points.begin());
}

}  // namespace

TrafficState traffic_state(const ElementInput& input, std::uint32_t feature) {
    TrafficState state;
    const scene::Run run = input.layer.points_of(feature);
    if (run.count == 0) return state;
    const base::Span<const scene::ScenePoint> points(input.layer.points.data() + run.first, run.count);
    const bool is_timed = input.has_date && points[run.count - 1].time_ns != scene::kNoTime;
    const std::uint32_t until = is_timed ? reports_until(points, input.time_ns) : run.count;
    if (until == 0) return state;
    const scene::ScenePoint& last = points[until - 1];
    state.point = last;
    state.is_known = true;
    const bool has_next = until < run.count && seconds_between(last, points[until]) <= kLongestReportGap_s;
    if (has_next)
        take_velocity(last, points[until], state);
    else if (until > 1)
        take_velocity(points[until - 2], last, state);
    if (is_timed) {
        const double since_s = 1e-9 * static_cast<double>(input.time_ns - last.time_ns);
        go_on(state, has_next ? since_s : std::min(since_s, kExtrapolated_s));
        state.age_s = has_next ? 0 : since_s;
        state.is_stale = state.age_s > kExtrapolated_s;
        state.is_known = state.age_s <= kRemoved_s;
    }
    if (!input.has_age) {
        state.age_s = std::numeric_limits<double>::quiet_NaN();
        state.is_stale = true;
    }
    take_accuracy(place_accuracy(input.layer, {feature, run.first + until - 1}), state);
    return state;
}

bool is_proximate(const ElementInput& input, const TrafficState& state, double height_m) {
    if (!input.own_ship.has_height || state.is_stale || !std::isfinite(state.point.height_m)) return false;
    const earth::Geodetic& own = input.own_ship.place;
    const glm::dvec2 metres = metres_per_rad(state.point);
    const double east_m = std::remainder(state.point.longitude_rad - own.longitude_rad, 2 * base::kPi) * metres.x;
    const double north_m = (state.point.latitude_rad - own.latitude_rad) * metres.y;
    return std::hypot(east_m, north_m) <= kProximate_m && std::abs(height_m - own.height.m) <= kProximateHeight_m;
}

}  // namespace tedavis::draw
