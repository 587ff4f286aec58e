#include "host_sim/replay/scene_findings.hpp"

#include "host_sim/scene_builder/open_scene.hpp"

namespace tedavis::host_sim {

constexpr double kInReach_deg = 2;  // some 200 km: farther away nothing is seen

GeoExtent extent_of_scene(const std::string& path) { return path.empty() ? GeoExtent() : extent_of(OpenScene(path).scene()); }

Findings scene_findings(const std::string& scene, const GeoExtent& extent, const GeoExtent& flown) {
    if (scene.empty() || !are_apart(extent, flown, kInReach_deg)) return {};
    return {
        {"scene.elsewhere",
         "none of the data of " + scene + " lie near the flight: they cover " + extent.words() + ", the flight " + flown.words(),
         1}};
}

}  // namespace tedavis::host_sim
