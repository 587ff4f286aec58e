/// The settings that every surface backend receives.
#pragma once

#include <cstdint>

namespace tedavis::platform {

/// The GL ES version of the context, that of the device's lane.
enum class ContextLane : std::uint8_t { es2, es3 };

struct SurfaceSettings {
    std::uint32_t width_px = 0;
    std::uint32_t height_px = 0;
    ContextLane lane = ContextLane::es3;
};

inline constexpr std::uint32_t kMinSurfacePx = 16;
inline constexpr std::uint32_t kMaxSurfacePx = 16384;

[[nodiscard]] constexpr bool size_is_possible(const SurfaceSettings& settings) {
    return settings.width_px >= kMinSurfacePx && settings.width_px <= kMaxSurfacePx && settings.height_px >= kMinSurfacePx &&
           settings.height_px <= kMaxSurfacePx;
}

}  // namespace tedavis::platform
