#include "host_sim/accuracy/knobs/quality_level_knob.hpp"

#include <cstdio>

#include "host_sim/accuracy/knobs/color_knob.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::host_sim {
namespace {

/// Levels of the kind that `tedavis calibrate` measures and chooses from; the design asks for silhouettes, so these are given up.
struct SampledQuality {
    double tau_factor, detail_factor;
    bool has_silhouettes;
};
constexpr SampledQuality kSampledQualities[] = {{4, 0.2, false}, {4, 0.35, false}, {2.8, 0.5, true},
                                                {2, 0.65, true}, {1.4, 0.8, true}, {1, 1, true}};

std::string name_of(const SampledQuality& sampled) {
    if (sampled.tau_factor == 1) return "as the design asks";
    char name[80];
    std::snprintf(name, sizeof name, "tau x %g, detail x %g%s", sampled.tau_factor, sampled.detail_factor,
                  sampled.has_silhouettes ? "" : ", no silhouettes");
    return name;
}

KnobFacts quality_level_facts(const FlownDisplay& display) {
    std::vector<KnobLevel> levels;
    for (const SampledQuality& sampled : kSampledQualities) levels.push_back({name_of(sampled), 0});
    return {"quality_level",
            "Quality that the governor chooses for a frame's deadline",
            "[[quality]] of a calibration file, chosen by --deadline with --costs",
            pixel_metric(display.size),
            kColorUnit,
            {"the picture that the design asks for", 0, "it is one of the levels; a test draws it twice with the same bits"},
            "none: the design's own picture is what the levels depart from",
            "Terrain, warning colours, data on the ground, symbology and the features of the scene are drawn at every level.",
            "no scale: six levels",
            std::nullopt,
            std::move(levels)};
}

ColorPlan quality_levels(const KnobGround& ground, const std::string& scene) {
    ColorPlan plan;
    plan.size = ground.display.size;
    for (const SampledQuality& sampled : kSampledQualities) {
        FlownLevel level = flown_level(ground.ground.path(), ground.display);
        level.picture.scene = scene;
        level.quality = effects::QualityLevel{sampled.tau_factor, sampled.detail_factor, {}, 0, 0, 0};
        if (!sampled.has_silhouettes) level.quality->given_up.add(effects::Effect::silhouettes);
        plan.drawn.push_back(level);
    }
    plan.reference = plan.drawn.size() - 1;
    return plan;
}

class QualityLevelKnob final : public ColorKnob {
public:
    QualityLevelKnob(const KnobGround& ground, KnobFlight& flight)
        : ColorKnob(quality_level_facts(ground.display), quality_levels(ground, flight.scene()),
                    flight.poses(flown_poses(ground.is_quick))) {}
};

}  // namespace

std::unique_ptr<Knob> make_quality_level_knob(const KnobGround& ground) {
    KnobFlight flight(ground);
    return std::make_unique<QualityLevelKnob>(ground, flight);
}

}  // namespace tedavis::host_sim
