#include "render_core/display/planner/frame_planner.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/display/hills_planner.hpp"

namespace tedavis::display::test_frame_planner {
namespace {

using test_support::HillsPlanner;
using test_support::kHillsNow;

flight::FrameInput input_at(double seconds, double msl_m = 1800) {
    flight::FrameInput input;
    input.state = test_support::aircraft_over_hills(msl_m);
    input.time = kHillsNow + base::Duration::from_seconds(seconds);
    return input;
}

template <class T>
std::string bytes_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// What the record says of a plan, and from where it is seen.
bool are_same(const PlannedFrame& a, const PlannedFrame& b) {
    const auto same = [](const auto& one, const auto& other) { return bytes_of(one) == bytes_of(other); };
    return same(static_cast<const FrameStatement&>(a), static_cast<const FrameStatement&>(b)) &&
           same(a.picture.camera.view.eye, b.picture.camera.view.eye) && same(a.decisions, b.decisions) &&
           same(a.weights, b.weights) && same(a.earlier_share, b.earlier_share) &&
           same(a.declutter.regions, b.declutter.regions) && a.terrain.chunks == b.terrain.chunks;
}

TEST(FramePlanner, EqualInputAndCopiesOfOneMemoryGiveEqualFrames) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input_at(0));
    const PlannerMemory before = hills->memory;
    PlannerMemory first = before, second = before, third = before;
    const auto one = hills->plan(input_at(0.1), first);
    static_cast<void>(hills->plan(input_at(0.2), first));
    const auto again = hills->plan(input_at(0.1), second);
    EXPECT_TRUE(are_same(*one, *again)) << "whatever was planned between";
    EXPECT_EQ(second.frames, before.frames + 1);
    EXPECT_FALSE(are_same(*one, *hills->plan(input_at(0.1, 1900), third))) << "control: from 100 m higher";
}

TEST(FramePlanner, TheLegendIsThatOfTheInputAndElseOfTheSettings) {
    using flight::LegendShow;
    design::DesignSettings tinted = test_support::shipped_design("default");
    tinted.terrain.style.texture = design::TerrainTexture::hypsometric;  // natural ground has no scale to explain
    auto hills = std::make_unique<HillsPlanner>(tinted);
    hills->settle(input_at(0));
    flight::FrameInput input = input_at(0.1);
    EXPECT_EQ(hills->plan(input, hills->memory)->legend.show, LegendShow::key) << "the default in flight";
    const std::size_t with_key = hills->planner().symbology().vertices().size();
    input.legend = LegendShow::none;
    const auto bare = hills->plan(input, hills->memory);
    EXPECT_EQ(bare->legend.show, LegendShow::none);
    EXPECT_EQ(bare->legend.entries, 0u);
    EXPECT_LT(hills->planner().symbology().vertices().size(), with_key);
    input.legend = LegendShow::whole;
    const auto whole = hills->plan(input, hills->memory);
    EXPECT_GE(whole->legend.entries, 1u);
    EXPECT_EQ(hills->planner().symbology().vertices().size(), with_key) << "on 320 x 240 the key stands in its place";
    hills->planner().settings().legend = LegendShow::none;
    input.legend.reset();
    EXPECT_EQ(hills->plan(input, hills->memory)->legend.show, LegendShow::none);
}

TEST(FramePlanner, TheMemoryDecidesWhatTheFrameFollowsFrom) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.view.mode = design::ViewMode::map;
    design.view.transition_s = 2;
    auto hills = std::make_unique<HillsPlanner>(design);
    PlannerMemory from_new = hills->memory;
    hills->settle(input_at(0));
    const PlannerMemory arrived = hills->memory;
    PlannerMemory from_arrived = arrived;
    const auto there = hills->plan(input_at(0.1), from_arrived);
    EXPECT_EQ(there->map_share, 1);
    EXPECT_EQ(hills->plan(input_at(0.1), from_new)->map_share, 1) << "the first frame is there at once";
    EXPECT_EQ(from_arrived.frames, arrived.frames + 1);
    EXPECT_EQ(from_new.frames, 1u);
}

TEST(FramePlanner, TerrainThatThePainterCouldNotDrawIsGivenUp) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input_at(0));
    const auto frame = hills->plan(input_at(0.1), hills->memory);
    ASSERT_TRUE(frame->decisions.show_terrain);
    hills->planner().plan_again({true, {}}, hills->memory, *frame);
    EXPECT_FALSE(frame->decisions.show_terrain);
    EXPECT_FALSE(hills->plan(input_at(0.2), hills->memory)->decisions.show_terrain) << "for good";
}

TEST(FramePlanner, AnIntervalChangesNothingButLabelsAndPriorities) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input_at(0));
    const PlannerMemory before = hills->memory;
    PlannerMemory passed = before;
    hills->planner().decide_interval(input_at(0.5), passed);
    EXPECT_EQ(passed.frames, before.frames);
    EXPECT_EQ(passed.shown, before.shown);
    EXPECT_EQ(passed.view.map_share(), before.view.map_share());
    EXPECT_TRUE(hills->planner().has_intervals()) << "terrain may be ahead";
    EXPECT_NE(bytes_of(passed.boost), bytes_of(before.boost)) << "control: the interval is another";
}

TEST(FramePlanner, IntervalsOfAnotherMemoryChangeNoFrame) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input_at(0));
    const PlannerMemory before = hills->memory;
    PlannerMemory with = before, without = before, decided;
    const auto expected = hills->plan(input_at(0.1), without);
    const std::uint64_t look_key = hills->planner().look_key();
    hills->planner().decide_interval(input_at(0.5, 1900), decided);
    EXPECT_EQ(hills->planner().look_key(), look_key) << "painters need not be told of any design";
    const auto frame = hills->plan(input_at(0.1), with);
    EXPECT_TRUE(are_same(*frame, *expected));
    with.take_interval(decided);
    EXPECT_EQ(with.boost.terrain_ahead(), decided.boost.terrain_ahead());
    EXPECT_EQ(with.frames, before.frames + 1);
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner
