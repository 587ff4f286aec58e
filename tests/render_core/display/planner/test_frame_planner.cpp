#include "render_core/display/planner/frame_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "tests/render_core/display/planner/crowd_of_data.hpp"
#include "tests/support/display/hills_planner.hpp"

namespace tedavis::display::test_frame_planner {
namespace {

using test_support::HillsPlanner;
using test_support::kHillsNow;

flight::FrameInput input_at(double seconds, double msl_m = 1800, double heading_deg = 30) {
    flight::FrameInput input;
    input.state = test_support::aircraft_over_hills(msl_m, heading_deg);
    input.time = kHillsNow + base::Duration::from_seconds(seconds);
    return input;
}

/// With zeros as padding: a copy that is made member by member leaves there what the stack held. Clang, which only checks this
/// file, cannot clear it.
template <class T>
std::string bytes_of(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    T copy = value;
#if !defined(__clang__)
    __builtin_clear_padding(&copy);
#endif
    return {reinterpret_cast<const char*>(&copy), sizeof copy};
}

std::string bytes_of_vertices(const draw::QuadBatch& batch) {
    const base::Span<const draw::QuadVertex> vertices = batch.vertices();
    return {reinterpret_cast<const char*>(vertices.data()), vertices.size() * sizeof(draw::QuadVertex)};
}

/// A frame with what it refers to in the planner, and the memory after it.
struct Planned {
    std::unique_ptr<PlannedFrame> frame;
    PlannerMemory after;
    std::vector<terrain::SelectedChunk> chunks;
    std::string symbology, signs;
};

/// `edges`: what the painter measures of the pictures that the plan asks for, one after the other.
Planned planned(HillsPlanner& hills, const flight::FrameInput& input, const PlannerMemory& before,
                const std::vector<float>& edges = {}) {
    Planned made{nullptr, before, {}, {}, {}};
    made.frame = hills.plan(input, made.after);
    for (std::size_t n = 0; n < edges.size() && made.frame->clutter.probe != Probe::none; ++n)
        hills.planner().plan_again({false, test_support::clutter_of(edges[n])}, made.after, *made.frame);
    const auto& chunks = made.frame->picture.terrain.chunks;
    made.chunks.assign(chunks.begin(), chunks.end());
    made.symbology = bytes_of_vertices(hills.planner().symbology());
    made.signs = bytes_of_vertices(hills.planner().elements().signs());
    return made;
}

/// But for the places where the planner keeps them.
bool are_same(const terrain::SelectedChunk& a, const terrain::SelectedChunk& b) {
    return a.key == b.key && a.coarser_edges == b.coarser_edges && a.error_px == b.error_px && a.distance_m == b.distance_m &&
           bytes_of(a.lift) == bytes_of(b.lift);
}

bool are_same(const effects::FramePlan& a, const effects::FramePlan& b) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const effects::PlannedEffect &one = a[static_cast<effects::Effect>(n)], &other = b[static_cast<effects::Effect>(n)];
        if (one.state != other.state || one.reason != other.reason || one.replaced_by != other.replaced_by ||
            one.bound != other.bound)
            return false;
    }
    return true;
}

bool are_same(const ShadowPlan& a, const ShadowPlan& b) {
    return a.state == b.state && a.top_msl_m == b.top_msl_m && a.widest_px == b.widest_px && a.in_air == b.in_air &&
           a.steps == b.steps;
}

bool are_same(const PlannedElements& a, const PlannedElements& b) {
    return a.shown == b.shown && a.has_reports == b.has_reports && bytes_of(a.time) == bytes_of(b.time);
}

/// The names of the parts that differ; empty for equal frames and memories. Not compared: pointers, and the keys by which a
/// painter sees that it must upload again, which tell of the plans between (look_key, ground_key, standing_key).
std::string differences(const Planned& one, const Planned& other) {
    const PlannedFrame &a = *one.frame, &b = *other.frame;
    const auto same = [](const auto& x, const auto& y) { return bytes_of(x) == bytes_of(y); };
    const auto same_chunk = [](const terrain::SelectedChunk& x, const terrain::SelectedChunk& y) { return are_same(x, y); };
    const std::pair<const char*, bool> parts[] = {
        {"memory", same(one.after, other.after)},
        {"statement", same(static_cast<const FrameStatement&>(a), static_cast<const FrameStatement&>(b))},
        {"conditions", same(a.conditions, b.conditions)},
        {"decisions", same(a.decisions, b.decisions)},
        {"weights", same(a.weights, b.weights)},
        {"camera", same(a.picture.camera, b.picture.camera) && same(a.seen, b.seen) && a.map_share == b.map_share},
        {"stereo", same(a.stereo_cameras, b.stereo_cameras)},
        {"chunks", std::equal(one.chunks.begin(), one.chunks.end(), other.chunks.begin(), other.chunks.end(), same_chunk)},
        {"depth", same(a.picture.terrain.depth, b.picture.terrain.depth)},
        {"data", same(a.data, b.data) && are_same(a.picture.data, b.picture.data)},
        {"foci", same(a.foci_plan.heights_m, b.foci_plan.heights_m) && same(a.focus, b.focus)},
        {"clutter", same(a.clutter, b.clutter) && same(a.declutter, b.declutter) && same(a.saliency, b.saliency)},
        {"shadows", are_same(a.shadows, b.shadows)},
        {"effects", are_same(a.effects, b.effects)},
        {"budget", same(a.counters, b.counters) && same(a.budget, b.budget) && same(a.panel, b.panel)},
        {"symbology", one.symbology == other.symbology},
        {"signs", one.signs == other.signs}};
    std::string names;
    for (const auto& [name, is_same] : parts)
        if (!is_same) names += std::string(names.empty() ? "" : " ") + name;
    return names;
}

void expect_differences(const Planned& one, const Planned& other, const std::vector<std::string>& parts) {
    const std::string found = " " + differences(one, other) + " ";
    for (const std::string& part : parts)
        EXPECT_NE(found.find(" " + part + " "), std::string::npos) << "control: " << part << " is not among:" << found;
}

TEST(FramePlanner, EqualInputAndCopiesOfOneMemoryGiveEqualFramesAndMemories) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input_at(0));
    const PlannerMemory before = hills->memory;
    const Planned one = planned(*hills, input_at(0.1), before);
    EXPECT_FALSE(one.chunks.empty());
    EXPECT_FALSE(one.symbology.empty());
    EXPECT_EQ(one.after.frames, before.frames + 1);
    static_cast<void>(planned(*hills, input_at(0.2, 1850), one.after));
    EXPECT_EQ(differences(one, planned(*hills, input_at(0.1), before)), "") << "whatever was planned between";
    expect_differences(one, planned(*hills, input_at(0.1, 1900), before),  // from 100 m higher
                       {"memory", "statement", "camera", "chunks", "symbology"});
    Planned without_terrain = planned(*hills, input_at(0.1), before);
    hills->planner().plan_again({true, {}}, without_terrain.after, *without_terrain.frame);
    expect_differences(one, without_terrain, {"memory", "conditions", "decisions", "effects"});
}

TEST(FramePlanner, EqualMeasurementsGiveEqualFramesOfASceneWithAClutterBudget) {
    constexpr double kBudget = 0.08;
    test_support::MemoryBytes scene(test_support::crowd());
    auto hills = std::make_unique<HillsPlanner>(test_support::crowd_design(kBudget), "es3-mid", nullptr, &scene);
    hills->settle(input_at(0, 1500, 40));
    const flight::FrameInput input = input_at(0.5, 1500, 40);
    const PlannerMemory before = hills->memory;
    const std::vector<float> edges = {0.5F, 0, 0.01F};  // in full; with the least detail; with what may suffice
    const Planned one = planned(*hills, input, before, edges);
    EXPECT_EQ(one.frame->clutter.probe, Probe::none);
    EXPECT_FALSE(one.frame->declutter.regions.is_whole()) << "data are reduced";
    EXPECT_FALSE(one.chunks.empty());
    EXPECT_NE(one.frame->picture.data.shown, 0u);
    static_cast<void>(planned(*hills, input_at(1, 1550, 40), one.after, edges));
    EXPECT_EQ(differences(one, planned(*hills, input, before, edges)), "") << "whatever was planned between";
    expect_differences(one, planned(*hills, input, before, {0.01F}), {"memory", "clutter"});  // within the budget
    expect_differences(one, planned(*hills, input_at(0.5, 1600, 40), before, edges), {"memory", "statement", "chunks"});
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

bool states(const PlannedFrame& frame, std::string_view name) {
    return std::any_of(frame.flags.begin(), frame.flags.end(), [&](const Name& flag) { return flag.view() == name; });
}

/// The notices and the flag of the dates: "-" is nothing.
std::string words_of_dates(const PlannedFrame& frame) {
    std::string words = states(frame, "database.out_of_date") ? "flag" : "-";
    for (const policy::Notice& notice : frame.decisions.notices)
        if (notice.text.view().find("DATABASE") == 0) words += ", " + std::string(notice.text.view());
    return words;
}

TEST(FramePlanner, DatabasesOutOfDateAreSaidInTheFramesOfThatTimeAndNothingElseChanges) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    hills->settle(input_at(0));
    const PlannerMemory before = hills->memory;
    const Planned undated = planned(*hills, input_at(0.1), before);
    EXPECT_EQ(words_of_dates(*undated.frame), "-");
    policy::DatabaseDates& dates = hills->planner().settings().database_dates;
    const base::Duration day = base::Duration::seconds(86'400);
    dates.period = {kHillsNow - day, kHillsNow + day};
    EXPECT_EQ(differences(undated, planned(*hills, input_at(0.1), before)), "") << "control: on a day within";
    dates.period = {{}, kHillsNow};
    const Planned expired = planned(*hills, input_at(0.1), before);
    EXPECT_EQ(words_of_dates(*expired.frame), "flag, DATABASE EXPIRED");
    EXPECT_EQ(differences(undated, expired), "statement conditions decisions symbology");
    dates.period = {kHillsNow + day, {}};
    EXPECT_EQ(words_of_dates(*hills->plan(input_at(0.1), hills->memory)), "flag, DATABASE NOT YET VALID");
}

/// A board's time begins with the machine: what was found at the start holds until the bus states UTC, and nothing after it.
TEST(FramePlanner, TheBusDecidesOnTheDatesOfDatabasesAndTheStartUntilThen) {
    auto hills = std::make_unique<HillsPlanner>(test_support::shipped_design("default"));
    policy::DatabaseDates& dates = hills->planner().settings().database_dates;
    dates = {{{}, kHillsNow}, base::Currency::not_yet_valid};
    flight::FrameInput input = input_at(0.1);
    const auto words_at = [&](base::Duration from_end, base::SignalState utc) {
        input.time = base::Time{90'000'000'000};
        input.state.utc = {kHillsNow + from_end - input.time, utc};
        return words_of_dates(*hills->plan(input, hills->memory));
    };
    const base::Duration after = base::Duration::seconds(60), ahead = base::Duration::seconds(-60);
    EXPECT_EQ(words_at(after, base::SignalState::missing), "flag, DATABASE NOT YET VALID");
    EXPECT_EQ(words_at(ahead, base::SignalState::valid), "-");
    EXPECT_EQ(words_at(after, base::SignalState::valid), "flag, DATABASE EXPIRED");
    EXPECT_EQ(words_at(after, base::SignalState::lost), "flag, DATABASE EXPIRED");
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
    PlannerMemory decided;
    const Planned expected = planned(*hills, input_at(0.1), before);
    const std::uint64_t look_key = hills->planner().look_key();
    hills->planner().decide_interval(input_at(0.5, 1900), decided);
    EXPECT_EQ(hills->planner().look_key(), look_key) << "painters need not be told of any design";
    EXPECT_NE(bytes_of(decided.boost), bytes_of(before.boost)) << "control: an interval was decided";
    Planned frame = planned(*hills, input_at(0.1), before);
    EXPECT_EQ(differences(frame, expected), "");
    frame.after.take_interval(decided);
    EXPECT_EQ(frame.after.boost.terrain_ahead(), decided.boost.terrain_ahead());
    EXPECT_EQ(frame.after.frames, before.frames + 1);
    EXPECT_EQ(differences(frame, expected), "memory") << "control: the interval in this memory";
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner
