/// A frame that shows terrain from near, by a design that asks for most effects.
#pragma once

#include <gtest/gtest.h>

#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/effect_requests.hpp"
#include "tests/support/display/full_design.hpp"

namespace tedavis::test_support {

class RequestingFrame : public ::testing::Test {
protected:
    RequestingFrame() {
        facts_.asked = effects::asked_effects(design_with_everything());
        facts_.shows_terrain = facts_.shows_warning_colors = true;
        facts_.is_near = facts_.has_haze = true;
        facts_.haze_bound = 0.25;
        facts_.maps_drawn = 1;
    }
    [[nodiscard]] effects::EffectRequest call(effects::Effect effect) const { return effects::effect_requests(facts_)[effect]; }

    effects::EffectFacts facts_;
};

}  // namespace tedavis::test_support
