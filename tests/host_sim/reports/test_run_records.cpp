#include "host_sim/reports/run_records.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/run_folders.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_run_records {
namespace {

TEST(RunRecords, ReadsWhatARunWrote) {
    const test_support::TemporaryFolder place;
    test_support::write_run(
        place, "run", [](FrameResult&) {}, 3);
    RunRecords records(place.file("run"));
    for (std::uint64_t n = 0; n < 3; ++n) {
        const auto record = records.next();
        ASSERT_TRUE(record.has_value());
        EXPECT_EQ((*record)["frame"], n);
        EXPECT_EQ(records.line(), n + 1);
    }
    EXPECT_FALSE(records.next().has_value());
}

TEST(RunRecords, SaysWhichLineIsNone) {
    const test_support::TemporaryFolder place;
    test_support::expect_user_error([&] { RunRecords(place.path()); }, "name a folder that replay or fly wrote");
    (void)place.write("frames.jsonl", "");
    test_support::expect_user_error([&] { RunRecords(place.path()); }, "holds no frame");
    (void)place.write("frames.jsonl", "{\"frame\":0,\"hash\":\"1\"}\n{\"frame\":-1,\"hash\":\"1\"}\n");
    RunRecords records(place.path());
    EXPECT_TRUE(records.next().has_value());
    test_support::expect_user_error([&] { (void)records.next(); }, "frames.jsonl:2: no frame record");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_records
