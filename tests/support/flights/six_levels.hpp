/// Six quality levels for tests, with made figures: what a calibration may hold.
#pragma once

#include "render_core/effects/quality_level.hpp"

namespace tedavis::test_support {

inline effects::QualityLevels six_levels() {
    using effects::Effect;
    effects::EffectSet blur, edges, forms;
    for (const Effect effect : {Effect::depth_of_field, Effect::focus_blur, Effect::volumetric_light, Effect::saliency})
        blur.add(effect);
    edges = blur;
    edges.add(Effect::antialiasing);
    edges.add(Effect::soft_shadows);
    forms = edges;
    forms.add(Effect::silhouettes);
    effects::QualityLevels levels;
    levels.count = effects::kQualityLevelCount;
    levels.at = {{{1, 1, {}, 60, 1, 0},
                  {1.4, 0.8, blur, 50, 1.4, 0.5},
                  {2, 0.65, edges, 40, 2, 1},
                  {2.8, 0.5, edges, 30, 2.8, 1.5},
                  {4, 0.35, forms, 20, 4, 2},
                  {4, 0.2, forms, 10, 4, 2.5}}};
    return levels;
}

}  // namespace tedavis::test_support
