/// Sets what shaders/alert_zone.frag reads. Thread  the GL thread; the program must be in use.
#pragma once

#include "render_core/draw/alert_zone_look.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

/// Uniforms of every program that is built with ALERT_ZONE.
inline constexpr std::size_t kAlertUniforms = 2;
inline constexpr const char* kAlertUniformNames[kAlertUniforms] = {"alert_axes", "alert_zone"};
inline constexpr std::size_t kAlertZoneRows = 6;

/// The rows of alert_zone:
///   speed, radius of the turn (m), 1 to the right or -1 to the left, seconds a radian of it (0: straight)
///   width: radius, its two rates, seconds until the zone ends (-1: nothing is colored)
///   floor, its rate, seconds of a warning
///   runway: ahead and to the right, radius, highest ground
///   colors of warning and of caution, with their strength
struct AlertZoneRows {
    float of[kAlertZoneRows][4]{};
};
[[nodiscard]] AlertZoneRows alert_zone_rows(const AlertZoneLook& look);

/// `first` is the place of kAlertUniformNames in the program's list. `origin`: from where its places are measured, ECEF.
void set_alert_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const AlertZoneLook& look,
                        const glm::dvec3& origin);

}  // namespace tedavis::draw
