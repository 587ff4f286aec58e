#include "render_core/draw/data/cell_motion.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/draw/data/solid_shapes.hpp"

namespace tedavis::draw {
namespace {

constexpr design::Color kRim{16, 16, 20, 255};
constexpr float kCellRim_px = 1.5f;
constexpr int kArrowSides = 8;
constexpr double kHead = 0.35, kHeadRadius = 0.12, kShaftRadius = 0.045;  // of the length
constexpr double kWidest_m = 6000;                                        // what is longer is no thicker

void build_arrow(SolidMesh& mesh, const CellFront& from, double length_m, design::Color color) {
    const LocalAxes axes = local_axes(from.place);
    const glm::dvec3 way = axes.east * std::sin(from.toward_rad) + axes.north * std::cos(from.toward_rad);
    const double thick_m = std::min(length_m, kWidest_m);
    const glm::dvec3 neck = from.place + way * (length_m - kHead * thick_m);
    mesh.begin(from.place);
    mesh.set_color(color);
    add_frustum(mesh, from.place, neck, kShaftRadius * thick_m, kShaftRadius * thick_m, kArrowSides, axes.up);
    add_frustum(mesh, neck, from.place + way * length_m, kHeadRadius * thick_m, 0, kArrowSides, axes.up);
}

}  // namespace

bool has_motion(const ElementInput& input, std::uint32_t feature) {
    return scene::value_or_nan(input.layer, "speed", feature) >= kMinMotion_mps &&
           std::isfinite(scene::value_or_nan(input.layer, "toward", feature));
}

void add_motion_arrow(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature,
                      const CellFront& from) {
    if (!from.is_known) return;
    const double length_m = scene::value_or_nan(input.layer, "speed", feature) * kMotionAhead_s;
    SolidLook look;
    look.group = input.group;
    look.is_thing = false;
    batch.set_look(look, input.layer.entry->data_time_ns);
    design::Color color = encoded_color(input, input.element.by_color, feature);
    color.alpha = 255;
    build_arrow(mesh, from, length_m, color);
    if (!mesh.add_to(batch)) return;
    look.halo_px = kCellRim_px;
    batch.set_look(look, input.layer.entry->data_time_ns);
    build_arrow(mesh, from, length_m, kRim);
    static_cast<void>(mesh.add_to(batch));
}

}  // namespace tedavis::draw
