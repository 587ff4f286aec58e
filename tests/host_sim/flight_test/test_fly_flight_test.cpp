#include "host_sim/flight_test/fly_flight_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/commands/replay.hpp"
#include "host_sim/contract/contract_meter.hpp"
#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "host_sim/flight_test/step_log.hpp"
#include "host_sim/flight_test/text_in_pixels.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_fly_flight_test {
namespace {

const std::string kSteps =
    "[[step]]\nat_s = 0\nswitch = \"GROUND\"\n[[step]]\nat_s = 2\nswitch = \"CRUISE\"\n[[step]]\nat_s = 3\nstop = [\"pitch\"]\n";

class FlyFlightTest : public ::testing::Test {
protected:
    FlightTest read(const std::string& expectations) {
        ScriptFaults faults;
        FlightTest test = read_flight_test(place_.write("a.toml", kSteps + expectations), {}, faults);
        EXPECT_THAT(faults.sentences(), ::testing::IsEmpty());
        return test;
    }
    FlightTestResult fly(const std::string& expectations) {
        const FlyTestSettings settings{place_.path(), true, [this] { return is_stopped_; }};
        return fly_flight_test(read(expectations), display_, settings);
    }
    test_support::TemporaryFolder place_;
    TestDisplay display_;
    bool is_stopped_ = false;
};

TEST_F(FlyFlightTest, WhatHoldsHolds) {
    const FlightTestResult result = fly(
        "[[expect]]\nat_s = 1\nphase = \"ground\"\nphase_source = \"switch\"\n[[expect]]\nafter_s = 2\nwithin_s = 0.2\nphase = "
        "\"cruise\"\n[[expect]]\nat_s = 5\nsignals = { pitch = \"lost\", roll = \"valid\" }\nflags = [\"pitch.lost\"]\n");
    EXPECT_TRUE(result.holds());
    EXPECT_EQ(result.first_failure(), nullptr);
    EXPECT_TRUE(result.picture.empty()) << "nothing is drawn";
    ASSERT_TRUE(result.expectations[1].reached_s);
    EXPECT_NEAR(*result.expectations[1].reached_s, 2.07, 0.07) << "30 ms of debouncing, a step of 20 ms, and the next frame";
}

/// The negative control: a wrong expectation fails at its instant, and the frame is drawn.
TEST_F(FlyFlightTest, AWrongExpectationFailsAtItsFirstInstantWithItsPicture) {
    const FlightTestResult result =
        fly("[[expect]]\nfrom_s = 1\nto_s = 4\nphase = \"ground\"\n[[expect]]\nat_s = 3\nphase_source = \"can\"\n");
    EXPECT_EQ(result.held(), 0u);
    const ExpectationResult* const first = result.first_failure();
    ASSERT_NE(first, nullptr);
    EXPECT_NEAR(first->failed_s, 2.07, 0.07);
    EXPECT_EQ(first->key, "phase");
    EXPECT_EQ(first->found, "cruise");
    EXPECT_EQ(result.picture.substr(1, 3), "PNG");
    const auto record = nlohmann::json::parse(result.record);
    EXPECT_NEAR(record["time_s"].get<double>(), first->failed_s, 1e-9);
    EXPECT_EQ(record["phase"], "cruise");
}

/// A replay of the same logs is the oracle: its records say the same at the same times, and the picture has the same hash.
TEST_F(FlyFlightTest, IsWhatAReplayShows) {
    const FlightTest test = read("[[expect]]\nat_s = 3.5\nphase = \"ground\"\n");
    FlightTestResult result;
    {
        TestDisplay own;  // gone before the replay starts another one
        result = fly_flight_test(test, own, {place_.path(), true, nullptr});
    }
    const auto record = nlohmann::json::parse(result.record);
    ReplayOptions replay;
    replay.log = place_.file("steps.log");
    replay.switches = place_.file("steps.switches");
    replay.output = place_.file("run");
    replay.picture.device = "es2-small";
    replay.frames = FrameOutput::hash;
    replay.to_s = 4;
    ASSERT_EQ(test_support::run_command([&](Console& console) { return run_replay(replay, console); }).code, 0);
    std::istringstream lines(place_.read("run/frames.jsonl"));
    bool is_found = false;
    for (std::string line; std::getline(lines, line);) {
        const auto frame = nlohmann::json::parse(line);
        if (std::abs(frame["time_s"].get<double>() - record["time_s"].get<double>()) > 1e-6) continue;
        is_found = true;
        EXPECT_EQ(frame["phase"], record["phase"]);
        EXPECT_EQ(frame["flags"], record["flags"]);
        EXPECT_EQ(frame["signals"], record["signals"]);
    }
    EXPECT_TRUE(is_found);
}

const char* const kNeverHolds =
    "[[condition]]\nname = \"a\"\nmeasure = \"clutter\"\nmost = 0\n[[condition]]\nname = \"b\"\nmeasure = "
    "\"luminance_contrast\"\nlayer = \"symbology\"\nleast = 21\n[[condition]]\nname = \"c\"\nmeasure = "
    "\"symbology_contrast\"\nleast = 21\n";

/// A replay's pictures and layers of the same instant, measured for the same contract, are the oracle.
TEST_F(FlyFlightTest, AContractMeasuresThePictureThatAReplayWrites) {
    const std::string contract = place_.write("never.toml", kNeverHolds);
    static_cast<void>(fly("[[expect]]\nat_s = 3.5\nphase = \"cruise\"\n"));  // writes its logs, which are flown here
    ScriptFaults faults;
    const FlightTest test = read_flight_test(place_.write("log.toml",
                                                          "[input]\nlog = \"./steps.log\"\nswitch_log = \"./steps.switches\"\n"
                                                          "[[expect]]\nat_s = 3.5\ncontract = \"./never.toml\"\n"),
                                             {}, faults);
    ASSERT_THAT(faults.sentences(), ::testing::IsEmpty());
    FlightTestResult result;
    {
        TestDisplay own;  // gone before the replay starts another one
        std::swap(own, display_);
        result = fly_flight_test(test, own, {place_.path(), false, nullptr});
    }
    ASSERT_EQ(result.failed(), 1u);
    ReplayOptions replay;
    replay.log = place_.file("steps.log");
    replay.switches = place_.file("steps.switches");
    replay.output = place_.file("run");
    replay.picture.device = "es2-small";
    replay.layers = true;
    replay.from_s = 3.4;
    replay.to_s = 3.6;
    ASSERT_EQ(test_support::run_command([&](Console& console) { return run_replay(replay, console); }).code, 0);
    const Contract never = read_contract(contract);
    const FlightRun run = read_flight_run(place_.file("run"));
    PictureMeter meter(settings_of(never));
    bool is_found = false;
    for (const FlightFrame& frame : run.frames) {
        if (std::abs(frame.time_s - result.first_failure()->failed_s) > 1e-6) continue;
        is_found = true;
        for (const ContractReading& one : ContractMeter(never, run).readings(meter, frame)) {
            char value[32];
            std::snprintf(value, sizeof value, " has %.3f (", one.value);
            EXPECT_THAT(result.first_failure()->found, ::testing::HasSubstr(value)) << one.region;
        }
    }
    EXPECT_TRUE(is_found);
}

TEST_F(FlyFlightTest, TheShippedContractOfAPictureHolds) {
    EXPECT_TRUE(fly("[[expect]]\nat_s = 5\ncontract = \"symbology\"\n").holds());
}

/// The controls are the picture without its symbology, and each text at the place of another.
TEST_F(FlyFlightTest, TextsAreSeenWhereTheyAreDrawn) {
    const FlightTest test = read(
        "[[expect]]\nat_s = 6\ntext = [{ says = \"ATTITUDE FAIL\" }, { says = \"PHASE BY SWITCH\" }, { says = \"HDG TRUE\" }]\n");
    const FlyTestSettings settings{place_.path(), false, nullptr};
    EXPECT_TRUE(fly_flight_test(test, display_, settings).holds());
    DisplaySession& session = display_.session_for(test.picture, true);
    int seen = 0;
    const FrameWatcher watcher{[&](const ObservedFrame& frame) {
                                   const RgbaPicture whole = frame.picture->pixels();
                                   session.draw_up_to(display::PictureLayer::labels);
                                   const RgbaPicture bare = upright(session.pixels());
                                   session.draw_up_to(display::PictureLayer::symbology);
                                   for (const PlacedWords& words : frame.words) {
                                       if (words.text.size() < 5) continue;  // tapes cut their numbers
                                       ++seen;
                                       const auto look = [&](const RgbaPicture& picture) {
                                           return faintest_character(picture, words, 0, words.text.size())->correlation;
                                       };
                                       EXPECT_GE(look(whole), kSeenCorrelation) << words.text;
                                       EXPECT_LT(look(bare), kSeenCorrelation) << words.text;
                                   }
                               },
                               nullptr};
    static_cast<void>(watch_flight(test, display_, settings, {0, std::nullopt, {6}}, watcher));
    EXPECT_GE(seen, 6);
}

/// Tests that share a display are what they are on one of their own.
TEST_F(FlyFlightTest, ASharedDisplayKeepsNothing) {
    const std::string wrong = "[[expect]]\nat_s = 3.5\nphase = \"ground\"\n";
    const std::string first = fly(wrong).record;
    static_cast<void>(fly("[[expect]]\nfrom_s = 0\nto_s = 5\nphase_source = \"switch\"\n"));
    const auto again = nlohmann::json::parse(fly(wrong).record), alone = nlohmann::json::parse(first);
    EXPECT_EQ(again["hash"], alone["hash"]);
    EXPECT_EQ(again["flags"], alone["flags"]);
}

/// Whoever watches sees the frames that are judged.
TEST_F(FlyFlightTest, FramesAreWatchedInASpanOrAtTimes) {
    const FlightTest test = read("[[expect]]\nat_s = 6\nphase = \"cruise\"\n");
    const FlyTestSettings settings{place_.path(), false, [this] { return is_stopped_; }};
    std::vector<double> times;
    std::string phases;
    const FrameWatcher watcher{[&](const ObservedFrame& frame) {
                                   times.push_back(frame.time_s);
                                   phases += phase_text(frame.record.phase.phase) + " ";
                               },
                               nullptr};
    const WatchedFlight span = watch_flight(test, display_, settings, {1, 1.5, {}}, watcher);
    ASSERT_EQ(times.size(), span.frames);
    EXPECT_EQ(times.size(), static_cast<std::size_t>(std::lround(0.5 * span.rate_hz)) + 1);
    EXPECT_NEAR(times.front(), 1, 1e-9);
    EXPECT_NEAR(times.back(), 1.5, 1e-9);
    phases.clear();
    static_cast<void>(watch_flight(test, display_, settings, {0, std::nullopt, {1, 4}}, watcher));
    EXPECT_EQ(phases, "ground cruise ");
    test_support::expect_user_error(
        [&] {
            static_cast<void>(watch_flight(test, display_, settings, {0, 90, {}}, watcher));
        },
        "90 s: there is no frame");
    is_stopped_ = true;
    EXPECT_THROW(static_cast<void>(watch_flight(test, display_, settings, {}, watcher)), Interrupted);
}

TEST_F(FlyFlightTest, AnInterruptedTestHasNoResult) {
    is_stopped_ = true;
    EXPECT_THROW(static_cast<void>(fly("[[expect]]\nat_s = 3\nphase = \"cruise\"\n")), Interrupted);
}

TEST_F(FlyFlightTest, AnExpectationBeyondALogIsRefused) {
    FlightTest test = read("[[expect]]\nat_s = 3\nphase = \"cruise\"\n");
    static_cast<void>(fly_flight_test(test, display_, {place_.path(), false, nullptr}));
    test.has_steps = false;
    test.log = place_.file("steps.log");
    test.expectations[0].from_s = test.expectations[0].to_s = 100;
    test_support::expect_user_error(
        [&] {
            static_cast<void>(fly_flight_test(test, display_, {place_.path(), false, nullptr}));
        },
        "lies beyond the end of the input");
}

}  // namespace
}  // namespace tedavis::host_sim::test_fly_flight_test
