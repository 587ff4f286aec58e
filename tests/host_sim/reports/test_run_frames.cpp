#include "host_sim/reports/run_frames.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/reports/run_folder.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_run_frames {
namespace {

using test_support::expect_user_error;

struct HashedFrame : RunFrame {
    std::string hash;
};

std::vector<HashedFrame> read(const std::string& folder) {
    return frames_of_run<HashedFrame>(
        folder, [](const RunRecords::Json& record, HashedFrame& frame) { frame.hash = record["hash"].get<std::string>(); });
}

TEST(RunFrames, AreInTheOrderOfTimeWithWhatTheReaderAdds) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directories(place.file("a"));
    place.write("a/frames.jsonl", R"({"frame":0,"hash":"5f","time_s":2,"phase":"approach","sub_phase":"final"})"
                                  "\n"
                                  R"({"frame":1,"hash":"6a","time_s":1.5,"phase":"cruise"})"
                                  "\n"
                                  R"({"frame":7,"hash":"7b","time_s":1.5})"
                                  "\n");
    const auto frames = read(place.file("a"));
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0].frame, 1u);
    EXPECT_EQ(frames[0].phase, "cruise");
    EXPECT_EQ(frames[1].frame, 7u) << "of equal times the one that was written first comes first";
    EXPECT_EQ(frames[1].phase, "");
    EXPECT_EQ(frames[2].time_s, 2);
    EXPECT_EQ(frames[2].hash, "5f");
    EXPECT_EQ(frames[2].phase, "approach.final");
    EXPECT_EQ(frames[2].picture, frame_picture_path(place.file("a"), 0));
}

TEST(RunFrames, WhatIsNoRunIsRefused) {
    const test_support::TemporaryFolder place;
    expect_user_error([&] { (void)read(place.file("none")); }, "name a folder that replay or fly wrote");
    std::filesystem::create_directories(place.file("a"));
    place.write("a/frames.jsonl", "{\"frame\":0,\"hash\":\"5f\",\"time_s\":null}\n");
    expect_user_error([&] { (void)read(place.file("a")); }, "frames.jsonl:1: a record without time_s");
}

TEST(RunFrames, TheSummaryMayBeMissingButNotDamaged) {
    const test_support::TemporaryFolder place;
    EXPECT_TRUE(summary_of_run(place.path()).is_null());
    place.write("summary.json", R"({"design": "cruise"})");
    EXPECT_EQ(summary_of_run(place.path())["design"], "cruise");
    place.write("summary.json", "[]");
    expect_user_error([&] { (void)summary_of_run(place.path()); }, "summary.json: no summary of a run");
}

TEST(RunFrames, FilesAreFoundFromTheFolderInWhichTheCommandRan) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directories(place.file("work/out/a"));
    place.write("work/alps.tdb", "x");
    EXPECT_EQ(file_of_run(place.file("work/out/a"), "alps.tdb"), std::filesystem::canonical(place.file("work/alps.tdb")));
    EXPECT_EQ(file_of_run(place.file("work/out/a"), place.file("work/alps.tdb")), place.file("work/alps.tdb"));
    std::filesystem::create_directories(place.file("work/out/a/data"));
    place.write("work/out/a/data/alps.tdb", "x");
    EXPECT_EQ(file_of_run(place.file("work/out/a"), "data/alps.tdb"),
              std::filesystem::canonical(place.file("work/out/a/data/alps.tdb")));
    EXPECT_FALSE(file_of_run(place.file("work/out/a"), "gone.tdb"));
    EXPECT_FALSE(file_of_run(place.file("work/out/a"), place.file("alps.tdb")));
    EXPECT_FALSE(file_of_run(place.file("work/out/a"), "data")) << "a folder is no file";
    EXPECT_FALSE(file_of_run(place.file("work/out/a"), ""));
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_frames
