/// Device capabilities that effects need, and whether a device has them. Pure; any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/effects/device_capability.hpp"

namespace tedavis::effects {

/// A capability that an effect needs.
enum class Need : std::uint8_t {
    nothing,
    depth24_target,
    half_float_texture,
    second_picture,
    shadow_map,
    shadow_map_and_picture,
    picture_copy
};

[[nodiscard]] bool has(const DeviceCapability& device, Need need) noexcept;
/// Returns a clause: "the device has no ...".
[[nodiscard]] std::string_view lack_of(Need need) noexcept;

}  // namespace tedavis::effects
