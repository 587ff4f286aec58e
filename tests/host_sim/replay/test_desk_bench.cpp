#include "host_sim/replay/desk_bench.hpp"

#include <gtest/gtest.h>

#include "host_sim/replay/load_design.hpp"
#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::host_sim::test_desk_bench {
namespace {

using effects::Effect;

/// Whoever adds an effect says which shipped design calls for it, and how a design is drawn without it.
TEST(DeskBench, EveryEffectThatCostsHasADesignThatRequestsIt) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        const std::string name = design_requesting(effect);
        const bool is_free = effects::row_of(effect).cost == "none" || effect == Effect::terrain;
        EXPECT_EQ(name.empty(), is_free) << effects::row_of(effect).name;
        if (name.empty()) continue;
        PictureOptions options;
        options.design = name;
        options.with.add(effect);
        const design::DesignSettings with = load_design(options);
        options.without.add(effect);
        const design::DesignSettings without = load_design(options);
        if (effect == Effect::ridges) {
            EXPECT_GT(with.terrain.style.sketch.ridges, 0);
            EXPECT_EQ(without.terrain.style.sketch.ridges, 0);
        } else if (effect == Effect::warning_colors) {
            EXPECT_TRUE(with.warning_colors && !without.warning_colors);
        } else {
            EXPECT_TRUE(effects::asked_effects(with).has(effect)) << name;
            EXPECT_FALSE(effects::asked_effects(without).has(effect)) << name;
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_desk_bench
