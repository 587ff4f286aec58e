#include "render_core/display/planner/saliency_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "render_core/effects/design_effects.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_saliency_schedule {
namespace {

using effects::Effect;
using test_support::HeadlessDisplay;

constexpr std::uint32_t kWidth = 320, kHeight = 240;

design::DesignSettings design_with(design::SaliencyView view) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.effects.fade_s = 0;
    design.effects.saliency.view = view;
    return design;
}

/// A display over the hills whose frames follow each other.
struct Shown {
    Shown(design::SaliencyView view, const char* device) : display("egl", device, kWidth, kHeight, &bytes, design_with(view)) {
        settle(display.display(), {state, {}, test_support::kHillsNow});
    }
    void update(double seconds) {
        display.display().plan({state, {}, test_support::kHillsNow + base::Duration::from_seconds(seconds)});
    }
    std::vector<std::uint8_t> at(double seconds) {
        update(seconds);
        return test_support::drawn_pixels(display);
    }
    [[nodiscard]] EffectRecord effect() {
        for (const EffectRecord& noted : display.display().record().effects)
            if (noted.name.view() == "saliency") return noted;
        return {};
    }
    [[nodiscard]] std::uint64_t target_bytes() {
        return display.display().planner().budget().find(effects::kRenderTargets)->use.in_use;
    }

    test_support::MemoryBytes bytes{test_support::hills().image};
    flight::AircraftState state = test_support::aircraft_over_hills(1600);
    HeadlessDisplay display;
};

struct Bare {
    std::vector<std::uint8_t> pixels;
    std::uint32_t draws = 0;
    std::uint64_t target_bytes = 0;
};
Bare without(const char* device) {
    Shown shown(design::SaliencyView::none, device);
    Bare bare{shown.at(0), shown.display.display().gl().frame().draws, shown.target_bytes()};
    EXPECT_TRUE(shown.effect().name.empty()) << "nobody asks, and the record is silent";
    return bare;
}

TEST(SaliencySchedule, CostsNothingWhereItIsNotComputed) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const Bare bare = without(device);
        Shown shown(design::SaliencyView::heat, device);
        EXPECT_GT(shown.target_bytes(), bare.target_bytes) << "control";
        EXPECT_NE(shown.at(0), bare.pixels) << "control";
        EXPECT_GT(shown.display.display().gl().frame().draws, bare.draws + 30) << "control";
        effects::EffectSet saliency;
        saliency.add(Effect::saliency);
        shown.display.display().memory().budget.give_up(saliency);
        EXPECT_EQ(shown.at(0), bare.pixels) << device << ": the same picture, to a bit";
        EXPECT_EQ(shown.display.display().gl().frame().draws, bare.draws);
        EXPECT_EQ(shown.effect().state, EffectState::skipped);
        EXPECT_EQ(shown.effect().draws + shown.effect().passes, 0u);
    }
}

TEST(SaliencySchedule, ADeviceThatCannotCopyItsPictureSaysSoAndPaysNothing) {
    const design::DesignSettings possible =
        effects::possible_design(design_with(design::SaliencyView::heat), test_support::shipped_device("sc2"));
    EXPECT_EQ(possible.effects.saliency.view, design::SaliencyView::none);
    effects::PlanInput input;
    input[Effect::saliency].kind = effects::EffectRequest::Kind::applicable;
    const effects::FramePlan plan = plan_effects(input, test_support::shipped_device("sc2").capability);
    EXPECT_EQ(plan[Effect::saliency].state, effects::PlanState::skipped);
    EXPECT_EQ(plan[Effect::saliency].reason, "the device cannot copy what it has drawn");
}

TEST(SaliencySchedule, AMapIsGreyAndHeatLetsThePictureThrough) {
    const Bare bare = without("es3-mid");
    std::vector<std::uint8_t> map;
    {
        Shown alone(design::SaliencyView::map, "es3-mid");
        map = alone.at(0);
    }
    int least = 255, most = 0;
    for (std::size_t n = 0; n < map.size(); n += 4) {
        ASSERT_TRUE(map[n] == map[n + 1] && map[n] == map[n + 2]);
        least = std::min(least, int{map[n]});
        most = std::max(most, int{map[n]});
    }
    EXPECT_LT(least, 40);
    EXPECT_GT(most, 220);
    Shown heat(design::SaliencyView::heat, "es3-mid");
    const auto hot = heat.at(0);
    double both = 0, of_bare = 0, of_hot = 0, mean_bare = 0, mean_hot = 0;
    const double count = static_cast<double>(map.size()) / 4;
    for (std::size_t n = 0; n < map.size(); n += 4) {
        mean_bare += bare.pixels[n + 1] / count;
        mean_hot += hot[n + 1] / count;
    }
    for (std::size_t n = 0; n < map.size(); n += 4) {
        both += (bare.pixels[n + 1] - mean_bare) * (hot[n + 1] - mean_hot);
        of_bare += (bare.pixels[n + 1] - mean_bare) * (bare.pixels[n + 1] - mean_bare);
        of_hot += (hot[n + 1] - mean_hot) * (hot[n + 1] - mean_hot);
    }
    EXPECT_GT(both / std::sqrt(of_bare * of_hot), 0.4) << "what was seen is still seen";
}

TEST(SaliencySchedule, TheSmallLaneMeasuresTwiceASecond) {
    Shown shown(design::SaliencyView::map, "es2-small");
    static_cast<void>(shown.at(0));
    EXPECT_EQ(shown.effect().passes, 2u);
    static_cast<void>(shown.at(0.1));
    EXPECT_EQ(shown.effect().passes, 1u) << "shown again";
    EXPECT_EQ(shown.effect().draws, 1u);
    shown.display.display().memory().cut();
    const auto first = shown.at(0.2);
    EXPECT_EQ(shown.effect().passes, 2u) << "nothing goes before it";
    EXPECT_EQ(shown.at(0.2), first);
    EXPECT_EQ(shown.effect().passes, 2u) << "the same frame once more";
    shown.state = test_support::aircraft_over_hills(1600, 120);
    EXPECT_EQ(shown.at(0.4), first) << "of the picture that was measured";
    EXPECT_FALSE(shown.display.display().memory().must_be_drawn());
    shown.update(0.5);
    EXPECT_TRUE(shown.display.display().memory().must_be_drawn());
    EXPECT_NE(shown.at(0.5), first);
    EXPECT_EQ(shown.effect().passes, 2u);
    EXPECT_EQ(shown.display.display().gl().denied().total, 0u);
}

TEST(SaliencySchedule, TheLargeLaneMeasuresEveryFrameAndNeedsNoOther) {
    Shown shown(design::SaliencyView::map, "es3-mid");
    for (const double seconds : {0.0, 0.1, 0.2}) {
        static_cast<void>(shown.at(seconds));
        EXPECT_EQ(shown.effect().passes, 2u);
        EXPECT_FALSE(shown.display.display().memory().must_be_drawn());
    }
    const base::Time now{1'234'567'890};
    EXPECT_EQ(shown.display.display().memory().needed_since(now).ns, now.ns);
}

TEST(SaliencySchedule, AnotherDesignMayShowItOnlyWhereTheDisplayWasStartedForIt) {
    Shown shown(design::SaliencyView::heat, "es3-mid");
    Display& display = shown.display.display();
    EXPECT_TRUE(display.set_design(design_with(design::SaliencyView::none)));
    EXPECT_TRUE(display.set_design(design_with(design::SaliencyView::heat)));
    EXPECT_FALSE(display.set_design(design_with(design::SaliencyView::map)));
}

TEST(SaliencySchedule, InAnUnusualAttitudeNothingLiesOverThePicture) {
    Shown shown(design::SaliencyView::map, "es3-mid");
    shown.state = test_support::aircraft_over_hills(1600, 30, 40);
    static_cast<void>(shown.at(0.1));
    EXPECT_EQ(shown.effect().state, EffectState::skipped);
    EXPECT_EQ(shown.effect().reason.view(), "removed by the failure policy");
}

}  // namespace
}  // namespace tedavis::display::test_saliency_schedule
