#include "host_sim/accuracy/accuracy_report.hpp"

#include <gtest/gtest.h>

#include "host_sim/version.hpp"

namespace tedavis::host_sim::test_accuracy_report {
namespace {

MeasuringConditions conditions() {
    MeasuredInputs inputs;
    inputs.terrain = "alps.tdb";
    inputs.terrain_identity = 7;
    inputs.flight = "f.log";
    inputs.flight_identity = 5;
    inputs.is_quick = true;
    return conditions_now("tedavis accuracy -o x", "a renderer", inputs);
}

TEST(AccuracyReport, SaysWhatItWasMeasuredWith) {
    const MeasuringConditions now = conditions();
    EXPECT_EQ(now.version, version());
    EXPECT_EQ(now.commit, commit());
    EXPECT_EQ(now.renderer, "a renderer");
    EXPECT_EQ(now.terrain, "alps.tdb");
    EXPECT_EQ(now.flight, "f.log");
    EXPECT_TRUE(now.is_quick);
    EXPECT_FALSE(now.processor.empty());
    EXPECT_GT(now.processors, 0u);
    ASSERT_EQ(now.date.size(), 20u);
    EXPECT_EQ(now.date.back(), 'Z');
}

TEST(AccuracyReport, OnlyFiguresOfOneKindStandTogether) {
    const MeasuringConditions now = conditions();
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
    other.flight = "copy_of_f.log";
    EXPECT_TRUE(are_of_one_kind(now, other)) << "the same flight";
    other.flight_identity = 6;
    EXPECT_FALSE(are_of_one_kind(now, other));
    other = now;
    other.display_identity = 1;
    EXPECT_FALSE(are_of_one_kind(now, other)) << "another size, device or design";
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
