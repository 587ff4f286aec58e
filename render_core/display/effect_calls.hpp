/// Which effects a frame calls for: what the design asks, what scene and view need, and what is there to be shown. The answer is
/// for the planner of effects. Pure; any thread.
#pragma once

#include <limits>
#include <string_view>

#include "render_core/design/design_settings.hpp"
#include "render_core/display/cue_calls.hpp"
#include "render_core/display/element_planner.hpp"
#include "render_core/display/shadow_plan.hpp"
#include "render_core/display/spatial_data.hpp"
#include "render_core/display/terrain_planner.hpp"
#include "render_core/draw/focus_ground.hpp"
#include "render_core/draw/view_effects_pass.hpp"
#include "render_core/earth/atmosphere.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/effects/effect_planner.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/panel_lighting.hpp"
#include "render_core/policy/terrain_light.hpp"

namespace tedavis::display {

/// Why an effect of what may not be shown now is left out.
inline constexpr std::string_view kRemovedByPolicy = "removed by the failure policy";

/// Effects that a design asks for, whether or not they are possible.
[[nodiscard]] effects::EffectSet asked_effects(const design::DesignSettings& design) noexcept;

/// The design as if it asked for an effect that needs nothing but to be asked for: air, blur of what is out of focus, smooth
/// edges. Others change nothing.
[[nodiscard]] design::DesignSettings with_effect(const design::DesignSettings& design, effects::Effect effect) noexcept;
/// The design as if it did not ask for an effect.
[[nodiscard]] design::DesignSettings without_effect(const design::DesignSettings& design, effects::Effect effect) noexcept;

/// Something else is found in the distances of the picture, so that there is no blur round foci.
[[nodiscard]] bool reads_distances(const design::DesignSettings& design) noexcept;

/// What can take another's place in a running display of this design, as possible_design() gives it: what is compiled in anyway.
[[nodiscard]] effects::EffectSet effects_in_reserve(const design::DesignSettings& possible) noexcept;

/// What takes an effect's place, by the design; start() refuses one that cannot be had.
[[nodiscard]] effects::ReplacementOrder order_of(const design::DesignSettings& design) noexcept;

/// The design with what a device cannot do, or must not, in the way that stands for it there.
[[nodiscard]] design::DesignSettings possible_design(const design::DesignSettings& design, const effects::DeviceSettings& device);

struct EffectFacts {
    effects::EffectSet asked, forbidden, in_reserve;
    const policy::DisplayDecisions& decisions;
    bool is_near = false;  ///< the eye is among what it sees, not far above as the map's
    policy::LightSource light = policy::LightSource::fixed;
    DrapeState drape = DrapeState::not_asked_for;
    GroundDataState ground_data = GroundDataState::not_asked_for;
    GroundDataState adjacent = GroundDataState::not_asked_for;
    std::uint32_t adjacent_maps = 0;  ///< that are drawn; 0 where they have no room
    double haze_per_m = 0;            ///< of the view; 0 where it has none
    /// No haze is farther from the eye; infinite where that is not known: elements may be seen beyond the ground.
    double farthest_m = std::numeric_limits<double>::infinity();
    double nearest_m = 0;  ///< nothing is nearer to the eye
    design::AirSettings air{};
    draw::FocusRange focus{};
    double parallax_px = 0;  ///< none is greater
    double fade_share = 0;   ///< of the scene as it was
    effects::ReplacementOrder order{};
    policy::PanelLight panel{};
    CueStates cues{};
    ShadowPlan shadows{};
    bool has_foci = false;       ///< one of those that change the ground is somewhere
    double context_blur_px = 0;  ///< of the design as it is possible
    bool reads_distances = false;
    bool shows_clutter = false;       ///< as a view; else it is measured for a budget, if at all
    bool has_what_gives_way = false;  ///< to that budget
    bool is_stereo = false;           ///< the display has a picture for each eye
    bool is_forced = false;           ///< PlanInput::is_forced
};

[[nodiscard]] effects::PlanInput effect_calls(const EffectFacts& facts) noexcept;

/// Part of full scale by which haze may change a colour as far away as `farthest_m`.
[[nodiscard]] double haze_bound(double haze_per_m, double farthest_m) noexcept;
/// The same of air: as dense all the way as at sea level.
[[nodiscard]] double air_bound(const design::AirSettings& air, double farthest_m) noexcept;
/// By distance, or as far as what is shown of the role reaches.
[[nodiscard]] draw::FocusRange focus_of(const design::DepthOfField& field, const ElementPlanner& elements, const glm::dvec3& eye);
/// The widest blur, in pixels, of what is between these distances.
[[nodiscard]] double blur_bound(const draw::FocusRange& focus, double nearest_m, double farthest_m) noexcept;

}  // namespace tedavis::display
