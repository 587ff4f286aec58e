/// What an effect may need of a device, and whether the device has it. Pure; any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/effects/device_capability.hpp"

namespace tedavis::effects {

/// What the device must be able to do.
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
/// A clause: "the device has no ...".
[[nodiscard]] std::string_view lack_of(Need need) noexcept;

}  // namespace tedavis::effects
