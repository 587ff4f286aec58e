// Ctrl-C while a command still loads its files: it says so and leaves nothing, as it does later.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "host_sim/commands/command_groups.hpp"
#include "host_sim/interrupt.hpp"
#include "tests/support/flights/flown_across.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_interrupted_start {
namespace {

namespace fs = std::filesystem;

/// What the command throws where Ctrl-C is pressed before it has loaded anything.
template <class Command>
std::string interruption_of(Command command) {
    const InterruptGuard of_command_line;
    raise(SIGINT);
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    try {
        static_cast<void>(command(console));
    } catch (const Interrupted& interrupted) {
        return interrupted.what();
    }
    return "none";
}

constexpr const char* kNothing = "nothing was written";

TEST(InterruptedStart, AReplayLeavesNothing) {
    const test_support::FlownFiles files;
    const ReplayOptions options = files.options("run");
    EXPECT_THAT(interruption_of([&](Console& console) { return run_replay(options, console); }), ::testing::EndsWith(kNothing));
    EXPECT_FALSE(fs::exists(options.output));
}

TEST(InterruptedStart, AFlightLeavesNothing) {
    const test_support::FlownFiles files;
    FlyOptions options;
    options.flight.flight = files.folder.write("flight.igc", test_support::FlownAcross().igc());
    options.flight.assume_geometric = true;
    options.terrain.rasters = {files.terrain};
    options.replay.spread = 12;
    options.replay.picture.size = PictureSize{160, 120};
    options.replay.output = files.folder.file("out");
    EXPECT_THAT(interruption_of([&](Console& console) { return run_fly(options, console); }), ::testing::EndsWith(kNothing));
    EXPECT_FALSE(fs::exists(options.replay.output));
}

/// Whatever it does first.
TEST(InterruptedStart, EveryLongCommandIsGuardedFromItsBeginning) {
    CLI::App app;
    CommandLine line;
    bool is_seen = false;
    static_cast<void>(add_long_command(app, line, "fly", "", [&](Console&) {
        raise(SIGINT);
        is_seen = InterruptGuard().requested();
        return 0;
    }));
    app.parse("fly", false);
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    EXPECT_EQ(line.run(console), 0);
    EXPECT_TRUE(is_seen);
}

}  // namespace
}  // namespace tedavis::host_sim::test_interrupted_start
