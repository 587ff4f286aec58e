#include "render_core/draw/data/cell_motion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/draw/data/solid_shapes.hpp"

namespace tedavis::draw {
namespace {

constexpr design::Color kRim{16, 16, 20, 255};
constexpr int kLineSides = 3, kPartsPerBarb = 2;
constexpr double kRounding = 1 + 1e-9;
constexpr double kThread_m = 0.5;  // the rim gives the line its width

/// The way of a cell's front over the ground.
class MotionWay {
public:
    MotionWay(const ElementInput& input, const CellFront& from)
        : input_(input),
          from_(from),
          along_(std::sin(from.toward_rad), std::cos(from.toward_rad)),
          metres_(std::cos(from.latitude_rad) * earth::prime_vertical_radius_m(from.latitude_rad),
                  earth::meridian_radius_m(from.latitude_rad)) {}

    /// ECEF, with so much to the right of the way.
    [[nodiscard]] glm::dvec3 at(double ahead_m, double right_m = 0) const {
        const glm::dvec2 moved = along_ * ahead_m + glm::dvec2(along_.y, -along_.x) * right_m;
        const double latitude = from_.latitude_rad + moved.y / metres_.y, longitude = from_.longitude_rad + moved.x / metres_.x;
        const double ground_m = input_.ground.height_m(latitude, longitude);
        const double height_m = std::isfinite(ground_m) ? std::max(from_.base_m, ground_m + kMotionOverGround_m) : from_.base_m;
        return earth::to_ecef({latitude, longitude, {height_m}});
    }

private:
    const ElementInput& input_;
    const CellFront& from_;
    glm::dvec2 along_, metres_;
};

void build_line(SolidMesh& mesh, const MotionWay& way, double length_m, double barb_every_m, double barb_m) {
    const glm::dvec3 begin = way.at(0), up = glm::normalize(begin);
    const auto thread = [&](const glm::dvec3& from, const glm::dvec3& to) {
        add_frustum(mesh, from, to, kThread_m, kThread_m, kLineSides, up);
    };
    mesh.begin(begin);
    glm::dvec3 before = begin;
    const double part_m = barb_every_m / kPartsPerBarb;
    const int parts = static_cast<int>(std::ceil(length_m / part_m));
    for (int n = 1; n <= parts; ++n) {
        const double ahead_m = std::min(n * part_m, length_m);
        const glm::dvec3 next = way.at(ahead_m);
        thread(before, next);
        before = next;
        if (n % kPartsPerBarb != 0 || n * part_m > length_m * kRounding) continue;
        for (const double side : {-1.0, 1.0}) thread(next, way.at(ahead_m - barb_m, side * barb_m));
    }
}

}  // namespace

bool has_motion(const ElementInput& input, std::uint32_t feature) {
    return scene::value_or_nan(input.layer, "speed", feature) >= kMinMotion_mps &&
           std::isfinite(scene::value_or_nan(input.layer, "toward", feature));
}

/// By the law of sines, in the triangle of eye, front and the line's end.
double motion_line_m(const ElementInput& input, const CellFront& from, double speed_mps) {
    const double whole_m = speed_mps * kMotionAhead_s;
    const glm::dvec3 front = earth::to_ecef({from.latitude_rad, from.longitude_rad, {from.base_m}});
    const glm::dvec3 to_eye = input.eye - front;
    const double distance_m = glm::length(to_eye);
    if (!(distance_m > 0)) return whole_m;
    const LocalAxes axes = local_axes(from.latitude_rad, from.longitude_rad);
    const glm::dvec3 way = axes.east * std::sin(from.toward_rad) + axes.north * std::cos(from.toward_rad);
    const double at_front = std::acos(std::clamp(glm::dot(to_eye, way) / distance_m, -1.0, 1.0));
    if (at_front + from.seen_rad >= base::kPi) return whole_m;
    return std::min(whole_m, distance_m * std::sin(from.seen_rad) / std::sin(at_front + from.seen_rad));
}

LastBarb last_barb(const ElementInput& input, std::uint32_t feature, const CellFront& from) {
    if (!from.is_known) return {};
    const double speed_mps = scene::value_or_nan(input.layer, "speed", feature);
    const double barbs = std::floor(motion_line_m(input, from, speed_mps) * kRounding / (speed_mps * kBarbEvery_s));
    const double after_s = barbs * kBarbEvery_s;
    return {MotionWay(input, from).at(after_s * speed_mps), after_s};
}

void add_motion_line(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature,
                     const CellFront& from) {
    if (!from.is_known) return;
    const double speed_mps = scene::value_or_nan(input.layer, "speed", feature);
    const double length_m = motion_line_m(input, from, speed_mps);
    const MotionWay way(input, from);
    design::Color color = encoded_color(input, input.element.by_color, feature);
    color.alpha = 255;
    SolidLook look;
    look.group = input.group;
    look.is_thing = false;
    for (const bool is_rim : {false, true}) {
        look.halo_px = 0.5f * kMotionLine_px + (is_rim ? kMotionRim_px : 0);
        batch.set_look(look, input.layer.entry->data_time_ns);
        mesh.set_color(is_rim ? kRim : color);
        build_line(mesh, way, length_m, speed_mps * kBarbEvery_s, kBarbShare * from.width_m);
        if (!mesh.add_to(batch)) return;
    }
}

}  // namespace tedavis::draw
