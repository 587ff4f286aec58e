#include "render_core/scene/obstacle_stand.hpp"

#include <cmath>

#include "render_core/scene/feature_values.hpp"

namespace tedavis::scene {
namespace {

double over_ellipsoid_m(const Layer& layer, const ScenePoint& point, double ground_m, Ground& ground) {
    const auto height_m = static_cast<double>(point.height_m);
    switch (layer.entry->height_datum) {
        case HeightDatum::ground: return ground_m + height_m;
        case HeightDatum::msl: return height_m + ground.undulation_m(point.latitude_rad, point.longitude_rad);
        case HeightDatum::ellipsoid: break;
    }
    return height_m;
}

double positive_or(double value, double otherwise) { return value > 0 ? value : otherwise; }

/// Two standard deviations; an unknown uncertainty is as large as the largest that the attribute can state.
double height_uncertainty_m(const Layer& layer, std::uint32_t feature) {
    const Attribute* const height = layer.find("height");
    if (height == nullptr || feature >= height->values.size()) return 0;
    const double share = height->uncertainty(feature).level() * static_cast<double>(height->entry->uncertainty_full);
    switch (height->entry->uncertainty_kind) {
        case UncertaintyKind::standard_deviation: return 2 * share;
        case UncertaintyKind::interval: return share;
        case UncertaintyKind::percent: return std::fmax(share * static_cast<double>(height->values[feature]), 0);
        case UncertaintyKind::none:
        case UncertaintyKind::ordinal: break;
    }
    return 0;
}

}  // namespace

ObstacleStand obstacle_stand(const Layer& layer, const ScenePoint& point, double height_m, double unknown_m, Ground& ground) {
    ObstacleStand stand;
    const double ground_m = ground.height_m(point.latitude_rad, point.longitude_rad);
    const double usual_m = positive_or(height_m, unknown_m);
    stand.is_stated = height_m > 0 || !std::isnan(point.height_m);
    const double stated_m = std::isnan(point.height_m) ? std::nan("") : over_ellipsoid_m(layer, point, ground_m, ground);
    stand.top_m = std::isfinite(stated_m) ? stated_m : ground_m + usual_m;
    stand.foot_m = std::isfinite(ground_m) && ground_m < stand.top_m ? ground_m : stand.top_m - usual_m;
    return stand;
}

ObstacleAccuracy obstacle_accuracy(const Layer& layer, std::uint32_t feature) {
    const double whole_m =
        positive_or(value_or_nan(layer, "position", feature), static_cast<double>(layer.entry->position_accuracy_m));
    const double level_m = positive_or(value_or_nan(layer, "position_accuracy", feature), whole_m);
    const double height_m =
        positive_or(value_or_nan(layer, "height_accuracy", feature), static_cast<double>(layer.entry->height_accuracy_m));
    return {level_m, std::fmax(height_m, height_uncertainty_m(layer, feature))};
}

}  // namespace tedavis::scene
