#include "render_core/display/planner/obstacle_places.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/billboard_place.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {
namespace {

/// An obstacle ahead, before its place in the picture is known.
struct MetObstacle {
    const scene::Layer* layer = nullptr;
    std::uint32_t feature = 0;
    double ahead_s = 0;
};
using MetObstacles = base::FixedVector<MetObstacle, kMaxObstaclePlaces>;

/// Keeps the obstacles that are reached first, in their order.
void keep_soonest(MetObstacles& all, const MetObstacle& met) {
    if (all.full()) {
        if (!(met.ahead_s < all.back().ahead_s)) return;
        all.pop_back();
    }
    static_cast<void>(all.try_push_back(met));
    for (std::size_t n = all.size() - 1; n > 0 && all[n].ahead_s < all[n - 1].ahead_s; --n) std::swap(all[n], all[n - 1]);
}

MetObstacles met_obstacles(const ObstacleFrame& frame, policy::HazardWatch& watch) {
    MetObstacles all;
    for (const scene::Layer& layer : frame.scene.layers()) {
        const scene::LayerEntry& entry = *layer.entry;
        if (entry.role != scene::LayerRole::obstacle || entry.shape == scene::LayerShape::grid || !is_valid_at(layer, frame.time))
            continue;
        for (std::uint32_t feature = 0; feature < entry.feature_count; ++feature)
            if (const double ahead_s = watch.seconds_to(layer, feature); std::isfinite(ahead_s))
                keep_soonest(all, {&layer, feature, ahead_s});
    }
    return all;
}

/// With shapes of its own, which stand whatever becomes of the signs.
bool has_solids(const ElementReports& reports, const scene::Layer& layer) {
    return std::any_of(reports.begin(), reports.end(), [&layer](const ElementReport& report) {
        return report.layer == &layer && report.state == ElementState::shown &&
               !is_billboard_technique(report.element->technique) && report.count.drawn + report.count.aggregated > 0;
    });
}

class PlaceFinder {
public:
    PlaceFinder(const ObstacleFrame& frame, const MetObstacle& met) : frame_(frame), met_(met) {}

    [[nodiscard]] ObstaclePlace find() {
        ObstaclePlace place;
        const scene::Layer& layer = *met_.layer;
        const std::string_view name = layer.name_of(met_.feature);
        place.name = base::FixedString<31>(name.empty() ? std::string_view(layer.entry->name) : name);
        place.feature = met_.feature;
        place.ahead_s = met_.ahead_s;
        if (const draw::Rect* const room = frame_.labels.obstacle_room(layer, met_.feature)) {
            place.state = ObstacleState::drawn;
            place.box = *room;
        } else {
            place.state = find_solid(place.box);
        }
        return place;
    }

private:
    [[nodiscard]] ObstacleState find_solid(draw::Rect& box) const {
        const scene::Layer& layer = *met_.layer;
        const design::DataElement plain;
        const draw::ElementInput input{plain, 0, layer, frame_.ground, {}, frame_.time.utc.ns, frame_.time.is_date};
        scene::ScenePoint anchor;
        if (!draw::anchor_of(input, met_.feature, anchor)) return ObstacleState::out_of_view;
        const draw::Placed top = draw::place_of(input, met_.feature, anchor);
        const draw::SignSpot spot = frame_.eye.spot(top.place);
        const terrain::View& view = frame_.eye.view;
        const draw::Rect screen{0, 0, static_cast<float>(view.width), static_cast<float>(view.height)};
        if (!top.is_known || !spot.is_ahead || !screen.contains(spot.at)) return ObstacleState::out_of_view;
        if (is_hidden(top.place, spot.distance_m)) return ObstacleState::hidden;
        box = box_below(spot.at, anchor);
        return has_solids(frame_.reports, layer) ? ObstacleState::drawn : ObstacleState::left_out;
    }

    /// As signs are judged: by a place as high over it as their stem (billboard_sheet.hpp).
    [[nodiscard]] bool is_hidden(const glm::dvec3& top, double distance_m) const {
        const double stem_m = static_cast<double>(draw::kSignStem * frame_.eye.text_px) * distance_m / frame_.eye.view.focal_px;
        return frame_.sight != nullptr && frame_.sight->is_hidden(top + glm::normalize(top) * stem_m);
    }

    [[nodiscard]] draw::Rect box_below(draw::Point top, const scene::ScenePoint& anchor) const {
        const double ground_m = frame_.ground.height_m(anchor.latitude_rad, anchor.longitude_rad);
        const float half = 0.5f * frame_.eye.text_px;
        draw::Rect box{top.x - half, top.y, 2 * half, 2 * half};
        if (!std::isfinite(ground_m)) return box;
        const draw::SignSpot foot = frame_.eye.spot(earth::to_ecef({anchor.latitude_rad, anchor.longitude_rad, {ground_m}}));
        if (foot.is_ahead) box.height = std::max(box.height, foot.at.y - top.y);
        return box;
    }

    const ObstacleFrame& frame_;
    const MetObstacle& met_;
};

}  // namespace

ObstaclePlaces obstacle_places(const ObstacleFrame& frame, policy::HazardWatch& watch) {
    ObstaclePlaces places;
    for (const MetObstacle& met : met_obstacles(frame, watch))
        static_cast<void>(places.try_push_back(PlaceFinder(frame, met).find()));
    return places;
}

}  // namespace tedavis::display
