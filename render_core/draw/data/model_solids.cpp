#include "render_core/draw/data/model_solids.hpp"

#include <cmath>
#include <glm/mat3x3.hpp>

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"

namespace tedavis::draw {
namespace {

constexpr double kNormal = 127;

/// Columns right, ahead and up of a feature's model in ECEF.
glm::dmat3 axes_of(const ElementInput& input, std::uint32_t feature) {
    const scene::ScenePoint& point = input.layer.points[feature];
    const LocalAxes local = local_axes(point.latitude_rad, point.longitude_rad);
    const double stated = value_or_nan(input.layer, "heading", feature), heading = std::isfinite(stated) ? stated : 0;
    const double c = std::cos(heading), s = std::sin(heading);
    return {local.east * c - local.north * s, local.east * s + local.north * c, local.up};
}

bool build(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature) {
    const scene::Layer& layer = input.layer;
    const Placed at = placed(input, layer.points[feature]);
    if (!at.is_known || layer.vertices.empty() || layer.vertices.size() > SolidMesh::kVertices) return false;
    const glm::dmat3 axes = axes_of(input, feature);
    const double stated = value_or_nan(layer, "scale", feature), scale = stated > 0 ? stated : 1;
    const bool has_own_color = !input.element.by_color.is_used();
    const design::Color color = encoded_color(input, input.element.by_color, feature);
    const scene::Uncertainty unsure = encoded_uncertainty(input, feature);
    mesh.begin(at.place);
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
        const bool is_drawn = build(mesh, input, feature) && mesh.add_to(batch);
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

}  // namespace tedavis::draw
