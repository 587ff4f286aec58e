#include "render_core/effects/device_needs.hpp"

namespace tedavis::effects {

bool has(const DeviceCapability& device, Need need) noexcept {
    const bool is_es3 = device.gl.calls == CallClass::es3;
    const bool has_picture = is_es3 && device.off_screen_pictures >= 2, has_shadows = is_es3 && device.shadow_map_px > 0;
    switch (need) {
        case Need::nothing: return true;
        case Need::depth24_target: return device.depth24_targets;
        case Need::half_float_texture: return is_es3;
        case Need::second_picture: return has_picture;
        case Need::shadow_map: return has_shadows;
        case Need::shadow_map_and_picture: return has_shadows && has_picture;
        case Need::picture_copy: return device.gl.calls != CallClass::sc2;
    }
    return false;
}

std::string_view lack_of(Need need) noexcept {
    if (need == Need::depth24_target) return "the device has no 24-bit depth off screen";
    if (need == Need::second_picture) return "the device has no second picture off screen that is read by texels";
    if (need == Need::shadow_map_and_picture) return "the device has no map of shadows, or no second picture off screen";
    if (need == Need::shadow_map) return "the device has no map of shadows";
    if (need == Need::picture_copy) return "the device cannot copy what it has drawn";
    return need == Need::half_float_texture ? "the device has no textures of half floats" : "";
}

}  // namespace tedavis::effects
