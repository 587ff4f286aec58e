/// What of a frame decides whether an effect is applicable. Plain values: whoever plans the frame fills them in, the rows of
/// effect_table.cpp read them.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// What an effect shows, where that may not be there.
struct InputState {
    bool is_there = true;
    std::string_view why;  ///< not, in static storage
};

/// Of one kind of cue to the depth of data elements.
struct CueState {
    bool is_shown = false;  ///< an element that asks for it is
    std::uint32_t drawn = 0, hidden = 0;
};

enum class ShadowState : std::uint8_t {
    not_asked_for,  ///< or not on this device
    sun_too_low,
    values_on_ground,  ///< a shadow would change what the colours of the ground say
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
    bool is_near = false;        ///< the eye is among what it sees, not far above as the map's
    bool has_symbology = true;   ///< a free view has none
    bool is_stereo = false;      ///< the display has a picture for each eye
    double parallax_px = 0;      ///< none is greater
    double fade_share = 0;       ///< of the scene as it was
    bool light_has_date = true;  ///< that the sun of the terrain's light is found by, where it moves
    bool sun_is_too_low = false;
    bool panel_has_date = true;
    double panel_dimming = 0;  ///< 1 - the darkest factor; 0: it is day

    // Air: parts of full scale by which it may change a colour
    bool has_haze = false, has_air = false;  ///< the view has some
    double haze_bound = 0, air_bound = 0;

    // Depth of field
    double focus_blur_px = 0;     ///< asked for; 0: not on this device
    bool focus_is_known = false;  ///< the role that is in focus is shown
    double widest_blur_px = 0;

    // Foci
    bool has_foci = false;  ///< one of those that change the ground is somewhere
    double context_blur_px = 0;
    bool reads_distances = false;  ///< something else is found in the distances of the picture (design_effects.hpp)

    // Data
    InputState image, ground_data, maps_beside;
    std::uint32_t maps_drawn = 0;  ///< beside the picture; 0 where they have no room
    CueState vertical_lines, projections, curtains;
    ShadowState shadows = ShadowState::not_asked_for;
    double widest_shadow_px = 0;
    double shadow_in_air = 0;         ///< of the light of the air that shadows take
    bool shows_clutter = false;       ///< as a view; else it is measured for a budget, if at all
    bool has_what_gives_way = false;  ///< to that budget
};

}  // namespace tedavis::effects
