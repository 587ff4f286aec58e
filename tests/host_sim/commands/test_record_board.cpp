#include "host_sim/commands/record_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "host_sim/commands/record.hpp"
#include "host_sim/flight_test/recorded_expectations.hpp"
#include "host_sim/flight_test/timed_input.hpp"
#include "tests/host_sim/flight_test/fake_board_port.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_record_board {
namespace {

TEST(RecordBoard, TheLogIsWhatWasHeard) {
    const test_support::TemporaryFolder place;
    test_support::FakeBoardPort board(bus::BusSettings(), nullptr, 10);
    board.other = bus::CanFrame();
    board.other->id = 0x137;
    RecordOptions options;
    options.target = "/s";
    options.output = place.file("a.toml");
    options.for_s = 8;
    std::ostringstream log;
    FactTracks tracks({});
    std::uint64_t frames = 0;
    static_cast<void>(test_support::run_command([&](Console& console) {
        frames = record_board(board, options, log, tracks, console);
        return 0;
    }));
    PlayerFiles files;
    files.log = place.write("a.log", log.str());
    const TimedInput input = read_timed_input(files, bus::SwitchConfig());
    EXPECT_EQ(input.frames.front().id, 0x137u);
    EXPECT_NEAR(input.end_s(), 8, 0.2);
    EXPECT_NEAR(static_cast<double>(frames), 31, 1);
    RecordingRule rule;
    rule.rate_hz = 10;
    EXPECT_FALSE(expectations_of(tracks, rule).list.empty());
}

TEST(RecordBoard, OptionsOfALogAreNoneOfABoard) {
    BoardFile board;
    board.bus = "/b/bus.toml";
    RecordOptions options;
    options.output = "x/a.toml";
    EXPECT_EQ(board_input(options, board).log, "x/a.log");
    EXPECT_EQ(board_input(options, board).picture.bus, "/b/bus.toml");
    options.input = "a.log";
    test_support::expect_user_error([&] { static_cast<void>(board_input(options, board)); }, "a.log beside --target");
    options.input.clear();
    options.at_s = {3};
    test_support::expect_user_error([&] { static_cast<void>(board_input(options, board)); }, "say --for");
    options.at_s.clear();
    options.output = "a.log";
    test_support::expect_user_error([&] { static_cast<void>(board_input(options, board)); }, "the log lies there");
}

/// Both are perhaps edited, and belong to each other.
TEST(RecordBoard, ALogThatIsThereIsKept) {
    const test_support::TemporaryFolder place;
    RecordOptions options;
    options.target = "/s";
    options.board = place.file("nothing.toml");
    options.output = place.file("a.toml");
    place.write("a.log", "(1.0) can0 137#\n");
    const auto run = [&](Console& console) { return run_record(options, console); };
    test_support::expect_user_error([&] { static_cast<void>(test_support::run_command(run)); },
                                    "a.log: is there already, and the log of the bus is written there");
    EXPECT_EQ(place.read("a.log"), "(1.0) can0 137#\n");
    options.yes = true;
    test_support::expect_user_error([&] { static_cast<void>(test_support::run_command(run)); }, "nothing.toml");
}

TEST(RecordBoard, WithoutAnythingToRecordItIsSaid) {
    const test_support::TemporaryFolder place;
    RecordOptions options;
    options.output = place.file("a.toml");
    const auto run = [&](Console& console) { return run_record(options, console); };
    test_support::expect_user_error([&] { static_cast<void>(test_support::run_command(run)); }, "what to record is missing");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

}  // namespace
}  // namespace tedavis::host_sim::test_record_board
