#include "host_sim/replay/run_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "host_sim/reports/run_folder.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_run_recorder {
namespace {

struct Recording {
    test_support::FlownFiles files;
    ReplayOptions options = files.options("run");
    std::ostringstream results, notes;
    Console console{results, notes, true, false};
    DisplaySession session{options.picture, false};
    FlightPlayer player{{options.log, options.picture.bus, "", options.switch_config}, session.display()};

    [[nodiscard]] base::Time at(double seconds) const { return player.first() + base::Duration::from_seconds(seconds); }
};

TEST(RunRecorder, KeepsOnlyWhatItIsToldToKeep) {
    Recording r;
    RunRecorder recorder(r.options, r.session, r.player);
    static_cast<void>(recorder.draw(r.at(1)));
    recorder.keep();
    static_cast<void>(recorder.draw(r.at(2)));
    static_cast<void>(recorder.draw(r.at(3)));
    recorder.keep();
    EXPECT_EQ(recorder.kept(), 2u);
    recorder.note("a remark");
    EXPECT_EQ(recorder.finish(true, r.console), kInterruptedExitCode);
    const auto hashes = test_support::hashes_by_time(r.options.output);
    EXPECT_EQ(hashes.size(), 2u);
    EXPECT_EQ(hashes.count(3), 1u);
    const auto summary = test_support::summary_of(r.options.output);
    EXPECT_EQ(summary.at("frames"), 2);
    EXPECT_EQ(summary.at("interrupted"), true);
    EXPECT_THAT(summary.at("notes").dump(), ::testing::HasSubstr("a remark"));
    EXPECT_THAT(r.notes.str(), ::testing::StartsWith("note: 1 note in summary.json, the first: a remark\n"));
    EXPECT_EQ(nlohmann::json::parse(r.results.str()), summary) << "the same on stdout with --json";
}

TEST(RunRecorder, AStartWithoutAnApproachShowsCoarseTerrainAndSaysSo) {
    Recording r;
    r.options.strict = true;
    RunRecorder recorder(r.options, r.session, r.player);
    static_cast<void>(recorder.draw(r.at(1)));
    recorder.keep();
    EXPECT_EQ(recorder.finish(false, r.console), 1);
    const auto summary = test_support::summary_of(r.options.output);
    EXPECT_GT(summary.at("worst_start_error_px"), 4);
    EXPECT_EQ(summary.at("worst_error_px"), 0) << "no other frame has terrain";
    ASSERT_EQ(summary.at("warnings").size(), 1u);
    EXPECT_EQ(summary.at("warnings")[0].at("name"), "terrain.start_error");
    EXPECT_THAT(r.notes.str(), ::testing::StartsWith("warning: while the first chunks of "));
}

TEST(RunRecorder, TheHashIsThatOfThePicture) {
    Recording r;
    r.options.frames = FrameOutput::png;
    RunRecorder recorder(r.options, r.session, r.player);
    const FrameResult first = recorder.draw(r.at(1));
    EXPECT_EQ(first.hash, r.session.frame_hash());
    EXPECT_EQ(recorder.draw(r.at(1)).hash, first.hash);
    EXPECT_NE(recorder.draw(r.at(4)).hash, first.hash);
    recorder.keep();
    EXPECT_EQ(recorder.finish(false, r.console), 0);
    EXPECT_EQ(r.notes.str(), "") << "a sound run needs no notes";
    EXPECT_TRUE(std::filesystem::exists(frame_picture_path(r.options.output, 2)));
    EXPECT_FALSE(std::filesystem::exists(frame_picture_path(r.options.output, 1)));
}

TEST(RunRecorder, AnUnfinishedRunLeavesNoRecordsAndAnEarlierRunsPicturesGo) {
    Recording r;
    std::filesystem::create_directories(r.options.output + "/frames");
    r.files.folder.write("run/frames/000042.png", "old");
    r.files.folder.write("run/frames/mine.png", "kept");
    r.files.folder.write("run/frames/000042.txt", "kept");
    {
        RunRecorder recorder(r.options, r.session, r.player);
        static_cast<void>(recorder.draw(r.at(1)));
        recorder.keep();
    }
    EXPECT_FALSE(std::filesystem::exists(r.options.output + "/frames.jsonl"));
    EXPECT_FALSE(std::filesystem::exists(r.options.output + "/frames/000042.png"));
    EXPECT_TRUE(std::filesystem::exists(r.options.output + "/frames/mine.png"));
    EXPECT_TRUE(std::filesystem::exists(r.options.output + "/frames/000042.txt"));
}

TEST(RunRecorder, AFolderThatCannotBeIsRefused) {
    Recording r;
    r.options.output = r.files.log + "/run";
    test_support::expect_user_error([&] { RunRecorder recorder(r.options, r.session, r.player); }, "flight.log");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_recorder
