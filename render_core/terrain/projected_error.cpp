#include "render_core/terrain/projected_error.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <limits>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::terrain {
namespace {

struct Box {
    glm::dvec3 centre;   ///< relative to the eye
    glm::dvec3 axis[3];  ///< north, east, down
    double half[3];
};

glm::dvec3 centre_of(const ChunkEntry& entry) { return {entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]}; }

/// Its points move up by as much as they are below that height.
void flatten(Box& box, const ChunkEntry& entry, double flat_msl_m) {
    const double least_m = flat_msl_m - double{entry.max_height_m}, most_m = flat_msl_m - double{entry.min_height_m};
    box.centre -= box.axis[2] * (0.5 * (least_m + most_m));
    box.half[2] += 0.5 * (most_m - least_m);
}

double radius_m(const ChunkEntry& entry) {
    return std::hypot(double{entry.half_extent_m[0]}, double{entry.half_extent_m[1]}, double{entry.half_extent_m[2]});
}

/// By what its points can move: along a plane that leans with the chunk's distance from the middle.
void move(Box& box, const ChunkEntry& entry, const earth::Magnifiers& magnifiers) {
    for (const earth::Magnifier& magnifier : magnifiers) {
        if (!magnifier.reaches(centre_of(entry), radius_m(entry))) continue;
        box.half[0] += magnifier.farthest_move_m();
        box.half[1] += magnifier.farthest_move_m();
        box.half[2] += magnifier.farthest_move_m() * (magnifier.reach_m() + 2 * radius_m(entry)) / earth::kMinCurvatureRadius_m;
    }
}

/// Stretched upwards by lift_m.
Box box_of(const ChunkEntry& entry, const View& view, double lift_m) {
    Box box;
    box.centre = centre_of(entry) - view.eye;
    for (int a = 0; a < 3; ++a) {
        box.axis[a] = glm::dvec3(entry.axes[3 * a], entry.axes[3 * a + 1], entry.axes[3 * a + 2]);
        box.half[a] = double{entry.half_extent_m[a]};
    }
    box.centre -= box.axis[2] * (0.5 * lift_m);
    box.half[2] += 0.5 * lift_m;
    if (view.is_flat()) flatten(box, entry, view.flat_msl_m);
    move(box, entry, view.magnifiers);
    return box;
}

double reach_along(const Box& box, const glm::dvec3& direction) {
    double reach = 0;
    for (int a = 0; a < 3; ++a) reach += box.half[a] * std::abs(glm::dot(box.axis[a], direction));
    return reach;
}

double distance_to(const Box& box) {
    double squared = 0;
    for (int a = 0; a < 3; ++a) {
        const double outside = std::abs(glm::dot(box.centre, box.axis[a])) - box.half[a];
        if (outside > 0) squared += outside * outside;
    }
    return std::sqrt(squared);
}

/// No point of the box that lies ahead has side >= -tangent * depth. A wider view holds all that a narrower one holds: where the
/// box reaches behind the eye, some wider view may show it sooner, and the answer is that of the widest which does. The greatest
/// side + tangent * depth over the box is convex in the tangent, with a bend for each axis.
bool is_beyond(const Box& box, const glm::dvec3& forward, const glm::dvec3& side, double tangent) {
    double along[3], across[3];
    for (int a = 0; a < 3; ++a) {
        along[a] = box.half[a] * glm::dot(box.axis[a], forward);
        across[a] = box.half[a] * glm::dot(box.axis[a], side);
    }
    const double depth = glm::dot(box.centre, forward), beside = glm::dot(box.centre, side);
    const auto greatest = [&](double t) {
        double sum = depth * t + beside;
        for (int a = 0; a < 3; ++a) sum += std::abs(along[a] * t + across[a]);
        return sum;
    };
    if (greatest(tangent) < 0) return true;
    double slope = depth;
    for (int a = 0; a < 3; ++a) slope += along[a] * tangent + across[a] < 0 ? -along[a] : along[a];
    if (slope >= 0) return false;
    for (int a = 0; a < 3; ++a)
        if (const double bend = -across[a] / along[a]; bend > tangent && greatest(bend) < 0) return true;
    return false;
}

}  // namespace

bool is_outside_view(const ChunkEntry& entry, const View& view, double lift_m) {
    const Box box = box_of(entry, view, lift_m);
    const double depth = glm::dot(box.centre, view.forward);
    if (depth + reach_along(box, view.forward) < view.near_m) return true;
    const double tangents[2] = {view.half_width_tangent(), view.half_height_tangent()};
    const glm::dvec3 sides[2] = {view.right, view.down};
    for (int a = 0; a < 2; ++a)
        for (const double sign : {-1.0, 1.0})
            if (is_beyond(box, view.forward, sides[a] * sign, tangents[a])) return true;
    return false;
}

earth::GroundExtent extent_of(const ChunkEntry& entry, double lift_m) {
    constexpr double kBoxSlack_m = 1;  // boxes are kept in floats
    earth::GroundExtent extent;
    extent.centre = centre_of(entry);
    for (int n = 0; n < 3; ++n)
        extent.half[n] =
            double{entry.half_extent_m[n]} * glm::dvec3(entry.axes[3 * n], entry.axes[3 * n + 1], entry.axes[3 * n + 2]);
    extent.more_m = kBoxSlack_m + lift_m;
    return extent;
}

std::uint32_t draws_of(const ChunkEntry& entry, const View& view, double lift_m) {
    return view.magnifiers.empty() ? 1 : earth::count_parts(view.magnifiers, extent_of(entry, lift_m));
}

double magnification(const ChunkEntry& entry, const View& view) {
    double most = 1;
    for (const earth::Magnifier& magnifier : view.magnifiers)
        if (magnifier.reaches(centre_of(entry), radius_m(entry))) most = std::fmax(most, magnifier.factor());
    return most;
}

double error_in_box_px(const ChunkEntry& entry, const View& view, double error_m, double lift_m) {
    if (error_m == 0) return 0;
    const Box box = box_of(entry, view, lift_m);
    const double tx = view.half_width_tangent(), ty = view.half_height_tangent();
    const double off_axis = std::sqrt(tx * tx + ty * ty);
    // The vertical at any place of the box, as parts along and across the view.
    const double turn = (box.half[0] + box.half[1]) / earth::kMinCurvatureRadius_m;
    const double at_centre = std::abs(glm::dot(box.axis[2], view.forward));
    const double along = std::fmin(at_centre + turn, 1.0), least_along = std::fmax(at_centre - turn, 0.0);
    const double across = std::sqrt(std::fmax(1 - least_along * least_along, 0.0));
    // The drawn point is in the picture and the true one no farther from it than the error; nothing is drawn nearer than the
    // near plane.
    const double by_box = glm::dot(box.centre, view.forward) - reach_along(box, view.forward);
    const double by_distance = distance_to(box) / std::sqrt(1 + off_axis * off_axis) - error_m * along;
    if (std::isnan(by_box) || std::isnan(by_distance)) return std::numeric_limits<double>::infinity();
    const double depth = std::fmax(std::fmax(by_box, by_distance), view.near_m);
    const double error_px = error_m * view.focal_px * (across + off_axis * along) / depth;
    if (std::isnan(error_px)) return std::numeric_limits<double>::infinity();
    // A large box round the eye says little, and the ground itself says more.
    return std::fmin(error_px, view.ground.px(error_m));
}

double highest_tangent(const ChunkEntry& entry, const View& view, const glm::dvec2& up, double lift_m) {
    const Box box = box_of(entry, view, lift_m);
    const glm::dvec3 up_axis = view.right * up.x + view.down * up.y;
    const glm::dvec2 middle(glm::dot(box.centre, view.forward), glm::dot(box.centre, up_axis));
    glm::dvec2 along[3], corners[8];  // depth, height over the axis
    for (int a = 0; a < 3; ++a)
        along[a] = box.half[a] * glm::dvec2(glm::dot(box.axis[a], view.forward), glm::dot(box.axis[a], up_axis));
    for (unsigned n = 0; n < 8; ++n) {
        corners[n] = middle;
        for (unsigned a = 0; a < 3; ++a) corners[n] += (n >> a & 1u) != 0 ? along[a] : -along[a];
    }
    double highest = -std::numeric_limits<double>::infinity();
    for (unsigned n = 0; n < 8; ++n) {
        const glm::dvec2& from = corners[n];
        if (!(from.x < view.near_m)) {
            highest = std::fmax(highest, from.y / from.x);
            continue;
        }
        for (unsigned a = 0; a < 3; ++a)  // where its edges pierce the near plane
            if (const glm::dvec2& to = corners[n ^ (1u << a)]; to.x >= view.near_m)
                highest = std::fmax(highest, glm::mix(from.y, to.y, (view.near_m - from.x) / (to.x - from.x)) / view.near_m);
    }
    const double sum = middle.x + middle.y + along[0].x + along[0].y + along[1].x + along[1].y + along[2].x + along[2].y;
    return std::isfinite(sum) ? highest : std::numeric_limits<double>::infinity();
}

DepthSpan depth_span(const ChunkEntry& entry, const View& view, double lift_m) {
    const Box box = box_of(entry, view, 0);
    const double depth = glm::dot(box.centre, view.forward), reach = reach_along(box, view.forward) + lift_m;
    return {depth - reach, depth + reach};
}

float distance_m(const ChunkEntry& entry, const View& view) {
    return static_cast<float>(glm::length(centre_of(entry) - view.eye));
}

double box_distance_m(const ChunkEntry& entry, const View& view) { return distance_to(box_of(entry, view, 0)); }

}  // namespace tedavis::terrain
