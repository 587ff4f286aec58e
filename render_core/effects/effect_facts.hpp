/// The facts of a frame that decide whether an effect is applicable. Plain values, filled in by the frame's planner and read by
/// the rows of effect_table.cpp.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// The availability of an effect's input.
struct InputState {
    bool is_there = true;
    std::string_view why;  ///< why it is not available; static storage
};

/// Counts of one kind of depth cue of data elements.
struct CueState {
    bool is_shown = false;  ///< an element that requests it is shown
    std::uint32_t drawn = 0, hidden = 0;
};

enum class ShadowState : std::uint8_t {
    not_asked_for,  ///< or not possible on this device
    sun_too_low,
    values_on_ground,  ///< the colours of the ground are values, which shadows would falsify
    nothing_casts,     ///< no shadow reaches into the picture
    cast,
};

struct EffectFacts {
    EffectSet asked, forbidden, in_reserve;
    ReplacementOrder order{};
    bool is_forced = false;  ///< PlanInput::is_forced

    // What may be shown (policy::DisplayDecisions)
    bool shows_terrain = false, shows_warning_colors = false, is_unusual_attitude = false;

    // View
    bool is_near = false;        ///< the eye point is in the scene, not far above as on the map
    bool has_symbology = true;   ///< a free view has none
    bool is_stereo = false;      ///< the display has a picture for each eye
    double parallax_px = 0;      ///< largest stereo parallax
    double fade_share = 0;       ///< share of the previous picture in the fade
    bool light_has_date = true;  ///< a date is known for the sun's position, where the light follows the sun
    bool sun_is_too_low = false;
    bool panel_has_date = true;
    double panel_dimming = 0;  ///< 1 - least factor of the panel lighting; 0 by day

    // Air: upper bounds, as shares of full scale, by which it may change a colour
    bool has_haze = false, has_air = false;  ///< the view has haze or scattering air
    double haze_bound = 0, air_bound = 0;

    // Depth of field
    double focus_blur_px = 0;     ///< requested; 0: not possible on this device
    bool focus_is_known = false;  ///< the role that the focus is on is shown
    double widest_blur_px = 0;

    // Foci
    bool has_foci = false;  ///< a focus that changes the ground is in effect
    double context_blur_px = 0;
    bool reads_distances = false;  ///< another effect uses the distance buffer (design_effects.hpp)

    // Data
    InputState image, ground_data, maps_beside;
    std::uint32_t maps_drawn = 0;  ///< adjacent maps; 0 where there is no room
    CueState vertical_lines, projections, curtains;
    ShadowState shadows = ShadowState::not_asked_for;
    double widest_shadow_px = 0;
    double shadow_in_air = 0;             ///< share of the air's light that shadows remove
    bool shows_clutter = false;           ///< clutter is shown as a view
    bool has_declutterable_data = false;  ///< data that may be reduced for the clutter budget are shown
};

}  // namespace tedavis::effects
