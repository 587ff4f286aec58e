// Ctrl-C while a command still loads its files: it says so and leaves nothing, as it does later.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/command_line.hpp"
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

std::string nothing_in(const std::string& output) { return "interrupted; nothing was written to " + output; }

ConvertOptions conversion(const test_support::TemporaryFolder& folder) {
    ConvertOptions options;
    options.flight = folder.write("flight.igc", test_support::FlownAcross().igc());
    options.assume_geometric = true;
    options.output = folder.file("flight.log");
    return options;
}

TEST(InterruptedStart, AConversionKeepsTheLogOfAnEarlierOne) {
    const test_support::TemporaryFolder folder;
    const ConvertOptions options = conversion(folder);
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    ASSERT_EQ(run_convert(options, console), 0);
    const std::string log = folder.read("flight.log"), companion = folder.read("flight.log.json");
    EXPECT_GT(log.size(), 10'000u) << "control: a whole flight";
    EXPECT_EQ(interruption_of([&](Console& said) { return run_convert(options, said); }), nothing_in(options.output));
    EXPECT_EQ(folder.read("flight.log"), log);
    EXPECT_EQ(folder.read("flight.log.json"), companion);
    EXPECT_EQ(folder.entries(), 3u);
}

/// Neither the control nor knobs that are measured already would ask.
TEST(InterruptedStart, AnAccuracyReportLeavesNothing) {
    const test_support::FlownFiles files;
    AccuracyOptions options;
    options.output = files.folder.file("report");
    options.terrains = {files.terrain};
    options.is_quick = options.is_control_only = true;
    const auto interruption = [&] { return interruption_of([&](Console& console) { return run_accuracy(options, console); }); };
    EXPECT_EQ(interruption(), nothing_in(options.output));
    EXPECT_FALSE(fs::exists(options.output));
    options.is_control_only = false;
    options.knobs = {"ray_halvings"};
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    ASSERT_EQ(run_accuracy(options, console), 0);
    EXPECT_EQ(interruption(), nothing_in(options.output)) << "all its knobs are measured";
}

TEST(InterruptedStart, AReplayLeavesNothing) {
    const test_support::FlownFiles files;
    const ReplayOptions options = files.options("run");
    EXPECT_EQ(interruption_of([&](Console& console) { return run_replay(options, console); }), nothing_in(options.output));
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
    EXPECT_THAT(interruption_of([&](Console& console) { return run_fly(options, console); }),
                ::testing::StartsWith(nothing_in(options.replay.output)));
    EXPECT_FALSE(fs::exists(options.replay.output));
}

/// Whatever it does first; a made-up one, as add_long_command() makes those of the command line.
TEST(InterruptedStart, ACommandThatTakesLongIsGuardedFromItsBeginning) {
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

TEST(InterruptedStart, TheCommandLineSaysItAndEndsWithItsCode) {
    const test_support::FlownFiles files;
    const std::string flight = files.folder.write("flight.igc", test_support::FlownAcross().igc());
    const std::string output = files.folder.file("out");
    using Words = std::vector<const char*>;
    for (Words words : {Words{"convert", flight.c_str(), "--assume-geometric"}, Words{"replay", files.log.c_str()},
                        Words{"fly", flight.c_str(), "--assume-geometric"},
                        Words{"accuracy", "--quick", "--negative-control", "--terrain", files.terrain.c_str()}}) {
        SCOPED_TRACE(words.front());
        words.insert(words.begin(), "tedavis");
        words.insert(words.end(), {"-o", output.c_str()});
        std::ostringstream results, notes;
        const InterruptGuard guard;
        raise(SIGINT);
        EXPECT_EQ(run_command_line(static_cast<int>(words.size()), words.data(), results, notes, false), kInterruptedExitCode);
        EXPECT_THAT(notes.str(), ::testing::HasSubstr("tedavis: " + nothing_in(output)));
        EXPECT_EQ(results.str(), "");
        EXPECT_FALSE(fs::exists(output));
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_interrupted_start
