/// The table of effects, one row each: the design key that requests it, the capability that it needs, its cost, its
/// replacements, and the condition under which it is applicable to scene and view. effect_planner decides by these rows only,
/// so a new effect is one row here, its painter, and its test (CONTRIBUTING.md, "A new effect").
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

/// What an effect changes; it determines the unit of its bound and when it may be left out as invisible.
enum class Contribution : std::uint8_t {
    content,   ///< information: never left out as invisible
    color,     ///< bound as a share of full scale, 0..1; bounds of all omitted effects are added
    geometry,  ///< positions or sharpness: bound in pixels
};
inline constexpr std::array<std::string_view, 3> kContributionNames{"content", "color", "geometry"};

/// Largest sum of the bounds of colour effects that a frame may leave out: one step of eight bits.
inline constexpr double kUnseenColor = 1.0 / 255;
/// Largest bound of a geometry effect that may be left out.
inline constexpr double kUnseenPixels = 0.5;

struct EffectRequest;
struct EffectFacts;

struct EffectRow {
    using Design = design::DesignSettings;

    Effect effect = Effect::count_;
    std::string_view name;        ///< as in records and files
    std::string_view design_key;  ///< key that requests it: "[table] key"; empty: none, or every design requests it
    Contribution contribution = Contribution::content;
    Need need = Need::nothing;
    bool may_be_forbidden = false;                                       ///< by a device's file
    std::string_view bound;                                              ///< what its bound is made of; empty: it has none
    std::string_view cost;                                               ///< what it adds to a frame
    std::array<Effect, 2> replacements{Effect::count_, Effect::count_};  ///< in order; count_ for none
    bool may_be_given_up = false;  ///< for the frame's deadline: it embellishes, and nothing that safety needs depends on it
    bool distracts = false;        ///< it distracts from a recovery and is not shown in an unusual attitude
    bool needs_terrain = true;     ///< it is not shown where terrain is not

    /// Null: it only takes the place of others.
    bool (*is_asked)(const Design&) = nullptr;
    /// Makes a design request it. Null: it needs further settings.
    void (*ask)(Design&) = nullptr;
    /// Removes a design's request for it. Null: it cannot be removed.
    void (*take_out)(Design&) = nullptr;
    /// Makes a design show `by` (count_: nothing) instead, with the settings of `asked`. Null: take_out() is used.
    void (*replace)(const Design& asked, Effect by, Design& possible) = nullptr;
    /// Whether it is applicable to scene and view, where a design requests it and it may be shown. Null: it is only a
    /// replacement.
    EffectRequest (*request)(const EffectFacts&) = nullptr;
};

[[nodiscard]] const EffectRow& row_of(Effect effect) noexcept;
/// Returns the effect of a name, or count_.
[[nodiscard]] Effect effect_of(std::string_view name) noexcept;

}  // namespace tedavis::effects
