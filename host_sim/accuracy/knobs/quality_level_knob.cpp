#include "host_sim/accuracy/knobs/quality_level_knob.hpp"

#include "host_sim/accuracy/knobs/color_knob.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::host_sim {
namespace {

using effects::kQualityLevelCount;

KnobFacts quality_level_facts() {
    std::vector<KnobLevel> levels;
    for (std::size_t n = kQualityLevelCount; n-- > 0;)
        levels.push_back({n == 0 ? std::string("as the design asks") : "level " + std::to_string(n), 0});
    return {"quality_level",
            "Quality that the governor chooses for a frame's deadline",
            "effects::kQualityLevels, chosen by --deadline with --costs",
            kPixelMetric,
            kColorUnit,
            {"the picture that the design asks for", 0, "it is one of the levels; a test draws it twice with the same bits"},
            "none: the design's own picture is what the levels depart from",
            "Terrain, warning colours, data on the ground, symbology and the features of the scene are drawn at every level.",
            "no scale: six levels",
            std::nullopt,
            std::move(levels)};
}

ColorPlan quality_levels(const std::string& terrain, const std::string& scene) {
    ColorPlan plan;
    for (std::size_t n = kQualityLevelCount; n-- > 0;) {
        FlownLevel level;
        level.picture.terrain = terrain;
        level.picture.scene = scene;
        level.picture.size = kFlownSize;
        level.quality_level = n;
        plan.drawn.push_back(level);
    }
    plan.reference = kQualityLevelCount - 1;
    return plan;
}

class QualityLevelKnob final : public ColorKnob {
public:
    QualityLevelKnob(const KnobGround& ground, KnobFlight& flight)
        : ColorKnob(quality_level_facts(), quality_levels(ground.ground.path(), flight.scene()),
                    flight.poses(flown_poses(ground.is_quick))) {}
};

}  // namespace

std::unique_ptr<Knob> make_quality_level_knob(const KnobGround& ground) {
    KnobFlight flight(ground.ground);
    return std::make_unique<QualityLevelKnob>(ground, flight);
}

}  // namespace tedavis::host_sim
