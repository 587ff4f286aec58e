/// What a device can do, as its file says: which GL calls exist there and with what arguments, and how deep its depth
/// buffer is. Plain data; the GL layer enforces it and the planner asks it.
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
inline constexpr std::size_t kMaxNamedCalls = 16;  ///< that a device file names beside its class
/// Those, and the calls of a compiler that makes its programs (gl/program.hpp).
inline constexpr std::size_t kMaxCallExceptions = 2 * kMaxNamedCalls;
using FaultName = base::FixedString<31>;
inline constexpr std::size_t kMaxIgnoredFaults = 4;

struct GlRules {
    CallClass calls = CallClass::es2;
    base::FixedVector<CallName, kMaxCallExceptions> also;   ///< calls beyond the class
    base::FixedVector<CallName, kMaxCallExceptions> never;  ///< calls of the class that this device must not use
    base::FixedVector<FaultName, kMaxIgnoredFaults>
        ignored_faults;                   ///< known ones of drivers (gl/driver_fault.hpp) that it has not
    std::uint32_t max_texture_px = 2048;  ///< largest texture and render target edge
    std::uint32_t max_attributes = 8;
    std::uint32_t max_texture_units = 8;
};

struct DeviceCapability {
    Lane lane = Lane::es2;
    GlRules gl;
    std::uint32_t surface_depth_bits = 24;  ///< the surface must have at least so many
    bool depth24_targets = true;            ///< off-screen targets need 24-bit depth (OES_depth24 on ES 2.0)
    std::uint32_t off_screen_pictures = 1;  ///< pictures of the device's size, with depth, that it has room and time for
    std::uint32_t shadow_map_px = 0;        ///< edge of each of the three levels of a map of shadows; 0: it has none
};
static_assert(std::is_trivially_copyable_v<DeviceCapability>);

[[nodiscard]] constexpr const char* to_string(Lane lane) noexcept { return lane == Lane::es2 ? "es2" : "es3"; }
[[nodiscard]] constexpr const char* to_string(CallClass calls) noexcept {
    return calls == CallClass::es2 ? "es2" : calls == CallClass::es3 ? "es3" : "sc2";
}

}  // namespace tedavis::effects
