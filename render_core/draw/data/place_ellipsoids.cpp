#include "render_core/draw/data/place_ellipsoids.hpp"

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/draw/data/solid_shapes.hpp"
#include "render_core/draw/data/traffic_state.hpp"

namespace tedavis::draw {
namespace {

constexpr float kOpacity = 0.3f;  // of the element's, at full strength

bool is_traffic(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::traffic && layer.entry->shape == scene::LayerShape::lines;
}

/// False where nothing is known of it now.
bool place_of(const ElementInput& input, std::uint32_t feature, scene::ScenePoint& point) {
    if (!is_traffic(input.layer)) {
        point = input.layer.points[feature];
        return true;
    }
    const TrafficState state = traffic_state(input, feature);
    point = state.point;
    return state.is_known;
}

}  // namespace

bool has_ellipsoids(const ElementInput& input) {
    const scene::LayerShape shape = input.layer.entry->shape;
    const bool has_places = shape == scene::LayerShape::points || shape == scene::LayerShape::meshes || is_traffic(input.layer);
    return has_places && input.element.uncertainty == design::ElementUncertainty::ellipsoid &&
           input.layer.entry->position_accuracy_m > 0;
}

std::uint32_t add_place_ellipsoids(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    if (!has_ellipsoids(input)) return 0;
    const auto level_m = static_cast<double>(input.layer.entry->position_accuracy_m);
    const auto stated_m = static_cast<double>(input.layer.entry->height_accuracy_m);
    SolidLook look = look_of(input);
    look.opacity *= kOpacity * static_cast<float>(input.element.uncertainty_strength);
    look.is_mixed = true;
    batch.set_look(look, input.layer.entry->data_time_ns);
    std::uint32_t count = 0;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        scene::ScenePoint point;
        if (!place_of(input, feature, point)) continue;
        const Placed at = placed(input, point);
        if (!at.is_known) continue;
        mesh.begin(at.place);
        mesh.set_color(encoded_color(input, input.element.by_color, feature), encoded_uncertainty(input, feature));
        add_ellipsoid(mesh, at.place, local_axes(point.latitude_rad, point.longitude_rad), level_m,
                      stated_m > 0 ? stated_m : level_m);
        if (mesh.add_to(batch)) ++count;
    }
    return count;
}

}  // namespace tedavis::draw
