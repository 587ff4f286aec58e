#include "host_sim/tracing/ground_look.hpp"

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/sun_position.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kMinElevation_rad = 3 * base::kRadiansPerDegree;
constexpr double kAzimuth_rad = 315 * base::kRadiansPerDegree, kElevation_rad = 45 * base::kRadiansPerDegree;

glm::dvec3 towards(double azimuth_rad, double elevation_rad) {
    return {std::sin(azimuth_rad) * std::cos(elevation_rad), -std::cos(azimuth_rad) * std::cos(elevation_rad),
            std::sin(elevation_rad)};
}

/// Of linear sRGB (IEC 61966-2-1).
float luminance(const glm::vec3& light) { return 0.2126f * light.x + 0.7152f * light.y + 0.0722f * light.z; }

}  // namespace

SunChoice sun_at(const AircraftPose& pose, const std::optional<base::Time>& time) {
    const SunChoice fixed{towards(kAzimuth_rad, kElevation_rad), time.has_value()};
    if (!time) return fixed;
    const earth::SunPosition sun = earth::sun_position((*time - base::Time{0}).to_seconds(), base::radians(pose.latitude_deg),
                                                       base::radians(pose.longitude_deg));
    if (sun.elevation_rad < kMinElevation_rad) return fixed;
    return {towards(sun.azimuth_rad, sun.elevation_rad), false};
}

GroundLook::GroundLook(const TracedGround& ground, const SunChoice& sun, const TracedData* data)
    : palette_{
          {0.08f, 0.22f, 0.07f}, {0.22f, 0.32f, 0.10f}, {0.42f, 0.34f, 0.18f}, {0.45f, 0.40f, 0.36f}, {0.85f, 0.86f, 0.90f}} {
    look_.sun = {sun.towards, {0.95f, 0.90f, 0.80f}};
    look_.sky = {0.22f, 0.27f, 0.36f};
    look_.background = {0.42f, 0.58f, 0.80f};
    look_.material.gloss = 0.05f;
    look_.material.sharpness = 24;
    const double step_m = ground.space().step_m(), lowest = ground.lowest_m() / step_m, highest = ground.highest_m() / step_m;
    look_.ground = {palette_, static_cast<float>(lowest), static_cast<float>(highest > lowest ? highest : lowest + 1)};
    if (data == nullptr) return;
    data->show(look_);
    for (glm::vec3& color : palette_) color = glm::vec3(luminance(color));  // no hue of the ground is taken for a value
}

}  // namespace tedavis::host_sim
