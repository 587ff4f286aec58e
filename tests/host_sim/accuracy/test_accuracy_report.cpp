#include "host_sim/accuracy/accuracy_report.hpp"

#include <gtest/gtest.h>

#include "host_sim/version.hpp"

namespace tedavis::host_sim::test_accuracy_report {
namespace {

TEST(AccuracyReport, SaysWhatItWasMeasuredWith) {
    const MeasuringConditions now = conditions_now("tedavis accuracy -o x", "a renderer", {"alps.tdb", 7}, true);
    EXPECT_EQ(now.version, version());
    EXPECT_EQ(now.commit, commit());
    EXPECT_EQ(now.renderer, "a renderer");
    EXPECT_EQ(now.terrain, "alps.tdb");
    EXPECT_TRUE(now.is_quick);
    EXPECT_FALSE(now.processor.empty());
    EXPECT_GT(now.processors, 0u);
    ASSERT_EQ(now.date.size(), 20u);
    EXPECT_EQ(now.date.back(), 'Z');
}

TEST(AccuracyReport, OnlyFiguresOfOneKindStandTogether) {
    const MeasuringConditions now = conditions_now("a", "a renderer", {"alps.tdb", 7}, true);
    MeasuringConditions other = now;
    other.load = 9;
    other.date = "2001-01-01T00:00:00Z";
    other.command = "b";
    EXPECT_TRUE(are_of_one_kind(now, other)) << "another day";
    other.is_quick = false;
    EXPECT_FALSE(are_of_one_kind(now, other));
    other = now;
    other.terrain = "copy_of_alps.tdb";
    EXPECT_TRUE(are_of_one_kind(now, other)) << "the same heights";
    other.terrain_identity = 8;
    EXPECT_FALSE(are_of_one_kind(now, other));
    other = now;
    other.program ^= 1;
    EXPECT_FALSE(are_of_one_kind(now, other)) << "another build";
    other = now;
    other.processor = "another";
    EXPECT_FALSE(are_of_one_kind(now, other));
    other = now;
    other.renderer = "another";
    EXPECT_FALSE(are_of_one_kind(now, other));
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_report
