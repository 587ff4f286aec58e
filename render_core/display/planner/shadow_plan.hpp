/// Plans whether data cast shadows in a frame, and the sun's view in which the casters are drawn. Pure functions; any thread.
#pragma once

#include "render_core/design/shadow_settings.hpp"
#include "render_core/display/planner/caster_set.hpp"
#include "render_core/draw/shadow_frame.hpp"
#include "render_core/effects/effect_facts.hpp"
#include "render_core/policy/terrain_light.hpp"

namespace tedavis::display {

struct ShadowPlan {
    effects::ShadowState state = effects::ShadowState::not_asked_for;
    draw::ShadowFrame frame;
    double top_msl_m = 0;  ///< no caster is higher
    double widest_px = 0;  ///< no shadow is wider in the picture
    double in_air = 0;     ///< share of the air's light that shadows remove
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

}  // namespace tedavis::display
