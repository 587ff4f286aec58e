#include "host_sim/reports/frame_record_writer.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/frame_result.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_frame_record_writer {
namespace {

TEST(FrameRecordWriter, WritesALineAFrameThatAppearsOnCommit) {
    const test_support::TemporaryFolder folder;
    FrameRecordWriter writer(folder.path(), base::Time{0});
    std::string expected;
    for (std::uint64_t frame = 0; frame < 3; ++frame) {
        const FrameResult result = test_support::frame_result(frame, static_cast<double>(frame));
        writer.write(result);
        expected += frame_record_json(result, base::Time{0}) + "\n";
    }
    EXPECT_EQ(writer.written(), 3u);
    EXPECT_FALSE(std::filesystem::exists(folder.file("frames.jsonl")));
    writer.commit();
    EXPECT_EQ(folder.read("frames.jsonl"), expected);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(FrameRecordWriter, LeavesNothingWithoutACommit) {
    const test_support::TemporaryFolder folder;
    { FrameRecordWriter(folder.path(), base::Time{0}).write(test_support::frame_result(0, 0)); }
    EXPECT_EQ(folder.entries(), 0u);
    test_support::expect_user_error([&] { FrameRecordWriter(folder.file("none"), base::Time{0}); }, "frames.jsonl");
}

}  // namespace
}  // namespace tedavis::host_sim::test_frame_record_writer
