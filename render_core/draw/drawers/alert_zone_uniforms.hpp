/// Sets the uniforms of shaders/alert_zone.frag. Thread  the GL thread; the program must be in use.
#pragma once

#include "render_core/draw/alert_zone_look.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

/// Uniforms of every program that is built with ALERT_ZONE.
inline constexpr std::size_t kAlertUniforms = 2;
inline constexpr const char* kAlertUniformNames[kAlertUniforms] = {"alert_axes", "alert_zone"};
inline constexpr std::size_t kAlertZoneRows = 6;

/// The rows of alert_zone:
///   speed (m/s), radius of the turn (m), 1 to the right or -1 to the left, seconds per radian of the turn (0: straight)
///   half width of the zone (m), its two rates (m/s, m/s^2), seconds until the zone ends (-1: nothing is coloured)
///   floor (m above MSL), its rate (m/s), seconds within which ground is a warning
///   runway: m ahead and to the right, radius (m), highest ground (m above MSL)
///   colour of warnings, and in the last row of cautions: red, green, blue, strength, 0..1
struct AlertZoneRows {
    float of[kAlertZoneRows][4]{};
};
[[nodiscard]] AlertZoneRows alert_zone_rows(const AlertZoneLook& look);

/// `first` is the index of kAlertUniformNames in the program's list; the program's positions are relative to `origin` (ECEF, m).
void set_alert_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const AlertZoneLook& look,
                        const glm::dvec3& origin);

}  // namespace tedavis::draw
