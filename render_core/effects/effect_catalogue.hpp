/// Every effect that a picture may have: what it needs, what an upper bound of its visible contribution is made of, and what
/// takes its place. A declaration only; effect_planner decides.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/effects/device_capability.hpp"

namespace tedavis::effects {

enum class Effect : std::uint8_t {
    terrain,
    warning_colors,
    silhouettes,
    ridges,
    moving_sun,
    fixed_light,
    drape,
    plain_color,
    aerial_perspective,
    haze,
    surface_grid,
    ground_data,
    adjacent,
    depth_of_field,
    antialiasing,
    panel_lighting,
    stereo,
    cross_fade,
    vertical_lines,
    projections,
    curtains,
    soft_shadows,
    volumetric_light,
    focus_ground,
    focus_blur,
    saliency,
    clutter,
    count_
};
inline constexpr std::size_t kEffectCount = static_cast<std::size_t>(Effect::count_);

/// What an effect changes, and so in what its bound is stated and where it may be left out unseen.
enum class Contribution : std::uint8_t {
    content,   ///< information: never left out for being small
    color,     ///< bound in parts of full scale, 0..1; bounds of all that are left out add up
    geometry,  ///< places or sharpness: bound in pixels
};
inline constexpr std::array<std::string_view, 3> kContributionNames{"content", "color", "geometry"};

/// Sum of the bounds of effects on colour that a frame may leave out: one step of eight bits.
inline constexpr double kUnseenColor = 1.0 / 255;
/// Bound of an effect on geometry that may be left out.
inline constexpr double kUnseenPixels = 0.5;

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

struct EffectEntry {
    Effect effect = Effect::count_;
    std::string_view name;  ///< as in records and files
    Contribution contribution = Contribution::content;
    Need need = Need::nothing;
    bool may_be_forbidden = false;                                       ///< by a device's file
    std::string_view bound;                                              ///< of what its bound is made; empty: it has none
    std::string_view cost;                                               ///< what it adds to a frame
    std::array<Effect, 2> replacements{Effect::count_, Effect::count_};  ///< in order; count_ for none
};

[[nodiscard]] const EffectEntry& entry_of(Effect effect) noexcept;
/// count_ for no such name.
[[nodiscard]] Effect effect_of(std::string_view name) noexcept;

[[nodiscard]] bool has(const DeviceCapability& device, Need need) noexcept;
/// A clause: "the device has no ...".
[[nodiscard]] std::string_view lack_of(Need need) noexcept;

}  // namespace tedavis::effects
