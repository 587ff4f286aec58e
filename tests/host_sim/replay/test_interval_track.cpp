// Intervals: what was decided comes back bit by bit, from the nearest one that is kept, and every byte of the file counts.
#include "host_sim/replay/interval_track.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace tedavis::host_sim::test_interval_track {
namespace {

display::PlannerMemory decided(std::int64_t interval) {
    display::PlannerMemory memory;
    memory.labels.labels.interval = interval;
    memory.labels.labels.has_memory = true;
    memory.labels.labels.changes_left = 0.1 * static_cast<double>(interval);
    for (std::int64_t n = 0; n < interval % 200; ++n) {
        draw::Label label;
        label.key = static_cast<draw::LabelKey>(interval * 7 + n);
        EXPECT_TRUE(memory.labels.labels.labels.try_push_back(label));
    }
    return memory;
}

IntervalTrack track_to(std::int64_t last) {
    IntervalTrack track;
    for (std::int64_t interval = 100; interval <= last; ++interval) track.keep(interval, decided(interval));
    return track;
}

bool is_of(const display::PlannerMemory& memory, std::int64_t interval) {
    const display::PlannerMemory expected = decided(interval);
    const draw::LabelMemory &a = memory.labels.labels, &b = expected.labels.labels;
    if (a.interval != b.interval || a.changes_left != b.changes_left || a.labels.size() != b.labels.size()) return false;
    for (std::size_t n = 0; n < a.labels.size(); ++n)
        if (a.labels[n].key != b.labels[n].key) return false;
    return a.has_memory;
}

TEST(IntervalTrack, TheNearestKeptOneBeforeAnIntervalComesBack) {
    const IntervalTrack track = track_to(1000);
    EXPECT_FALSE(track.last_by(99));
    EXPECT_FALSE(track.last_by(111)) << "the first packed one is 112";
    for (std::int64_t interval = 112; interval <= 1100; ++interval) {
        const auto last = track.last_by(interval);
        ASSERT_TRUE(last);
        EXPECT_LE(*last, interval);
        EXPECT_LT(std::min<std::int64_t>(interval, 1000) - *last, IntervalTrack::kEvery);
        EXPECT_TRUE(is_of(track.restore(*last), *last)) << *last;
    }
    EXPECT_FALSE(is_of(track.restore(112), 128)) << "control";
    EXPECT_EQ(track.last_by(1000), 1000);
}

TEST(IntervalTrack, GoingBackNeedsFewDecisions) {
    IntervalTrack track = track_to(1000);
    int decisions = 0;
    for (std::int64_t wanted = 1000; wanted >= 200; --wanted) {
        for (std::int64_t interval = *track.last_by(wanted) + 1; interval <= wanted; ++interval, ++decisions)
            track.keep(interval, decided(interval));
        ASSERT_EQ(track.last_by(wanted), wanted);
        ASSERT_TRUE(is_of(track.restore(wanted), wanted));
    }
    EXPECT_LT(decisions, 2 * 800);
}

TEST(IntervalTrack, AFileGivesThePackedOnesBack) {
    const IntervalTrack track = track_to(1000);
    const auto back = unpack_intervals(pack_intervals(track, "a design"), "a design");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->packed(), track.packed());
    EXPECT_TRUE(is_of(back->restore(992), 992));
    EXPECT_EQ(back->last_by(1000), 992);
}

TEST(IntervalTrack, AlertsOfAllIntervalsComeBackAndNoOthersAreKnown) {
    IntervalTrack track = track_to(1000);
    for (const std::int64_t unknown : {99, 1001}) EXPECT_FALSE(track.alert(unknown)) << unknown;
    track.keep(1002, decided(1002));
    EXPECT_FALSE(track.alert(1002)) << "nobody knows what lies between";
    const auto back = unpack_intervals(pack_intervals(track, "a design"), "a design");
    ASSERT_TRUE(back);
    for (std::int64_t interval = 100; interval <= 1000; ++interval)
        ASSERT_EQ(back->alert(interval), decided(interval).boost.terrain_ahead());
    EXPECT_FALSE(back->alert(1001));
    track.clear();
    EXPECT_FALSE(track.alert(500));
}

TEST(IntervalTrack, AnotherOriginOrAChangedByteIsRefused) {
    const std::string bytes = pack_intervals(track_to(300), "a design");
    EXPECT_FALSE(unpack_intervals(bytes, "another design"));
    EXPECT_FALSE(unpack_intervals("", "a design"));
    for (std::size_t n = 0; n < bytes.size(); n += 1 + bytes.size() / 300) {
        std::string changed = bytes;
        changed[n] = static_cast<char>(changed[n] ^ 4);
        EXPECT_FALSE(unpack_intervals(changed, "a design")) << n;
        EXPECT_FALSE(unpack_intervals(bytes.substr(0, n), "a design")) << n;
    }
    EXPECT_TRUE(unpack_intervals(bytes, "a design")) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_interval_track
