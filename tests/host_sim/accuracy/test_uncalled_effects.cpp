#include "host_sim/accuracy/uncalled_effects.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_uncalled_effects {
namespace {

using effects::Effect;

UncalledEffects measured(std::vector<Effect> only) {
    const test_support::MadeKnobGround made;
    KnobFlight flight(made.ground);
    PictureOptions options;
    options.terrain = made.ground.path();
    options.size = PictureSize{160, 90};
    UncalledPlan plan;
    plan.poses = 2;
    plan.rounds = 2;
    plan.only = std::move(only);
    plan.progress = [](std::size_t, std::size_t) {};
    return measure_uncalled(flight, options, plan);
}

const EffectUse& use_named(const UncalledEffects& all, const std::string& name) {
    for (const EffectUse& use : all.uses)
        if (use.name == name) return use;
    throw std::runtime_error("no " + name);
}

TEST(UncalledEffects, CountEveryFrameOnceAndKeepTheirPromise) {
    const UncalledEffects all = measured({Effect::antialiasing, Effect::panel_lighting, Effect::haze});
    ASSERT_EQ(all.uses.size(), 3u);
    EXPECT_EQ(all.frames, 2u);
    for (const EffectUse& use : all.uses) {
        EXPECT_EQ(use.asked, 2u) << use.name;
        EXPECT_EQ(use.run + use.replaced + use.skipped, use.asked) << use.name;
        EXPECT_TRUE(use.keeps_promise()) << use.name;
        std::uint64_t explained = 0;
        for (const EffectReason& reason : use.reasons) explained += reason.frames;
        EXPECT_EQ(explained, use.replaced + use.skipped) << use.name;
    }
    EXPECT_EQ(use_named(all, "antialiasing").run, 2u) << "control: it is always called for";
}

TEST(EffectUse, BreaksItsPromiseByWorkOrByAVisibleColor) {
    EffectUse use;
    use.contribution = "color";
    use.largest_difference = 1;
    EXPECT_TRUE(use.keeps_promise());
    use.largest_difference = 2;
    EXPECT_FALSE(use.keeps_promise());
    use.contribution = "geometry";
    EXPECT_TRUE(use.keeps_promise()) << "positions may move by half a pixel, which may change a color by more";
    use.skipped_work = 1;
    EXPECT_FALSE(use.keeps_promise());
    EXPECT_FALSE((UncalledEffects{"default", "es3-mid", 1, {EffectUse{}, use}}).keep_promise());
    EXPECT_TRUE((UncalledEffects{"default", "es3-mid", 1, {EffectUse{}}}).keep_promise()) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_uncalled_effects
