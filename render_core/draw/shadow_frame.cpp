#include "render_core/draw/shadow_frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kKnotsPerRadian = 20 * 180 / base::kPi;
constexpr double kFinestHalf_m = 2'000, kLowEye_m = 1'500;
constexpr int kMaxDoublings = 3;
constexpr double kAhead = 0.5;  // of half an edge: what is behind the eye is not seen

earth::Geodetic knot_near(const earth::Geodetic& place) {
    return {std::round(place.latitude_rad * kKnotsPerRadian) / kKnotsPerRadian,
            std::round(place.longitude_rad * kKnotsPerRadian) / kKnotsPerRadian,
            {0}};
}

/// The light's right is level; where it stands in the zenith, east.
glm::dmat3 light_axes(const glm::dmat3& north_east_down, double azimuth_rad, double elevation_rad) {
    const glm::dvec3 north = north_east_down[0], east = north_east_down[1], above = -north_east_down[2];
    const glm::dvec3 level = std::cos(azimuth_rad) * north + std::sin(azimuth_rad) * east;
    const glm::dvec3 towards = std::cos(elevation_rad) * level + std::sin(elevation_rad) * above;
    const glm::dvec3 right = std::cos(azimuth_rad) * east - std::sin(azimuth_rad) * north;
    return {right, glm::cross(towards, right), towards};
}

/// High above the ground, so are pixels larger.
double finest_half_m(double eye_height_m) {
    const double doublings = std::ceil(std::log2(std::fmax(eye_height_m, 1) / kLowEye_m));
    return kFinestHalf_m * std::exp2(std::clamp(doublings, 0.0, double{kMaxDoublings}));
}

double snapped(double value, double step) { return step * std::round(value / step); }

}  // namespace

ShadowFrame make_shadow_frame(const ShadowView& from) {
    const earth::Geodetic eye = earth::from_ecef(from.view.eye);
    const earth::Geodetic knot = knot_near(eye);
    ShadowFrame frame;
    frame.anchor = earth::to_ecef(knot);
    frame.axes = light_axes(earth::north_east_down(knot.latitude_rad, knot.longitude_rad), from.azimuth_rad, from.elevation_rad);
    frame.sine = std::sin(from.elevation_rad);
    const glm::dvec3 up = earth::up_at(from.view.eye);
    const glm::dvec3 ahead = from.view.forward - glm::dot(from.view.forward, up) * up;
    const glm::dvec3 below = from.view.eye - from.eye_height_m * up;
    double half_m = finest_half_m(from.eye_height_m);
    for (ShadowLevel& level : frame.levels) {
        level.half_m = half_m;
        const glm::dvec2 middle(frame.in_light(below + kAhead * half_m * ahead));
        const double step_m = texel_m(level, from.level_px);
        level.middle_m = {snapped(middle.x, step_m), snapped(middle.y, step_m)};
        half_m *= kLevelRatio;
    }
    return frame;
}

void add_caster(ShadowFrame& frame, const CasterBall& ball) {
    const glm::dvec3 middle = frame.in_light(ball.middle);
    frame.low_m = glm::min(frame.low_m, middle - ball.radius_m);
    frame.high_m = glm::max(frame.high_m, middle + ball.radius_m);
    frame.top_m = std::fmax(frame.top_m, ball.top_m);
    for (ShadowLevel& level : frame.levels) {
        const glm::dvec2 away = glm::abs(glm::dvec2(middle) - level.middle_m);
        level.is_used = level.is_used || std::fmax(away.x, away.y) <= level.half_m + ball.radius_m;
    }
}

bool shades_the_view(const ShadowFrame& frame, const terrain::View& view, const CasterBall& ball, double lowest_m) {
    const glm::dvec3 towards = frame.axes[2];
    const double fall_m = std::fmax(ball.top_m - lowest_m, 0);
    const glm::dvec3 from = ball.middle - view.eye, to = from - towards * (fall_m / frame.sine);
    const double wide = view.half_width_tangent(), high = view.half_height_tangent();
    // Outwards from the sides of the picture.
    const glm::dvec3 sides[] = {-view.forward, view.right - wide * view.forward, -view.right - wide * view.forward,
                                view.down - high * view.forward, -view.down - high * view.forward};
    for (const glm::dvec3& side : sides)
        if (std::fmin(glm::dot(side, from), glm::dot(side, to)) > ball.radius_m * glm::length(side)) return false;
    return true;
}

}  // namespace tedavis::draw
