#include "host_sim/scene_builder/feature_filter.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {

scene::LayerShape shape_of(scene::LayerRole role, const std::vector<SourceFeature>& features) {
    switch (role) {
        case scene::LayerRole::trajectory:
        case scene::LayerRole::traffic:
        case scene::LayerRole::ghost:
        case scene::LayerRole::road:
        case scene::LayerRole::river:
        case scene::LayerRole::runway: return scene::LayerShape::lines;
        case scene::LayerRole::no_go:
        case scene::LayerRole::airspace:
        case scene::LayerRole::storm_cell:
        case scene::LayerRole::land_cover:
        case scene::LayerRole::building: return scene::LayerShape::areas;
        default: break;
    }
    const bool has_points = std::any_of(features.begin(), features.end(),
                                        [](const SourceFeature& feature) { return feature.shape == scene::LayerShape::points; });
    return has_points || features.empty() ? scene::LayerShape::points : features[0].shape;
}

bool reaches(const SourceFeature& feature, const RegionRecipe& region) {
    if (feature.points.empty()) return false;
    const SourcePoint& first = feature.points[0];
    double south = first.latitude_deg, north = south, west = first.longitude_deg, east = west, longitude = west;
    for (const SourcePoint& point : feature.points) {
        longitude += std::remainder(point.longitude_deg - longitude, 360);
        west = std::min(west, longitude);
        east = std::max(east, longitude);
        south = std::min(south, point.latitude_deg);
        north = std::max(north, point.latitude_deg);
    }
    if (north < region.south_deg || south > region.north_deg) return false;
    const double width = region.east_deg - region.west_deg + (region.east_deg < region.west_deg ? 360 : 0);
    // The feature's west edge, 0..360 east of the region's, lies within it; or its east edge does once it is a turn farther west.
    const double offset = west - region.west_deg - 360 * std::floor((west - region.west_deg) / 360);
    return offset <= width || offset + (east - west) >= 360;
}

void keep_times(SourceFeature& feature, std::optional<std::int64_t> from_ns, std::optional<std::int64_t> until_ns) {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < feature.points.size(); ++n) {
        const std::optional<std::int64_t>& time = feature.points[n].time_ns;
        if (time && ((from_ns && *time < *from_ns) || (until_ns && *time > *until_ns))) continue;
        feature.points[kept] = feature.points[n];
        for (auto& [name, values] : feature.point_values) values[kept] = values[n];
        ++kept;
    }
    feature.points.resize(kept);
    for (auto& [name, values] : feature.point_values) values.resize(kept);
}

}  // namespace tedavis::host_sim
