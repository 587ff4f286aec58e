/// The capabilities of a device, from its file: the available GL calls and their arguments, and the depth buffer's bits. Plain
/// data; the GL layer enforces it and the planner reads it.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::effects {

/// Which shaders are built: `#version 100` or `#version 300 es`.
enum class Lane : std::uint8_t { es2, es3 };

/// Which calls exist: OpenGL ES 2.0, ES 3.0, or OpenGL SC 2.0 (which has no compiler, no deletion, no DrawElements).
enum class CallClass : std::uint8_t { es2, es3, sc2 };

using CallName = base::FixedString<31>;            ///< without the `gl` prefix
inline constexpr std::size_t kMaxNamedCalls = 16;  ///< calls that a device file names besides its class
/// Capacity for those and for the calls of the compiler that makes the device's programs (gl/program.hpp).
inline constexpr std::size_t kMaxCallExceptions = 2 * kMaxNamedCalls;
using FaultName = base::FixedString<31>;
inline constexpr std::size_t kMaxIgnoredFaults = 4;

struct GlRules {
    CallClass calls = CallClass::es2;
    base::FixedVector<CallName, kMaxCallExceptions> also;   ///< calls beyond the class
    base::FixedVector<CallName, kMaxCallExceptions> never;  ///< calls of the class that this device must not use
    base::FixedVector<FaultName, kMaxIgnoredFaults>
        ignored_faults;                   ///< known driver faults (gl/driver_fault.hpp) that this device does not have
    std::uint32_t max_texture_px = 2048;  ///< largest texture and render target edge
    std::uint32_t max_attributes = 8;
    std::uint32_t max_texture_units = 8;
};

struct DeviceCapability {
    Lane lane = Lane::es2;
    GlRules gl;
    std::uint32_t surface_depth_bits = 24;  ///< least depth bits of the surface
    bool depth24_targets = true;            ///< off-screen targets need 24-bit depth (OES_depth24 on ES 2.0)
    std::uint32_t off_screen_pictures = 1;  ///< number of off-screen pictures of the device's size, with depth, that it can hold
    std::uint32_t shadow_map_px = 0;        ///< edge of each of the three levels of the shadow map; 0: none
    std::uint32_t blur_square_px = 2;       ///< edge of the squares of pixels in which depth of field is computed; 1: every pixel
};
static_assert(std::is_trivially_copyable_v<DeviceCapability>);

[[nodiscard]] constexpr const char* to_string(Lane lane) noexcept { return lane == Lane::es2 ? "es2" : "es3"; }
[[nodiscard]] constexpr const char* to_string(CallClass calls) noexcept {
    return calls == CallClass::es2 ? "es2" : calls == CallClass::es3 ? "es3" : "sc2";
}

}  // namespace tedavis::effects
