#include "render_core/draw/data/place_ellipsoids.hpp"

#include "render_core/draw/data/layer_foci.hpp"
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

struct UnsurePlace {
    scene::ScenePoint point{};
    PlaceAccuracy accuracy;  ///< 0: unknown, also where nothing is known at this time
};

bool is_own(const ElementInput& input) { return input.element.own == design::OwnData::trail; }

/// Where the own ship is now: the end of its way.
UnsurePlace own_place(const ElementInput& input, std::uint32_t feature) {
    const scene::Run run = input.layer.points_of(feature);
    if (feature + 1 < input.layer.entry->feature_count || run.count == 0) return {};
    const std::uint32_t last = run.first + run.count - 1;
    return {input.layer.points[last], place_accuracy(input.layer, {feature, last})};
}

UnsurePlace place_of(const ElementInput& input, std::uint32_t feature) {
    if (is_own(input)) return own_place(input, feature);
    if (!is_traffic(input.layer)) {
        const scene::LayerEntry& entry = *input.layer.entry;
        return {input.layer.points[feature],
                {static_cast<double>(entry.position_accuracy_m), static_cast<double>(entry.height_accuracy_m)}};
    }
    const TrafficState state = traffic_state(input, feature);
    return {state.point, state.is_known ? state.accuracy : PlaceAccuracy{}};
}

}  // namespace

bool has_ellipsoids(const ElementInput& input) {
    if (input.element.uncertainty != design::ElementUncertainty::ellipsoid) return false;
    if (is_own(input)) return input.layer.entry->feature_count > 0;
    if (is_traffic(input.layer)) return states_accuracy(input.layer);
    const scene::LayerShape shape = input.layer.entry->shape;
    const bool has_places = shape == scene::LayerShape::points || shape == scene::LayerShape::meshes;
    return has_places && input.layer.entry->position_accuracy_m > 0;
}

std::uint32_t add_place_ellipsoids(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    if (!has_ellipsoids(input)) return 0;
    SolidLook look = look_of(input);
    look.opacity *= kOpacity * static_cast<float>(input.element.uncertainty_strength);
    look.is_mixed = true;
    look.is_thing = look.has_grid = false;
    look.is_hollow = is_own(input);  // it is not visible from inside
    batch.set_look(look, input.layer.entry->data_time_ns);
    std::uint32_t count = 0;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        if (look_of_feature(input, feature).is_hidden) continue;
        const UnsurePlace unsure = place_of(input, feature);
        const double level_m = unsure.accuracy.level_m, height_m = unsure.accuracy.height_m;
        const Placed at = placed(input, unsure.point);
        if (!(level_m > 0) || !at.is_known) continue;
        mesh.begin(at.place);
        mesh.set_color(encoded_color(input, input.element.by_color, feature), encoded_uncertainty(input, feature));
        add_ellipsoid(mesh, at.place, local_axes(unsure.point.latitude_rad, unsure.point.longitude_rad), level_m,
                      height_m > 0 ? height_m : level_m);
        if (mesh.add_to(batch)) ++count;
    }
    return count;
}

}  // namespace tedavis::draw
