#include "host_sim/sweep/place_in_picture.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {

PlaceInPicture place_in_picture(const terrain::View& view, const earth::Ecef& place, double radius_m) {
    const glm::dvec3 way = place - view.eye;
    const double ahead_m = glm::dot(way, view.forward);
    if (!(ahead_m > view.near_m)) return {};
    const double x_px = 0.5 * view.width + view.focal_px * glm::dot(way, view.right) / ahead_m;
    const double y_px = 0.5 * view.height + view.focal_px * glm::dot(way, view.down) / ahead_m;
    if (x_px < 0 || y_px < 0 || x_px >= view.width || y_px >= view.height) return {};
    return {true, x_px, y_px, std::max(view.focal_px * radius_m / ahead_m, PlaceInPicture::kMinRadius_px)};
}

PlaceSaliency place_saliency(const FloatMap& map, const PlaceInPicture& place) {
    double all = 0, inside = 0, pixels = 0;
    float strongest = 0;
    for (std::uint32_t y = 0; y < map.height; ++y)
        for (std::uint32_t x = 0; x < map.width; ++x) {
            const float value = map.at(x, y);
            all += static_cast<double>(value);
            if (std::hypot(x + 0.5 - place.x_px, y + 0.5 - place.y_px) > place.radius_px) continue;
            inside += static_cast<double>(value);
            strongest = std::max(strongest, value);
            pixels += 1;
        }
    const auto less = std::count_if(map.values.begin(), map.values.end(), [&](float value) { return value < strongest; });
    const auto count = static_cast<double>(map.values.size());
    return {all > 0 ? inside / all : 0, pixels / count, static_cast<double>(less) / count};
}

}  // namespace tedavis::host_sim
