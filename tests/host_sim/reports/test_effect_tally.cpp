#include "host_sim/reports/effect_tally.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tedavis::host_sim::test_effect_tally {
namespace {

using display::EffectRecord;
using display::EffectState;

EffectRecord recorded(const char* name, EffectState state, const char* reason, double bound = 0) {
    EffectRecord record;
    record.name = display::Name(name);
    record.state = state;
    record.reason.append(reason);
    record.bound = bound;
    return record;
}

display::FrameRecord frame_with(std::initializer_list<EffectRecord> effects) {
    display::FrameRecord record;
    for (const EffectRecord& effect : effects) EXPECT_TRUE(record.effects.try_push_back(effect));
    return record;
}

EffectTally three_frames() {
    EffectTally tally;
    tally.add(frame_with({recorded("haze", EffectState::run, ""), recorded("blur", EffectState::skipped, "too small", 0.001)}));
    tally.add(frame_with({recorded("blur", EffectState::skipped, "too small", 0.003)}));
    tally.add(frame_with({recorded("haze", EffectState::replaced, "the device lacks it"),
                          recorded("blur", EffectState::skipped, "the time does not suffice")}));
    return tally;
}

TEST(EffectTally, CountsEachEffectInTheFramesThatAskForIt) {
    const EffectTally tally = three_frames();
    ASSERT_EQ(tally.counts().size(), 2u);
    const EffectCount &haze = tally.counts()[0], &blur = tally.counts()[1];
    EXPECT_EQ(haze.name, "haze");
    EXPECT_EQ(haze.asked, 2u) << "the second frame did not ask for it";
    EXPECT_EQ(haze.run, 1u);
    EXPECT_EQ(haze.replaced, 1u);
    EXPECT_EQ(haze.skipped, 0u);
    EXPECT_EQ(blur.asked, 3u);
    EXPECT_EQ(blur.skipped, 3u);
    ASSERT_EQ(blur.reasons.size(), 2u);
    EXPECT_EQ(blur.reasons[0].text, "too small");
    EXPECT_EQ(blur.reasons[0].frames, 2u);
    EXPECT_EQ(blur.reasons[1].frames, 1u);
    EXPECT_EQ(blur.bound, 0.003);
    EXPECT_TRUE(EffectTally{}.counts().empty());
}

TEST(EffectTally, CountsAFrameOnceWhereSeveralElementsAskForOneEffect) {
    EffectTally tally;
    tally.add(frame_with({recorded("data.tube", EffectState::skipped, "too small"), recorded("data.tube", EffectState::run, ""),
                          recorded("data.tube", EffectState::run, "")}));
    tally.add(frame_with(
        {recorded("data.tube", EffectState::skipped, "too small"), recorded("data.tube", EffectState::skipped, "too small")}));
    ASSERT_EQ(tally.counts().size(), 1u);
    EXPECT_EQ(tally.counts()[0].asked, 2u);
    EXPECT_EQ(tally.counts()[0].run, 1u);
    EXPECT_EQ(tally.counts()[0].skipped, 1u);
    EXPECT_EQ(tally.counts()[0].reasons[0].frames, 1u);
}

TEST(EffectTally, OnlyTheWorkOfFramesWithoutTheEffectIsWorkForNothing) {
    EffectRecord drawn = recorded("blur", EffectState::run, ""), left_out = recorded("blur", EffectState::skipped, "too small");
    drawn.draws = 7;
    EffectTally tally;
    tally.add(frame_with({drawn}));
    tally.add(frame_with({left_out}));
    EXPECT_EQ(tally.counts()[0].skipped_work, 0u);
    left_out.draws = 1;
    left_out.passes = 2;
    left_out.bytes = 30;
    tally.add(frame_with({left_out}));
    EXPECT_EQ(tally.counts()[0].skipped_work, 33u) << "control: a frame that did work for an effect that it left out";
}

TEST(EffectTally, CountsAreReadAsTheyWereWritten) {
    const EffectTally tally = three_frames();
    for (const EffectCount& count : tally.counts()) {
        const nlohmann::ordered_json json = effect_count_json(count);
        EXPECT_EQ(effect_count_json(effect_count_from(json)), json);
    }
    EXPECT_THROW(static_cast<void>(effect_count_from(nlohmann::ordered_json::object())), nlohmann::json::exception);
}

}  // namespace
}  // namespace tedavis::host_sim::test_effect_tally
