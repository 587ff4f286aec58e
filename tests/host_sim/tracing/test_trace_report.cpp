#include "host_sim/tracing/trace_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flights/flown_circle.hpp"

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
    EXPECT_EQ(json.at("paged"), false);
    EXPECT_FALSE(json.contains("paging"));
    EXPECT_THAT(line, ::testing::Not(::testing::HasSubstr("paged")));
    EXPECT_EQ(megabytes(12'345'678), "12.3 MB");
    EXPECT_EQ(megabytes_up(12'300'001), "12.4");
    EXPECT_EQ(megabytes_up(12'300'000), "12.3");
}

TEST(TraceReport, SaysHowGroundWasPaged) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers, {1000, {settings_of(TracePreset::time)}});
    TracedShot shot;
    shot.items = {{"rays", 500'000}};
    PagedUse& use = shot.paged.emplace();
    use.held_bytes = 1'500'000;
    use.read_bytes = 900'000;
    use.chunks = 49;
    use.slots = 12;
    use.chunks_read = 41;
    const auto json = shot_json(ground, "any", shot, 1);
    EXPECT_EQ(json.at("paged"), true);
    EXPECT_EQ(json.at("bytes").at("heights"), 1'500'000);
    EXPECT_EQ(json.at("bytes").at("all"), 2'000'000);
    EXPECT_EQ(json.at("paging").at("chunks_read"), 41);
    EXPECT_EQ(json.at("paging").at("held_bytes"), 1'500'000);
    EXPECT_FALSE(json.at("posts").contains("void")) << "it is not known";
    EXPECT_THAT(shot_line(ground, "any", shot),
                ::testing::HasSubstr("; paged: 41 chunks read (0.9 MB) of 49, 12 in memory at a time"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_trace_report
