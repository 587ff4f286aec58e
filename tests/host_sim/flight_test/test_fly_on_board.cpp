#include "host_sim/flight_test/fly_on_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bus/candump/candump_log_source.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "host_sim/flight_test/step_log.hpp"
#include "tests/host_sim/flight_test/fake_board_port.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_fly_on_board {
namespace {

using test_support::FakeBoardPort;
using ::testing::HasSubstr;

const std::string kSteps =
    "[input]\nlasts_s = 6\n[[step]]\nat_s = 0\nswitch = \"GROUND\"\n[[step]]\nat_s = 2\nswitch = \"CRUISE\"\n[[step]]\nat_s = "
    "3\nstop = [\"pitch\"]\n";
const std::string kReached = "[[expect]]\nafter_s = 2\nwithin_s = 0.2\nstays = true\nphase = \"cruise\"\n";

class FlyOnBoard : public ::testing::Test {
protected:
    FlightTest read(const std::string& text) {
        ScriptFaults faults;
        FlightTest test = read_flight_test(place_.write("a.toml", text), {}, faults);
        EXPECT_THAT(faults.sentences(), ::testing::IsEmpty());
        return test;
    }
    FakeBoardPort& board_of(const FlightTest& test, double rate_hz = 30, bool has_panel = true) {
        board_ = std::make_unique<FakeBoardPort>(test.bus, has_panel ? &test.panel : nullptr, rate_hz);
        return *board_;
    }
    FlightTestResult fly(const FlightTest& test, FakeBoardPort& board) {
        return fly_on_board(test, board, {"/run/records", place_.path(), 30, designs_, [this] { return is_stopped_; }, {}});
    }
    FlightTestResult fly(const std::string& expectations, double rate_hz = 30) {
        const FlightTest test = read(kSteps + expectations);
        return fly(test, board_of(test, rate_hz));
    }
    /// That it does not get to its end, with this sentence.
    void expect_unfinished(FakeBoardPort& board, const FlightTest& test, const std::string& words) {
        test_support::expect_user_error([&] { static_cast<void>(fly(test, board)); }, words);
    }
    test_support::TemporaryFolder place_;
    std::unique_ptr<FakeBoardPort> board_;
    bool is_stopped_ = false;
    std::vector<std::string> designs_;
};

TEST_F(FlyOnBoard, WhatHoldsHolds) {
    const FlightTestResult result =
        fly("[[expect]]\nfrom_s = 0\nto_s = 1.9\nphase = \"ground\"\nphase_source = \"switch\"\n" + kReached +
            "[[expect]]\nat_s = 5\nsignals = { pitch = \"lost\", roll = \"valid\" }\nvalues = { roll_deg = [-0.1, 0.1] }\n");
    EXPECT_TRUE(result.holds()) << (result.holds() ? "" : result.first_failure()->found);
    EXPECT_EQ(result.held(), 3u);
    EXPECT_NEAR(*result.expectations[1].reached_s, 2.07, 0.07) << "30 ms of debouncing, and the next frame";
    EXPECT_TRUE(result.record.empty());
}

/// The negative control.
TEST_F(FlyOnBoard, AWrongExpectationFailsAtItsFirstInstantWithTheRecord) {
    const FlightTestResult result =
        fly("[[expect]]\nfrom_s = 1\nto_s = 4\nphase = \"ground\"\n[[expect]]\nat_s = 5\nphase_source = \"can\"\n");
    EXPECT_EQ(result.failed(), 2u);
    const ExpectationResult* const first = result.first_failure();
    EXPECT_NEAR(first->failed_s, 2.07, 0.07);
    EXPECT_EQ(first->found, "cruise");
    EXPECT_EQ(nlohmann::json::parse(result.record)["phase"], "cruise");
}

/// The desk's log is the oracle.
TEST_F(FlyOnBoard, EachFrameOfTheLogIsSentAtItsTime) {
    const FlightTest test = read(kSteps + kReached);
    FakeBoardPort& board = board_of(test);
    static_cast<void>(fly(test, board));
    const std::string text = place_.read("steps.log");
    bus::CandumpLogSource source({text.data(), text.size()});
    std::vector<bus::CanFrame> log(100'000);
    log.resize(source.read(base::Time{INT64_MAX}, {log.data(), log.size()}));
    ASSERT_LE(board.sent().size(), log.size());
    const base::Duration begun = board.sent().front().time - log.front().time;
    for (std::size_t n = 0; n < board.sent().size(); ++n) {
        ASSERT_EQ(board.sent()[n].id, log[n].id) << n;
        ASSERT_EQ(board.sent()[n].data, log[n].data) << n;
        const double late_s = (board.sent()[n].time - log[n].time - begun).to_seconds();
        ASSERT_TRUE(late_s > -6e-3 && late_s < 6e-3) << n << ": " << late_s;
    }
    EXPECT_GT((board.sent().back().time - board.sent().front().time).to_seconds(), 2.2) << "until the last expectation";
    const auto cruise = std::find_if(board.edges().rbegin(), board.edges().rend(),
                                     [](const bus::SwitchEdge& edge) { return edge.line == 2 && edge.level; });
    ASSERT_NE(cruise, board.edges().rend());
    EXPECT_NEAR((cruise->time - board.sent().front().time).to_seconds(), 2, 6e-3) << "the switch";
    EXPECT_EQ(board.edges().back().line, 6) << "at the end the panel is at rest, on AUTO";
    EXPECT_TRUE(board.edges().back().level);
}

/// A bus that takes half a second is not on time.
TEST_F(FlyOnBoard, ALateBusFails) {
    const FlightTest test = read(
        "[[step]]\nat_s = 2\ninvalid = [\"pitch\"]\n[[expect]]\nafter_s = 2\nwithin_s = 0.3\nsignals = { pitch = \"invalid\" "
        "}\n");
    EXPECT_TRUE(fly(test, board_of(test)).holds());
    FakeBoardPort& late = board_of(test);
    late.bus_delay = base::Duration::milliseconds(500);
    EXPECT_EQ(fly(test, late).failed(), 1u);
}

TEST_F(FlyOnBoard, BeforeItsInputTheStateIsNeutral) {
    const FlightTest first = read("[[step]]\nat_s = 0\nphase = \"cruise\"\n[[expect]]\nat_s = 3\nphase = \"cruise\"\n");
    FakeBoardPort& board = board_of(first);
    EXPECT_TRUE(fly(first, board).holds());
    const std::size_t sent = board.sent().size();
    const FlightTest second = read("[[expect]]\nat_s = 0\nphase = \"unknown\"\nsignals = { pitch = \"lost\" }\n" +
                                   std::string("[[expect]]\nat_s = 1\nsignals = { pitch = \"valid\" }\n"));
    EXPECT_TRUE(fly(second, board).holds()) << "the cruise before it is forgotten";
    const double silence_s = (board.sent()[sent].time - board.sent()[sent - 1].time).to_seconds();
    EXPECT_GE(silence_s, kSilence.to_seconds());
    EXPECT_LT(silence_s, (kSilence + kLongestUnrest).to_seconds());
}

TEST_F(FlyOnBoard, AnotherSenderOnTheBusIsFound) {
    const FlightTest test = read(kSteps + kReached);
    FakeBoardPort& board = board_of(test);
    static_cast<void>(fly(test, board));
    const auto is_pitch = [](const bus::CanFrame& frame) { return frame.id == 311; };
    board.other = *std::find_if(board.sent().begin(), board.sent().end(), is_pitch);
    expect_unfinished(board, test, "the display still has signal pitch valid; end what else sends on its bus");
}

/// A frame each second: where a window has none, nothing is known of it.
TEST_F(FlyOnBoard, AWindowWithoutAFrameDoesNotHold) {
    const FlightTestResult result =
        fly(kReached + "[[expect]]\nat_s = 1\nphase = \"ground\"\n[[expect]]\nfrom_s = 2.5\nto_s = 4\n" + "phase = \"cruise\"\n",
            1.0);
    EXPECT_FALSE(result.expectations[0].holds);
    EXPECT_EQ(result.expectations[0].key, "time");
    EXPECT_THAT(result.expectations[0].reason, HasSubstr("the display had none ready in this time"));
    EXPECT_EQ(result.expectations[2].key, "time") << "its frames are too far from each other";
    EXPECT_THAT(result.expectations[2].found, HasSubstr("none from "));
}

TEST_F(FlyOnBoard, WhatARecordCannotAnswerIsCountedAndDoesNotPass) {
    const FlightTestResult result =
        fly("[[expect]]\nat_s = 1\ntext = { says = \"GROUND\" }\n[[expect]]\nat_s = 1\nphase = \"ground\"\n" +
            std::string("text = { says = \"GROUND\" }\n[[expect]]\nat_s = 1.5\nphase = \"cruise\"\n") +
            "obstacle_alert = \"none\"\n");
    EXPECT_EQ(result.not_judged(), 3u);
    EXPECT_FALSE(result.expectations[0].holds);
    EXPECT_FALSE(result.expectations[0].is_judged);
    EXPECT_TRUE(result.expectations[1].holds);
    EXPECT_FALSE(result.expectations[2].holds);
    EXPECT_EQ(result.held(), 1u);
    EXPECT_EQ(result.failed(), 1u);
}

/// 25 ms from the bus to the screen are 0.75 frames of 30 a second.
TEST_F(FlyOnBoard, LatencyIsThatOfTheScreen) {
    const FlightTestResult result = fly(
        "[[expect]]\nfrom_s = 1\nto_s = 2\nlatency_frames_at_most = 0.8\n[[expect]]\nat_s = 1\nlatency_frames_at_most = 0.7\n");
    EXPECT_TRUE(result.expectations[0].holds);
    EXPECT_EQ(result.expectations[1].found, "0.75 frames");
}

/// While logs are built nobody reads; the socket has room for some records.
TEST_F(FlyOnBoard, RecordsThatPiledUpBeforeAreNoFault) {
    const FlightTest test = read(kSteps + kReached);
    FakeBoardPort& board = board_of(test);
    board.pile_up(40, 26);
    EXPECT_TRUE(fly(test, board).holds());
}

/// Of one condition less it could be reached too early, or hold before.
TEST_F(FlyOnBoard, WhatMustBeReachedIsJudgedWholeOnly) {
    const FlightTestResult result =
        fly("[[expect]]\nafter_s = 2.5\nwithin_s = 1\nphase = \"cruise\"\ntext = { says = \"X\" }\n" +
            std::string("[[expect]]\nafter_s = 2\nwithin_s = 0.3\ntext = { says = \"X\" }\n") + kReached);
    EXPECT_FALSE(result.expectations[0].is_judged) << "the phase alone holds already";
    EXPECT_FALSE(result.expectations[1].is_judged);
    EXPECT_TRUE(result.expectations[2].holds);
    EXPECT_EQ(result.failed(), 0u);
    EXPECT_EQ(result.not_judged(), 3u);
    EXPECT_TRUE(result.record.empty()) << "nothing failed";
}

/// It is known for 30 s, which is longer than the silence.
TEST_F(FlyOnBoard, TheWindOfAnEarlierTestIsWaitedForWhereItIsAskedFor) {
    const FlightTest windy = read(
        "[[step]]\nat_s = 0\nhold = { wind_speed_kt = 20, wind_direction_deg = 90 }\n[[expect]]\nat_s = 3\n"
        "signals = { wind_speed = \"valid\" }\n");
    FakeBoardPort& board = board_of(windy);
    EXPECT_TRUE(fly(windy, board).holds());
    const FlightTest calm = read(
        "[[step]]\nat_s = 0\nstop = [\"wind_speed\", \"wind_direction\"]\n[[expect]]\nat_s = 1\nno_flags = "
        "[\"wind_speed.stale\"]\n"
        "[[expect]]\nat_s = 2\nsignals = { wind_speed = \"lost\" }\n");
    const std::size_t sent = board.sent().size();
    const FlightTestResult result = fly(calm, board);
    EXPECT_TRUE(result.holds()) << (result.holds() ? "" : result.first_failure()->found);
    EXPECT_EQ(result.held(), 2u);
    EXPECT_GT((board.sent()[sent].time - board.sent()[sent - 1].time).to_seconds(), 30);
    const std::size_t again = board.sent().size();
    EXPECT_TRUE(fly(read("[[expect]]\nat_s = 1\nphase = \"unknown\"\n"), board).holds());
    EXPECT_LT((board.sent()[again].time - board.sent()[again - 1].time).to_seconds(), 16) << "nobody asks for it";
}

/// It is known for ten minutes, for which nobody waits.
TEST_F(FlyOnBoard, TheVariationOfAnEarlierTestIsNotJudged) {
    const std::string ask = "[[expect]]\nat_s = 1\nvalues = { magnetic_variation_deg = [4, 6] }\n";
    const FlightTest sends = read("[[step]]\nat_s = 0\nhold = { magnetic_variation_deg = 5 }\n" + ask);
    FakeBoardPort& board = board_of(sends);
    EXPECT_EQ(fly(sends, board).held(), 1u) << "a board that has just been started";
    const FlightTestResult result = fly(read(ask), board);
    EXPECT_FALSE(result.expectations[0].is_judged) << "it would pass by what another test has sent";
    EXPECT_EQ(result.not_judged(), 1u);
}

TEST_F(FlyOnBoard, ALatencyIsNotKnownForLong) {
    const FlightTestResult result =
        fly("[[step]]\nat_s = 3\nstop = [\"all\", \"clock\"]\n[[expect]]\nat_s = 3\nlatency_frames_at_most = 0.8\n" +
            std::string("[[expect]]\nat_s = 5\nlatency_frames_at_most = 0.8\n[[expect]]\nat_s = 2\n") +
            "latency_frames_at_most = 0.1\n");
    EXPECT_TRUE(result.expectations[0].holds);
    EXPECT_FALSE(result.expectations[1].holds);
    EXPECT_EQ(result.expectations[1].found, "not known");
    EXPECT_THAT(result.expectations[2].reason, HasSubstr("from the bus to the screen"));
}

TEST_F(FlyOnBoard, FramesAndEdgesGoOutInTheOrderOfTheirTimes) {
    const FlightTest test = read(kSteps + kReached);
    FakeBoardPort& board = board_of(test);
    board.pause = base::Duration::milliseconds(200);
    board.pause_after = base::Duration::from_seconds(1.9);
    EXPECT_TRUE(fly(test, board).holds());
    const auto cruise = std::find_if(board.edges().rbegin(), board.edges().rend(),
                                     [](const bus::SwitchEdge& edge) { return edge.line == 2 && edge.level; });
    ASSERT_NE(cruise, board.edges().rend());
    const auto same_turn = [&](const bus::CanFrame& frame) { return frame.time == cruise->time; };
    EXPECT_GT(std::count_if(board.sent().begin(), board.sent().end(), same_turn), 2) << "what was due in the pause";
    const std::string& order = board.order();
    const std::size_t last_edge = order.find_last_of('e', order.find_last_of('f'));
    ASSERT_NE(last_edge, std::string::npos);
    const auto after =
        board.sent().begin() + std::count(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(last_edge), 'f');
    EXPECT_EQ(after->time, cruise->time) << "frames of the same turn that were due later go out later";
}

/// A bus that takes half a second for a frame makes the last one late, too.
TEST_F(FlyOnBoard, AFrameThatTheBusTakesLateIsNoPass) {
    const FlightTest test = read("[[expect]]\nat_s = 1\nphase = \"unknown\"\n");
    FakeBoardPort& board = board_of(test);
    board.send_takes = base::Duration::milliseconds(300);
    expect_unfinished(board, test, "at 0.00 s this machine was 0.30 s late");
}

/// The next test, or a pilot, would find them thrown.
TEST_F(FlyOnBoard, SwitchesAreAtRestBehindATestThatDoesNotEnd) {
    const FlightTest test = read(kSteps + "[[expect]]\nat_s = 5\nphase = \"cruise\"\n");
    FakeBoardPort& board = board_of(test);
    board.closes_after = 30 * 18;
    EXPECT_THROW(static_cast<void>(fly(test, board)), BoardLost);
    std::vector<bool> levels(test.panel.lines.size());
    bool was_thrown = false;
    for (const bus::SwitchEdge& edge : board.edges()) {
        levels[edge.line] = edge.level;
        was_thrown = was_thrown || (edge.line == 2 && edge.level);
    }
    EXPECT_TRUE(was_thrown);
    EXPECT_FALSE(levels[2]);
    EXPECT_TRUE(levels[6]) << "AUTO";
}

TEST_F(FlyOnBoard, ADisplayThatGoesIsNoPass) {
    const FlightTest test = read(kSteps + kReached);
    FakeBoardPort& gone = board_of(test);
    gone.closes_after = 30 * 15;
    EXPECT_THROW(static_cast<void>(fly(test, gone)), BoardLost);
    FakeBoardPort& silent = board_of(test);
    silent.silent_after = 30 * 15;
    expect_unfinished(silent, test, "the display said nothing for 20 s");
    FakeBoardPort& missing = board_of(test);
    missing.drops_record = 30 * 15;
    expect_unfinished(missing, test, "after frame 449 came the record of frame 451");
}

/// Else all expectations would pass in the dark.
TEST_F(FlyOnBoard, AScreenThatIsUnpluggedIsNoPass) {
    const FlightTest test = read(kSteps + kReached);
    for (const std::uint64_t dark_after : {std::uint64_t{0}, std::uint64_t{30 * 15}}) {
        FakeBoardPort& board = board_of(test);
        board.dark_after = dark_after;
        expect_unfinished(board, test, "is not on the screen");
    }
}

TEST_F(FlyOnBoard, AnInputThatIsSentLateIsNoPass) {
    const FlightTest test = read("[[expect]]\nat_s = 12\nphase = \"unknown\"\n");
    FakeBoardPort& board = board_of(test);
    board.pause = base::Duration::milliseconds(400);
    expect_unfinished(board, test, "this machine was 0.4");
}

TEST_F(FlyOnBoard, RecordsOfOtherProgramsAreRefused) {
    const FlightTest test = read(kSteps + kReached);
    FakeBoardPort& old = board_of(test);
    old.leaves_out = "monotonic_s";
    expect_unfinished(old, test, "/run/records: its record lacks 'monotonic_s'");
    FakeBoardPort& other = board_of(test);
    other.says = {"hello"};
    expect_unfinished(other, test, "what comes is no record of a frame");
}

TEST_F(FlyOnBoard, ADisplayWithAnotherDesignIsRefused) {
    designs_ = {"default", "cruise"};
    const FlightTest test = read(kSteps + kReached);
    EXPECT_TRUE(fly(test, board_of(test)).holds());
    designs_ = {"cruise"};
    expect_unfinished(board_of(test), test, "the display shows the design 'default', which the board file does not have");
}

TEST_F(FlyOnBoard, SwitchesNeedAPanel) {
    const FlightTest test = read(kSteps + kReached);
    expect_unfinished(board_of(test, 30, false), test, "--panel-lines");
    const FlightTest without = read("[[expect]]\nat_s = 1\nphase = \"unknown\"\n");
    EXPECT_TRUE(fly(without, board_of(without, 30, false)).holds());
}

TEST_F(FlyOnBoard, CtrlCIsNoPass) {
    is_stopped_ = true;
    EXPECT_THROW(static_cast<void>(fly(kReached)), Interrupted);
}

TEST_F(FlyOnBoard, AnExpectationBeyondTheLogIsRefused) {
    const FlightTest steps = read(kSteps + kReached);
    static_cast<void>(fly(steps, board_of(steps)));
    const FlightTest log = read("[input]\nlog = \"./steps.log\"\n[[expect]]\nat_s = 50\nphase = \"ground\"\n");
    expect_unfinished(board_of(log), log, "lies beyond the end of the input");
}

}  // namespace
}  // namespace tedavis::host_sim::test_fly_on_board
