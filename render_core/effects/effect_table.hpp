/// Every effect that a picture may have, a row each: which key of a design asks for it, what the device must have, what it costs,
/// what takes its place, and when it is applicable to scene and view. effect_planner decides by the rows; no other place lists
/// effects for these questions, so that a new effect is one row here, its painter, and its test (CONTRIBUTING.md, "A new
/// effect").
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/design/design_settings.hpp"
#include "render_core/effects/device_needs.hpp"

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

struct EffectRequest;
struct EffectFacts;

/// No rung of the quality ladder gives it up.
inline constexpr std::uint8_t kNeverGivenUp = 255;

struct EffectRow {
    using Design = design::DesignSettings;

    Effect effect = Effect::count_;
    std::string_view name;        ///< as in records and files
    std::string_view design_key;  ///< that asks for it: "[table] key"; empty: nothing does, or every design
    Contribution contribution = Contribution::content;
    Need need = Need::nothing;
    bool may_be_forbidden = false;                                       ///< by a device's file
    std::string_view bound;                                              ///< of what its bound is made; empty: it has none
    std::string_view cost;                                               ///< what it adds to a frame
    std::array<Effect, 2> replacements{Effect::count_, Effect::count_};  ///< in order; count_ for none
    std::uint8_t given_up_from = kNeverGivenUp;                          ///< rung of the quality ladder
    bool distracts = false;     ///< from the recovery out of an unusual attitude: not shown during it
    bool needs_terrain = true;  ///< it is not shown where terrain is not

    /// Null: it only takes the place of others.
    bool (*is_asked)(const Design&) = nullptr;
    /// Makes a design ask for it. Null: it needs more than to be asked for.
    void (*ask)(Design&) = nullptr;
    /// Makes a design ask for it no more. Null: nothing does.
    void (*take_out)(Design&) = nullptr;
    /// Makes a design show `by` (count_: nothing) in its place, as `asked` wants it. Null: take_out() does.
    void (*replace)(const Design& asked, Effect by, Design& possible) = nullptr;
    /// What scene and view say to it, where a design asks for it and it may be shown. Null: it only takes the place of others.
    EffectRequest (*request)(const EffectFacts&) = nullptr;
};

[[nodiscard]] const EffectRow& row_of(Effect effect) noexcept;
/// count_ for no such name.
[[nodiscard]] Effect effect_of(std::string_view name) noexcept;

}  // namespace tedavis::effects
