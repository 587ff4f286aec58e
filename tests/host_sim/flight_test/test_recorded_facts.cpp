#include "host_sim/flight_test/recorded_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace tedavis::host_sim::test_recorded_facts {
namespace {

ObservedFrame frame_at(double time_s) {
    ObservedFrame frame;
    frame.time_s = time_s;
    frame.record.phase.phase = flight::phase_from_name("cruise").phase;
    frame.record.phase.source = flight::PhaseSource::can;
    frame.record.design = "cruise";
    return frame;
}

void add_flag(ObservedFrame& frame, const char* name) {
    display::Name flag;
    flag = name;
    ASSERT_TRUE(frame.record.flags.try_push_back(flag));
}

/// "first-last value" of a name.
std::vector<std::string> spans_of(const FactTracks& tracks, FactKind kind, const std::string& name) {
    std::vector<std::string> texts;
    for (const FactSpan& span : tracks.spans())
        if (span.fact.kind == kind && span.fact.name == name)
            texts.push_back((span.from_start ? "[" : "") + std::to_string(std::lround(span.first_s)) + "-" +
                            std::to_string(std::lround(span.last_s)) + (span.to_end ? "]" : "") + " " + span.fact.value);
    return texts;
}

TEST(RecordedFacts, AreThoseThatAScriptCanName) {
    ObservedFrame frame = frame_at(0);
    add_flag(frame, "terrain.missing");
    add_flag(frame, "pitch.lost");
    add_flag(frame, "no.such.flag");
    std::vector<std::string> flags, kinds;
    for (const RecordedFact& fact : facts_of(frame, {}))
        if (fact.kind == FactKind::flag) flags.push_back(fact.name);
    EXPECT_THAT(flags, ::testing::ElementsAre("terrain.missing")) << "the signal's state says that pitch is lost";
    const auto has_alert = [](const std::vector<RecordedFact>& facts) {
        return std::any_of(facts.begin(), facts.end(), [](const RecordedFact& fact) { return fact.kind == FactKind::alert; });
    };
    EXPECT_FALSE(has_alert(facts_of(frame, {})));
    EXPECT_TRUE(has_alert(facts_of(frame, {true, false})));
}

/// As an expectation finds them: "none" is said of a display that watches.
TEST(RecordedFacts, AlertsSayWhetherTheyWereWatchedFor) {
    const auto value = [](const ObservedFrame& frame, FactKind kind) {
        for (const RecordedFact& fact : facts_of(frame, {true, true}))
            if (fact.kind == kind) return fact.value;
        return std::string("no fact");
    };
    ObservedFrame frame = frame_at(0);
    EXPECT_EQ(value(frame, FactKind::alert), "not_watching");
    EXPECT_EQ(value(frame, FactKind::obstacle_alert), "not_watching");
    frame.record.alerts.is_watching = true;
    EXPECT_EQ(value(frame, FactKind::alert), "none");
    EXPECT_EQ(value(frame, FactKind::obstacle_alert), "not_watching") << "the scene has no obstacles";
    frame.has_obstacles = true;
    EXPECT_EQ(value(frame, FactKind::obstacle_alert), "none");
}

TEST(RecordedFacts, AFlagHasSpansWhereItIsGone) {
    FactTracks tracks({});
    for (int n = 0; n < 10; ++n) {
        ObservedFrame frame = frame_at(n);
        if (n >= 3 && n < 6) add_flag(frame, "terrain.missing");
        tracks.take(frame);
    }
    EXPECT_THAT(spans_of(tracks, FactKind::flag, "terrain.missing"),
                ::testing::ElementsAre("[0-2 gone", "3-5 there", "6-9] gone"));
    EXPECT_THAT(spans_of(tracks, FactKind::design, ""), ::testing::ElementsAre("[0-9] cruise"));
}

TEST(RecordedFacts, SignalsThatAreNeverThereAreLeftOut) {
    FactTracks tracks({});
    for (int n = 0; n < 4; ++n) {
        ObservedFrame frame = frame_at(n);
        if (n >= 1) frame.record.signals[static_cast<std::size_t>(flight::Signal::pitch)] = base::SignalState::valid;
        tracks.take(frame);
    }
    EXPECT_THAT(spans_of(tracks, FactKind::signal, "pitch"), ::testing::ElementsAre("[0-0 missing", "1-3] valid"));
    EXPECT_THAT(spans_of(tracks, FactKind::signal, "roll"), ::testing::IsEmpty());
}

/// No design asks for it in between: there is nothing to expect of it.
TEST(RecordedFacts, AnEffectHasGaps) {
    FactTracks tracks({});
    for (int n = 0; n < 6; ++n) {
        ObservedFrame frame = frame_at(n);
        display::EffectRecord haze;
        haze.name = "haze";
        if (n != 2 && n != 3) {
            ASSERT_TRUE(frame.record.effects.try_push_back(haze));
        }
        tracks.take(frame);
    }
    EXPECT_THAT(spans_of(tracks, FactKind::effect, "haze"), ::testing::ElementsAre("[0-1 run", "4-5] run"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_recorded_facts
