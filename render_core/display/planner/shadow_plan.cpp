#include "render_core/display/planner/shadow_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {
namespace {

using effects::ShadowState;

// The geoid is no plane, and terrain is drawn within its tolerance.
constexpr double kHeightMargin_m = 30;

/// Takes up all that casts, and asks whether any shadow is seen.
class Casters {
public:
    Casters(const ShadowScene& scene, ShadowPlan& plan) : scene_(scene), plan_(plan) {}

    void add(const draw::CasterBall& ball) {
        draw::add_caster(plan_.frame, ball);
        plan_.widest_px = std::fmax(plan_.widest_px, 2 * ball.radius_m * scene_.view.focal_px / std::fmax(scene_.nearest_m, 1));
        if (plan_.state == ShadowState::cast) return;
        const double lowest_m = scene_.lowest_msl_m + scene_.undulation_m - kHeightMargin_m;
        if (draw::shades_the_view(plan_.frame, scene_.view, ball, lowest_m)) plan_.state = ShadowState::cast;
    }
    void add_solids(const draw::SolidBatch& batch, const draw::CasterGroups& groups) {
        for (const draw::SolidPiece& piece : batch.pieces())
            if (draw::casts_shadow(piece, groups)) add({piece.anchor, double{piece.radius_m}, double{piece.top_m}});
    }
    void add_glyphs(const draw::GlyphBatch& glyphs, std::uint32_t slots) {
        for (const draw::GlyphRun& run : glyphs.runs()) {
            if ((slots >> run.slot & 1u) == 0 || !draw::casts_shadow(run)) continue;
            for (const draw::GlyphInstance& glyph : glyphs.of(run)) {
                const glm::dvec3 place = scene_.view.eye + glm::dvec3(glyph.place);
                const auto reach_m = static_cast<double>(glm::length(glyph.size_m));
                add({place, reach_m, earth::from_ecef(place).height.m + reach_m});
            }
        }
    }

private:
    const ShadowScene& scene_;
    ShadowPlan& plan_;
};

}  // namespace

ShadowPlan plan_shadows(const ShadowScene& scene, const CasterSet& casters) {
    ShadowPlan plan;
    if (!scene.settings.is_any()) return plan;
    plan.state = ShadowState::sun_too_low;
    if (scene.light.source == policy::LightSource::sun_too_low || scene.light.elevation_rad < policy::kLowestSun_rad) return plan;
    plan.state = ShadowState::values_on_ground;
    if (scene.has_values_on_ground) return plan;
    plan.state = ShadowState::nothing_casts;
    plan.frame = draw::make_shadow_frame(
        {scene.view, scene.eye_height_m, scene.light.azimuth_rad, scene.light.elevation_rad, scene.level_px});
    plan.frame.on_ground = scene.settings.on_ground;
    plan.in_air = scene.settings.in_air;
    plan.steps = scene.settings.steps;
    Casters found(scene, plan);
    for (const draw::SolidBatch* const solids : casters.solids)
        if (solids != nullptr) found.add_solids(*solids, casters.groups);
    if (casters.glyphs != nullptr) found.add_glyphs(*casters.glyphs, casters.glyph_slots);
    plan.top_msl_m = plan.frame.top_m - scene.undulation_m + kHeightMargin_m;
    return plan;
}

}  // namespace tedavis::display
