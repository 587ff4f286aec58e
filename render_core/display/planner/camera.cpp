#include "render_core/display/planner/camera.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {
namespace {

constexpr double kRadius_m = 6371000;
constexpr double kHighestSummit_m = 9000;
constexpr double kLowestGround_m = -500;
constexpr double kMaxUndulation_m = 110;  // either way, EGM96

constexpr double kFar_m = 400000;
constexpr double kNearestPlane_m = 1;
constexpr double kFarthestNearPlane_m = 50;
constexpr double kNearPlaneOfHeight = 0.02;

// A summit of 1 km is then displaced by less than a thousandth of the range. Beyond 2^24 m whole metres are no longer exact in
// float, on which the seams between chunks rely.
constexpr double kMapDistanceOfRange = 1000;
constexpr double kFarthestMapCamera_m = 15'000'000;

// What is shown over the ground, as columns of time, in the orthographic view.
constexpr double kHighestElement_m = 20'000;
constexpr double kNearestObliqueCamera_m = 3'000'000;

// Shares of the transition in which the camera turns and in which it rises.
constexpr double kTurned = 0.6;
constexpr double kRiseBegins = 0.35;
constexpr double kMinAboveGround_m = 1;
constexpr double kMaxAboveGround_m = 100'000;

/// Returns the distance of the visible horizon over a sphere, with room for mountains behind it.
double horizon_m(double height_m) {
    return std::sqrt(2 * kRadius_m * std::fmax(height_m, 1.0)) + std::sqrt(2 * kRadius_m * kHighestSummit_m);
}

/// Rises from 0 at `begin` to 1 at `end`, with slope 0 at both.
double eased(double share, double begin, double end) {
    const double t = std::clamp((share - begin) / (end - begin), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double geometric(double from, double to, double share) { return from * std::pow(to / from, share); }

void aim(terrain::View& view, const earth::Geodetic& place, double heading_rad, double pitch_rad, double roll_rad) {
    const glm::dmat3 body = earth::body_axes(place.latitude_rad, place.longitude_rad, heading_rad, pitch_rad, roll_rad);
    view.forward = body[0];
    view.right = body[1];
    view.down = body[2];
}

terrain::View perspective_view(const CameraInput& input, const design::ViewSettings& design) {
    terrain::View view;
    aim(view, input.own_ship, input.heading_rad, input.pitch_rad, input.roll_rad);
    const glm::dvec3 seat = input.eye_m + glm::dvec3(design.eye_forward_m, design.eye_right_m, design.eye_down_m);
    view.eye = earth::to_ecef(input.own_ship) + glm::dmat3(view.forward, view.right, view.down) * seat;
    view.focal_px = 0.5 * input.width_px / std::tan(0.5 * design.horizontal_field_of_view_rad);
    view.near_m = std::fmin(std::fmax(kNearPlaneOfHeight * input.above_ground_m, kNearestPlane_m), kFarthestNearPlane_m);
    view.far_m = std::fmin(kFar_m, horizon_m(input.msl_m));
    return view;
}

/// Returns a distance so large that a summit in a small picture has nearly the scale of the ground, but not beyond the range in
/// which float vertices are accurate.
double oblique_distance_m(const design::ViewSettings& design) {
    return std::fmin(std::fmax(kMapDistanceOfRange * design.map_range_m, kNearestObliqueCamera_m), kFarthestMapCamera_m);
}

double map_distance_m(const design::ViewSettings& design) {
    return std::fmin(kMapDistanceOfRange * design.map_range_m, kFarthestMapCamera_m);
}

/// Returns how far the ground has fallen below the level of the middle at the corners of the map.
double drop_at_corner_m(const CameraInput& input, const design::ViewSettings& design) {
    const double half_diagonal_px = 0.5 * std::hypot(input.width_px, input.height_px);
    const double corner_m = half_diagonal_px / map_scale_px_per_m(design, input.width_px, input.height_px);
    const double aside = std::fmin(corner_m, 0.9 * kRadius_m);
    return kRadius_m - std::sqrt(kRadius_m * kRadius_m - aside * aside);
}

/// Tightly round the ground.
void set_map_planes(terrain::View& view, double eye_msl_m, double drop_m) {
    const double rounding_m = 1e-6 * eye_msl_m;  // of depths in float
    const double slack_m = 2 * kMaxUndulation_m + rounding_m;
    view.near_m = eye_msl_m - kHighestSummit_m - slack_m;
    view.far_m = eye_msl_m - kLowestGround_m + drop_m + slack_m;
}

/// Sets the planes. The near one is that of the own ship's view or, where the camera is higher, one above all summits; rays at
/// the corners go further down than in the middle.
void set_planes_on_the_way(terrain::View& view, double msl_m, double climb_m, double growth) {
    const double corner = std::hypot(1.0, view.half_width_tangent(), view.half_height_tangent());
    view.near_m = std::fmax(view.near_m, (msl_m + climb_m - kHighestSummit_m - 2 * kMaxUndulation_m) / corner);
    view.far_m = std::fmin(kFar_m * growth, horizon_m(msl_m + climb_m) + climb_m);
}

/// Makes the camera for a share of the transition from the own ship's eye point to the map's.
void travel(Camera& camera, const CameraInput& input, const design::ViewSettings& design) {
    const double turn = eased(input.map_share, 0, kTurned), rise = eased(input.map_share, kRiseBegins, 1);
    const double above_m = std::clamp(input.above_ground_m, kMinAboveGround_m, kMaxAboveGround_m);
    const double growth = geometric(1, map_distance_m(design) / above_m, rise), climb_m = above_m * (growth - 1);
    const glm::dvec3 seat = (1 - turn) * (camera.view.eye - earth::to_ecef(input.own_ship));
    earth::Geodetic place = input.own_ship;
    place.height.m += climb_m;
    camera.view.eye = earth::to_ecef(place) + seat;
    aim(camera.view, place, input.heading_rad + turn * earth::angle_difference(input.map_up_rad, input.heading_rad),
        input.pitch_rad + turn * (-0.5 * base::kPi - input.pitch_rad), (1 - turn) * earth::angle_difference(input.roll_rad, 0));
    const double map_focal_px = map_scale_px_per_m(design, input.width_px, input.height_px) * map_distance_m(design);
    camera.view.focal_px = geometric(camera.view.focal_px, map_focal_px, rise);
    if (input.map_share < 1)
        set_planes_on_the_way(camera.view, input.msl_m, climb_m, growth);
    else
        set_map_planes(camera.view, input.msl_m + climb_m, drop_at_corner_m(input, design));
    camera.haze_per_m *= (1 - rise) / growth;
    camera.height_weight = turn;
}

/// Half of the picture's height and of its diagonal, at the distance of the own ship.
struct Reach {
    double half_height_m = 0, half_diagonal_m = 0;
};
Reach reach_of(const CameraInput& input, const design::ViewSettings& design) {
    const double px_per_m = map_scale_px_per_m(design, input.width_px, input.height_px);
    return {0.5 * input.height_px / px_per_m, 0.5 * std::hypot(input.width_px, input.height_px) / px_per_m};
}

/// Sets the planes round what the picture can show between the lowest ground and the highest element. Of a picture's place v over
/// its middle what lies z below the own ship's level is (z + v cos(down)) / sin(down) behind the own ship.
void set_oblique_planes(terrain::View& view, const CameraInput& input, const design::ViewSettings& design, double distance_m) {
    const Reach reach = reach_of(input, design);
    const double sine = std::sin(design.look_down_rad), rise_m = reach.half_height_m * std::cos(design.look_down_rad);
    const double below_m = input.msl_m - kLowestGround_m + 2 * kMaxUndulation_m;
    const double above_m = kHighestElement_m - input.msl_m + 2 * kMaxUndulation_m;
    const double behind_m = (below_m + rise_m) / sine;
    const double farthest_m = std::hypot(behind_m, reach.half_diagonal_m);
    const double fallen_m = farthest_m * farthest_m / kRadius_m;  // twice the drop of a sphere
    const double rounding_m = 1e-6 * distance_m;
    view.near_m = distance_m - (std::fmax(above_m, 0) + rise_m) / sine - rounding_m;
    view.far_m = distance_m + behind_m + fallen_m / sine + rounding_m;
}

void move_far_away(Camera& camera, const CameraInput& input, const design::ViewSettings& design) {
    const double distance_m = oblique_distance_m(design);
    aim(camera.view, input.own_ship, input.map_up_rad + design.look_turn_rad, -design.look_down_rad, 0);
    camera.view.eye = earth::to_ecef(input.own_ship) - distance_m * camera.view.forward;
    camera.view.focal_px = map_scale_px_per_m(design, input.width_px, input.height_px) * distance_m;
    set_oblique_planes(camera.view, input, design, distance_m);
    camera.haze_per_m = 0;
    camera.height_weight = 1;
}

}  // namespace

double map_scale_px_per_m(const design::ViewSettings& design, std::uint32_t width_px, std::uint32_t height_px) noexcept {
    return 0.5 * std::min(width_px, height_px) / design.map_range_m;
}

Camera make_camera(const CameraInput& input, const design::ViewSettings& design, double haze_distance_m) noexcept {
    Camera camera;
    camera.view = perspective_view(input, design);
    camera.view.width = input.width_px;
    camera.view.height = input.height_px;
    camera.haze_per_m = haze_distance_m > 0 ? 1 / haze_distance_m : 0;
    if (input.map_share <= 0) return camera;
    design.mode == design::ViewMode::orthographic ? move_far_away(camera, input, design) : travel(camera, input, design);
    return camera;
}

}  // namespace tedavis::display
