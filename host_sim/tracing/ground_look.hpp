/// Light and colours of traced pictures: the sun, the sky, and the ground by its height.
#pragma once

#include <optional>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "host_sim/tracing/traced_data.hpp"
#include "render_core/raytrace/picture/trace_look.hpp"

namespace tedavis::host_sim {

struct SunChoice {
    glm::dvec3 towards{0, 0, 1};  ///< of unit length
    bool is_too_low = false;      ///< the sun is too low at that time, so `towards` is the default direction
};

/// Returns the direction to the sun at the pose, along increasing columns (east), increasing rows (south) and up. Without a time,
/// and where the sun is lower than 3 degrees, it is the default: north-west, 45 degrees high, as in shaded relief of maps.
[[nodiscard]] SunChoice sun_at(const AircraftPose& pose, const std::optional<base::Time>& time);

class GroundLook {
public:
    /// `data`, if any, colours the ground where settings have data; borrowed.
    GroundLook(const TracedGround& ground, const SunChoice& sun, const TracedData* data = nullptr);
    GroundLook(const GroundLook&) = delete;
    GroundLook& operator=(const GroundLook&) = delete;
    [[nodiscard]] const raytrace::TraceLook& look() const { return look_; }

private:
    std::vector<glm::vec3> palette_;
    raytrace::TraceLook look_;
};

}  // namespace tedavis::host_sim
