#include "target/self_test/self_test_report.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::target::test_self_test_report {
namespace {

TEST(SelfTestReport, HoldsWhenAllHold) {
    SelfTestReport report;
    EXPECT_FALSE(report.holds()) << "a test that looked at nothing proves nothing";
    report.add("a", true, "");
    report.add_number("b", 1.05, 1, 0.1, "m");
    report.add_count("c", 5, 5, 5);
    EXPECT_TRUE(report.holds());
    EXPECT_EQ(report.find("b")->finding.view(), "1.05 m");
    EXPECT_EQ(report.find("d"), nullptr);
    report.add("d", false, "broken");
    EXPECT_FALSE(report.holds());
}

TEST(SelfTestReport, NumbersOutsideTheToleranceSayWhatWasExpected) {
    SelfTestReport report;
    report.add_number("x", 1.25, 1, 0.1, "deg");
    EXPECT_FALSE(report.find("x")->holds);
    EXPECT_EQ(report.find("x")->finding.view(), "1.25 deg, expected 1 +- 0.1");
    report.add_number("nan", std::nan(""), 1, 1e300, "m");
    EXPECT_FALSE(report.find("nan")->holds);
    report.add_count("few", 4, 5, 6);
    EXPECT_EQ(report.find("few")->finding.view(), "4, expected 5 to 6");
    report.add_count("many", 7, 5, 6);
    EXPECT_FALSE(report.find("many")->holds);
}

TEST(SelfTestReport, ACheckTooManyDoesNotHold) {
    SelfTestReport report;
    for (int n = 0; n < 128; ++n) report.add("x", true, "");
    EXPECT_TRUE(report.holds());
    report.add("x", true, "");
    EXPECT_FALSE(report.holds());
}

}  // namespace
}  // namespace tedavis::target::test_self_test_report
