#include "render_core/draw/data/model_solids.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/obstacle_solids.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"

namespace tedavis::draw {
namespace {

constexpr double kNormal = 127;

/// Columns right, ahead and up of a feature's model in ECEF.
glm::dmat3 axes_of(const ElementInput& input, std::uint32_t feature) {
    const scene::ScenePoint& point = input.layer.points[feature];
    const LocalAxes local = local_axes(point.latitude_rad, point.longitude_rad);
    const double stated = scene::value_or_nan(input.layer, "heading", feature), heading = std::isfinite(stated) ? stated : 0;
    const double c = std::cos(heading), s = std::sin(heading);
    return {local.east * c - local.north * s, local.east * s + local.north * c, local.up};
}

/// Along the model's own axes, its colour the mean of those of the vertices.
struct ModelBox {
    glm::dvec3 low, high;
    design::Color color;
};
ModelBox model_box(const scene::Layer& layer) {
    ModelBox box{glm::dvec3(1e9), glm::dvec3(-1e9), {}};
    std::uint64_t sums[4]{};
    for (const scene::ModelVertex& vertex : layer.vertices) {
        const glm::dvec3 place(vertex.place_m[0], vertex.place_m[1], vertex.place_m[2]);
        box.low = glm::min(box.low, place);
        box.high = glm::max(box.high, place);
        for (std::size_t n = 0; n < 4; ++n) sums[n] += vertex.color[n];
    }
    const auto mean = [&](std::size_t n) { return static_cast<std::uint8_t>(sums[n] / layer.vertices.size()); };
    box.color = {mean(0), mean(1), mean(2), mean(3)};
    return box;
}

/// What the model's own shape has of its place in space.
struct ModelStand {
    glm::dvec3 place;
    glm::dmat3 axes;  ///< with the scale
};

/// A box that contains the model.
void build_box(SolidMesh& mesh, const ModelBox& box, const ModelStand& stand) {
    const auto corner = [&](int x, int y, int z) {
        return stand.place + stand.axes * glm::dvec3(x > 0 ? box.high.x : box.low.x, y > 0 ? box.high.y : box.low.y,
                                                     z > 0 ? box.high.z : box.low.z);
    };
    mesh.quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
    mesh.quad(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1));
    mesh.quad(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
    mesh.quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
    mesh.quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    mesh.quad(corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0), corner(0, 0, 0));
}

bool build(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature) {
    const scene::Layer& layer = input.layer;
    const Placed at = placed(input, layer.points[feature]);
    if (!at.is_known || layer.vertices.empty() || layer.vertices.size() > SolidMesh::kVertices) return false;
    const glm::dmat3 axes = axes_of(input, feature);
    const double stated = scene::value_or_nan(layer, "scale", feature), scale = stated > 0 ? stated : 1;
    const bool has_own_color = !input.element.by_color.is_used();
    const design::Color color = encoded_color(input, input.element.by_color, feature);
    const scene::Uncertainty unsure = encoded_uncertainty(input, feature);
    mesh.begin(at.place);
    if (input.element.detail < kShapesFrom) {
        const ModelBox box = model_box(layer);
        mesh.set_color(has_own_color ? box.color : color, unsure);
        build_box(mesh, box, {at.place, axes * scale});
        return mesh.is_whole();
    }
    for (const scene::ModelVertex& vertex : layer.vertices) {
        const glm::dvec3 place(vertex.place_m[0], vertex.place_m[1], vertex.place_m[2]);
        const glm::dvec3 normal(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
        mesh.set_color(has_own_color ? design::Color{vertex.color[0], vertex.color[1], vertex.color[2], vertex.color[3]} : color,
                       unsure);
        static_cast<void>(mesh.vertex(at.place + axes * place * scale, axes * normal / kNormal));
    }
    for (std::size_t n = 0; n + 2 < layer.triangles.size(); n += 3)
        mesh.triangle(layer.triangles[n], layer.triangles[n + 1], layer.triangles[n + 2]);
    return mesh.is_whole();
}

}  // namespace

ElementCount add_models(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    batch.set_look(look_of(input), input.layer.entry->data_time_ns);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const bool is_drawn = !look_of_feature(input, feature).is_hidden && build(mesh, input, feature) && mesh.add_to(batch);
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

}  // namespace tedavis::draw
