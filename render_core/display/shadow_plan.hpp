/// Whether shadows of data are called for in a frame, and how its sun sees what casts them. Pure; any thread.
#pragma once

#include "render_core/design/shadow_settings.hpp"
#include "render_core/display/caster_set.hpp"
#include "render_core/effects/effect_planner.hpp"
#include "render_core/policy/terrain_light.hpp"

namespace tedavis::display {

enum class ShadowState : std::uint8_t {
    not_asked_for,  ///< or not on this device
    sun_too_low,
    values_on_ground,  ///< a shadow would change what the colours of the ground say
    nothing_casts,     ///< no shadow reaches into the picture
    cast,
};

struct ShadowPlan {
    ShadowState state = ShadowState::not_asked_for;
    draw::ShadowFrame frame;
    double top_msl_m = 0;  ///< no caster is higher
    double widest_px = 0;  ///< no shadow is wider in the picture
    double in_air = 0;     ///< of the light of the air that they take
    std::uint32_t steps = 0;
};

struct ShadowScene {
    const design::ShadowSettings& settings;
    const policy::TerrainLight& light;
    const terrain::View& view;
    double eye_height_m = 0;  ///< over the ground below it
    double undulation_m = 0;  ///< there
    double lowest_msl_m = 0;  ///< of all ground
    double nearest_m = 1;     ///< no ground is nearer to the eye
    std::uint32_t level_px = 1024;
    bool has_values_on_ground = false;
};

[[nodiscard]] ShadowPlan plan_shadows(const ShadowScene& scene, const CasterSet& casters);
/// `is_near`: the eye is among what it sees.
/// `bound`: of what air or haze adds over the farthest way; 0: there is neither.
[[nodiscard]] effects::EffectCall shaft_call(const ShadowPlan& plan, bool is_near, double bound) noexcept;
[[nodiscard]] effects::EffectCall soft_shadow_call(const ShadowPlan& plan, bool is_near) noexcept;

}  // namespace tedavis::display
