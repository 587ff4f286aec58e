#include "host_sim/comparison/alignment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/user_error.hpp"
#include "tests/host_sim/comparison/made_runs.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_alignment {
namespace {

using ::testing::HasSubstr;

AlignedRuns by(Alignment how, const ComparedRun& a, const ComparedRun& b, std::optional<double> within_m = std::nullopt) {
    AlignmentRequest request;
    request.by = how;
    request.within_m = within_m;
    return aligned(a, b, request);
}

void know_utc(ComparedRun& run, double offset_s) {
    for (ComparedFrame& frame : run.frames) frame.utc_s = frame.time_s + offset_s;
}

TEST(Alignment, TimesOfTheSameLogAreThoseOfASearchThroughAllFrames) {
    const ComparedRun a = made_run("a", 40, 3, 1.7), b = with_log(made_run("b", 25, 10.25, 1.3), "a.log");
    const AlignedRuns runs = aligned(a, b, {});
    EXPECT_EQ(runs.by, Alignment::time);
    std::size_t found = 0;
    for (std::size_t n = 0; n < a.frames.size(); ++n) {
        const double time_s = a.frames[n].time_s;
        for (std::size_t m = 0; m + 1 < b.frames.size(); ++m) {
            const double before_s = b.frames[m].time_s, after_s = b.frames[m + 1].time_s;
            if (time_s < before_s || time_s >= after_s) continue;
            ASSERT_LT(found, runs.instants.size());
            EXPECT_EQ(runs.instants[found].a, n);
            EXPECT_NEAR(runs.instants[found].b, static_cast<double>(m) + (time_s - before_s) / (after_s - before_s), 1e-9);
            EXPECT_NEAR(runs.instants[found].distance_m, 0, 1e-6) << "they fly the same way";
            ++found;
        }
    }
    EXPECT_EQ(found, runs.instants.size());
    EXPECT_GT(found, 10u);
}

TEST(Alignment, EqualTimesAreExact) {
    const ComparedRun a = made_run("a", 40, 0, 0.1);
    const AlignedRuns runs = aligned(a, a, {});
    ASSERT_EQ(runs.instants.size(), 40u);
    for (std::size_t n = 0; n < 40; ++n) EXPECT_EQ(runs.instants[n].b, static_cast<double>(n));
}

TEST(Alignment, NothingLiesInAGap) {
    ComparedRun b = with_log(made_run("b", 20), "a.log");
    b.frames.erase(b.frames.begin() + 6, b.frames.begin() + 14);
    const AlignedRuns runs = aligned(made_run("a", 20), b, {});
    EXPECT_EQ(runs.instants.size(), 12u);
}

/// The clock of the second log began 100 s later.
TEST(Alignment, LogsWithADateAreAlignedByUtc) {
    ComparedRun a = made_run("a", 200), b = made_run("b", 50);
    know_utc(a, 1000);
    know_utc(b, 1100);
    const AlignedRuns runs = by(Alignment::time, a, b);
    EXPECT_THAT(runs.words, HasSubstr("UTC"));
    ASSERT_EQ(runs.instants.size(), 50u);
    EXPECT_EQ(runs.instants[0].a, 100u);
    EXPECT_EQ(runs.instants[0].b, 0);
}

TEST(Alignment, RunsWithoutASharedTimeSayWhatElseThereIs) {
    ComparedRun a = made_run("a", 20), b = made_run("b", 20);
    know_utc(a, 1000);
    test_support::expect_user_error([&] { (void)by(Alignment::time, a, b); }, "b does not know the date");
    know_utc(b, 5000);
    test_support::expect_user_error([&] { (void)by(Alignment::time, a, b); }, "share no time");
    EXPECT_EQ(aligned(a, b, {}).by, Alignment::place) << "by itself it takes the next that fits";
}

TEST(Alignment, LogsWithoutADateAreAlignedByTheirBegin) {
    const AlignedRuns runs = by(Alignment::time, made_run("a", 20), made_run("b", 20));
    EXPECT_EQ(runs.instants.size(), 20u);
    EXPECT_THAT(runs.words, HasSubstr("since each log began"));
}

ComparedRun flown_by_phases(const std::string& name, std::size_t takeoff, double first_s) {
    ComparedRun run = made_run(name, 30, first_s);
    for (std::size_t n = 0; n < run.frames.size(); ++n)
        run.frames[n].phase = n < takeoff ? "ground" : n < takeoff + 5 ? "takeoff.start" : "cruise";
    return run;
}

TEST(Alignment, TakeOffIsTheFirstFrameOfItsPhase) {
    const ComparedRun a = flown_by_phases("a", 4, 0), b = flown_by_phases("b", 10, 500);
    EXPECT_EQ(takeoff_frame(a), 4u);
    const AlignedRuns runs = by(Alignment::takeoff, a, b);
    for (const AlignedInstant& instant : runs.instants) {
        EXPECT_EQ(instant.b, static_cast<double>(instant.a) + 6);
        EXPECT_EQ(instant.axis, static_cast<double>(instant.a) - 4);
    }
    EXPECT_EQ(runs.instants.size(), 24u);
}

/// Standing, then rolling ever faster: 3 m/s more each second.
TEST(Alignment, WithoutThePhaseTheGroundSpeedTellsTheTakeOff) {
    ComparedRun run = made_run("a", 20);
    double north_m = 0;
    for (std::size_t n = 0; n < run.frames.size(); ++n) {
        run.frames[n] = made_frame(n, static_cast<double>(n), north_m, 0);
        north_m += n < 5 ? 0 : 3.0 * static_cast<double>(n - 5);
    }
    EXPECT_EQ(takeoff_frame(run), 12u) << "21 m/s";
    EXPECT_FALSE(takeoff_frame(made_run("b", 20))) << "it flies from the first frame on";
    test_support::expect_user_error([&] { (void)by(Alignment::takeoff, run, made_run("b", 20)); }, "b shows no take-off");
}

TEST(Alignment, PlacesAreTheNearestWhateverTheTime) {
    ComparedRun a = made_run("a", 20), b = made_run("b", 20, 0, 1);
    for (ComparedFrame& frame : b.frames) frame = made_frame(frame.frame, 900 + 2 * frame.time_s, 25 * frame.time_s, 200);
    const AlignedRuns runs = by(Alignment::place, a, b);
    for (const AlignedInstant& instant : runs.instants) {
        EXPECT_NEAR(instant.b, std::min(2.0 * static_cast<double>(instant.a), 19.0), 1e-3);
        EXPECT_NEAR(instant.axis, 0.05 * static_cast<double>(instant.a), 1e-3);
        EXPECT_NEAR(instant.distance_m, instant.a < 10 ? 200 : std::hypot(200, 50 * static_cast<double>(instant.a) - 475), 0.5);
    }
    EXPECT_EQ(runs.instants.size(), 20u);
    test_support::expect_user_error([&] { (void)by(Alignment::place, a, b, 100); }, "--within 300");
}

TEST(Alignment, FlownQuantitiesAreInterpolatedAndOthersAreNot) {
    ComparedRun run = made_run("a", 2);
    run.frames[1].values[kAltitude] = 1100;
    run.frames[1].values[kLabelsPlaced] = 9;
    EXPECT_EQ(value_at(run, 0.25, kAltitude), 1025);
    EXPECT_EQ(value_at(run, 0.25, kLabelsPlaced), 5);
    EXPECT_EQ(value_at(run, 0.75, kLabelsPlaced), 9);
    EXPECT_EQ(value_at(run, 1, kAltitude), 1100);
    EXPECT_TRUE(std::isnan(value_at(run, 0.5, kCrowdedRegions)));
}

TEST(Alignment, ARunThatBeginsInTheClimbDoesNotShowItsTakeOff) {
    ComparedRun climbing = made_run("a", 30);
    for (std::size_t n = 0; n < 12; ++n) climbing.frames[n].phase = "takeoff.first_climb";
    EXPECT_FALSE(takeoff_frame(climbing));
    climbing.frames[0].phase = climbing.frames[1].phase = "unknown";
    EXPECT_FALSE(takeoff_frame(climbing)) << "it climbs already when the phase is first known";
    climbing.frames[2].phase = "takeoff.start";
    EXPECT_EQ(takeoff_frame(climbing), 2u);
    ComparedRun rolling = made_run("b", 30);
    for (std::size_t n = 0; n < 5; ++n) rolling.frames[n].phase = "takeoff.start";
    EXPECT_EQ(takeoff_frame(rolling), 0u);
}

/// The take-off after a landing is in the run, though the first one is not.
TEST(Alignment, ALaterTakeOffIsShown) {
    ComparedRun run = made_run("a", 30);
    for (std::size_t n = 0; n < 30; ++n)
        run.frames[n].phase = n < 5 ? "takeoff.first_climb" : n < 20 ? "approach.landing" : "takeoff.first_climb";
    EXPECT_EQ(takeoff_frame(run), 20u);
}

TEST(Alignment, LogsAreTheSameByWhatTheyHold) {
    ComparedRun a = made_run("out/day", 10), b = made_run("out/night", 10);
    EXPECT_FALSE(is_same_flight(a, b));
    a.log_content = b.log_content = std::make_pair(std::uint64_t{500}, std::uint64_t{7});
    EXPECT_TRUE(is_same_flight(a, b)) << "of one recording flown twice";
    EXPECT_EQ(aligned(a, b, {}).axis, "time of the log");
    b.log_content->second = 8;
    b.log = a.log;
    EXPECT_FALSE(is_same_flight(a, b)) << "the folder was renamed, and another flight has its name";
    a.log_content.reset();
    EXPECT_TRUE(is_same_flight(a, b)) << "the path is all that is left";
}

TEST(Alignment, LogsThatAreGoneAreToldByTheirFramesAndTheirBegin) {
    ComparedRun a = made_run("a", 10), b = made_run("b", 10, 2);
    know_utc(a, 1000);
    know_utc(b, 1000);
    EXPECT_FALSE(is_same_flight(a, b)) << "the number of frames is not known";
    a.can_frames = b.can_frames = 777;
    EXPECT_TRUE(is_same_flight(a, b));
    b.can_frames = 778;
    EXPECT_FALSE(is_same_flight(a, b));
    b.can_frames = 777;
    know_utc(b, 1001);
    EXPECT_FALSE(is_same_flight(a, b));
}

/// Runs 500 km apart, of which neither shows a take-off, with another date each.
TEST(Alignment, ARefusalNamesWhatWouldWorkAlone) {
    ComparedRun a = made_run("a", 20), b = made_run("b", 20, 10'000);
    know_utc(a, 1000);
    know_utc(b, 500'000);
    const auto refusal = [&](std::optional<Alignment> how) -> std::string {
        try {
            (void)aligned(a, b, {how, std::nullopt});
        } catch (const UserError& error) {
            return error.what();
        }
        return {};
    };
    const auto is_named = [](const std::string& text, const char* name) {
        return text.find(std::string("--align ") + name, text.rfind(';')) != std::string::npos;
    };
    for (const std::optional<Alignment> how : {std::optional(Alignment::time), std::optional(Alignment::takeoff), {}}) {
        const std::string text = refusal(how);
        EXPECT_FALSE(is_named(text, "time") || is_named(text, "takeoff")) << text;
        ASSERT_TRUE(is_named(text, "place --within ")) << text;
        const double within_m = std::stod(text.substr(text.rfind("--within ") + 9));
        EXPECT_GT(within_m, 498'000);
        EXPECT_EQ(aligned(a, b, {Alignment::place, within_m}).by, Alignment::place) << "as it says";
    }
    for (ComparedFrame& frame : b.frames) frame.utc_s.reset(), frame.has_place = false;
    EXPECT_THAT(refusal(Alignment::place), HasSubstr("b has no frame with a valid position"));
    for (const std::optional<Alignment> how : {std::optional(Alignment::time), std::optional(Alignment::place), {}})
        EXPECT_THAT(refusal(how), HasSubstr("no other --align aligns these runs either")) << refusal(how);
    know_utc(b, 1000 - 10'000);
    EXPECT_THAT(refusal(Alignment::place), HasSubstr("; --align time aligns them"));
    b = made_run("b", 20, 5);
    EXPECT_THAT(refusal(Alignment::takeoff), HasSubstr("neither a nor b shows a take-off; --align place aligns them"));
}

TEST(Alignment, ADistanceIsRefusedWhereNoPlacesAreAligned) {
    const ComparedRun a = made_run("a", 20);
    test_support::expect_user_error([&] { (void)by(Alignment::time, a, a, 100); }, "--within: --align time takes places");
    test_support::expect_user_error([&] { (void)by(Alignment::takeoff, a, a, 100); }, "leave --within out");
    EXPECT_EQ(by(Alignment::place, a, a, 100).instants.size(), 20u);
}

TEST(Alignment, TheFramesThatAreSkippedAreNotWithoutACounterpart) {
    const ComparedRun a = made_run("a", 8000), b = made_run("b", 100);
    const AlignedRuns runs = by(Alignment::place, a, b);
    EXPECT_EQ(runs.stride_a, 3u);
    EXPECT_EQ(runs.stride_b, 1u);
    EXPECT_EQ(runs.searched, 2667u);
    for (const AlignedInstant& instant : runs.instants) EXPECT_EQ(instant.a % 3, 0u);
    const AlignedRuns all = by(Alignment::place, a, a);
    EXPECT_EQ(all.instants.size(), all.searched);
    EXPECT_EQ(by(Alignment::time, a, b).searched, 8000u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_alignment
