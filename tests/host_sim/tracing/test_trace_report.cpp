#include "host_sim/tracing/trace_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flown_circle.hpp"

namespace tedavis::host_sim::test_trace_report {
namespace {

TEST(TraceReport, AddsUpBytes) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    TracedShot shot;
    shot.items = {{"one", 1'000'000}, {"two", 500'000}};
    shot.picture_ms = 12.34;
    const auto settings = settings_of(TracePreset::memory);
    const auto json = shot_json(ground, describe(settings), shot, 3);
    EXPECT_EQ(json.at("bytes").at("all"), ground.bytes() + 1'500'000);
    EXPECT_EQ(json.at("bytes").at("two"), 500'000);
    EXPECT_EQ(json.at("workers"), 3);
    EXPECT_EQ(json.at("posts").at("columns"), ground.columns());
    const std::string line = shot_line(ground, describe(settings), shot);
    EXPECT_THAT(line, ::testing::HasSubstr("12.3 ms a picture"));
    EXPECT_THAT(line, ::testing::HasSubstr("two 0.5 MB"));
    EXPECT_EQ(megabytes(12'345'678), "12.3 MB");
}

}  // namespace
}  // namespace tedavis::host_sim::test_trace_report
