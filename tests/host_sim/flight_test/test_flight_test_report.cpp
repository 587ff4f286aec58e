#include "host_sim/flight_test/flight_test_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/flight_test/input_logs.hpp"

namespace tedavis::host_sim::test_flight_test_report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<FlownTest> sample_tests() {
    FlownTest one;
    one.test.path = "a.toml";
    one.test.title = "A & B";
    one.test.expectations.resize(2);
    one.test.expectations[0].name = "first";
    one.test.expectations[0].file = one.test.expectations[1].file = "a.toml";
    one.test.expectations[1].name = "says \"<x>\"";
    one.test.expectations[1].line = 7;
    one.result.expectations.resize(2);
    one.result.expectations[0].holds = true;
    one.result.expectations[0].reached_s = 1.5;
    one.result.expectations[1] = {false, std::nullopt, 2.5, "phase", "cruise", "ground", "why"};
    one.result.shown = 1;
    one.result.shown_s = 2.5;
    one.picture = "out/a.png";
    return {one};
}

TEST(FlightTestReport, TheTableHasCountsAndTheFirstFailure) {
    const std::string text = flight_tests_text(sample_tests());
    EXPECT_THAT(text, HasSubstr("a.toml             2     1       1\n"));
    EXPECT_THAT(text, HasSubstr("a.toml:7: at 2.500 s phase: expected cruise, found ground (why)\n"));
    EXPECT_THAT(text, HasSubstr("out/a.png shows 2.500 s (a.toml:7)\n"));
    EXPECT_THAT(text, HasSubstr("1 of 2 expectations hold"));
}

TEST(FlightTestReport, EachFailureIsToldWithItsTime) {
    auto tests = sample_tests();
    tests[0].test.expectations[0].kind = WindowKind::within;
    tests[0].test.expectations[0].from_s = 1;
    tests[0].test.expectations[0].to_s = 3;
    tests[0].result.expectations[0] = {false, std::nullopt, 3, "design", "cruise", "default", ""};
    const std::string text = flight_tests_text(tests);
    EXPECT_THAT(text,
                HasSubstr("at 3.000 s design: expected cruise, found default; it was to be reached from 1.000 s to 3.000 s\n"));
    EXPECT_THAT(text, HasSubstr("a.toml:7: at 2.500 s phase"));
}

/// Its sentence says already what was to be reached.
TEST(FlightTestReport, WhatHoldsTooEarlyIsToldOnce) {
    auto tests = sample_tests();
    tests[0].test.expectations[0].kind = WindowKind::within;
    tests[0].result.expectations[0] = {false, std::nullopt, 3, "after_s", "what begins after 3 s", "it holds already", "why"};
    EXPECT_THAT(flight_tests_text(tests), HasSubstr("after_s: expected what begins after 3 s, found it holds already (why)\n"));
}

/// A script that is wrong was not flown; one that Ctrl-C ended is not wrong.
TEST(FlightTestReport, FaultsOfScriptsAreNotThoseOfTheFlight) {
    std::vector<FlownTest> tests(3);
    tests[0].test.path = tests[1].test.path = "a.toml";
    tests[0].fault = tests[1].fault = "a.toml:1: no frame lies there";
    tests[0].is_wrong = tests[1].is_wrong = true;
    tests[2].test.path = "c.toml";
    tests[2].fault = kTestInterrupted;
    const std::string text = flight_tests_text(tests);
    EXPECT_THAT(text, HasSubstr("a.toml  is wrong: a.toml:1: no frame lies there\n"));
    EXPECT_THAT(text, HasSubstr("c.toml  interrupted\n"));
    EXPECT_THAT(text, HasSubstr("0 of 3 scripts are judged, 2 scripts are wrong, 1 script was not flown to its end\n"));
    const std::string xml = flight_tests_junit(tests);
    EXPECT_THAT(xml, HasSubstr("<error message=\"is wrong: a.toml:1: no frame lies there\"/>"));
    EXPECT_THAT(xml, HasSubstr("<error message=\"interrupted; a flight test that was not flown to its end has not passed\"/>"));
    tests.resize(1);
    EXPECT_THAT(flight_tests_text(tests), HasSubstr("0 of 1 script is judged, 1 script is wrong\n"));
}

TEST(FlightTestReport, TheJsonHasAll) {
    const auto json = flight_tests_json(sample_tests());
    EXPECT_EQ(json["holds"], false);
    const auto& expectations = json["tests"][0]["expectations"];
    EXPECT_EQ(expectations[0]["reached_s"], 1.5);
    EXPECT_FALSE(expectations[0].contains("found"));
    EXPECT_EQ(expectations[1]["failed_s"], 2.5);
    EXPECT_EQ(expectations[1]["found"], "ground");
    EXPECT_EQ(json["tests"][0]["picture"], "out/a.png");
}

std::vector<FlownTest> board_tests() {
    auto tests = sample_tests();
    tests[0].result.expectations[1] = {};
    tests[0].result.expectations[1].is_judged = false;
    tests[0].result.expectations[1].not_judged = 2;
    tests[0].picture.clear();
    FlownTest left, ended;
    left.test.path = "b.toml";
    left.left_out = "is one of another terrain";
    ended.test.path = "c.toml";
    ended.fault = "the display is gone";
    tests.push_back(left);
    tests.push_back(ended);
    return tests;
}

TEST(FlightTestReport, WhatABoardCannotJudgeIsSaid) {
    const std::string text = flight_tests_text(board_tests());
    EXPECT_THAT(text, HasSubstr("a.toml             2     1       0\n  2 conditions are not judged on a board\n"));
    EXPECT_THAT(text, HasSubstr("b.toml  left out: it is one of another terrain\n"));
    EXPECT_THAT(text, HasSubstr("c.toml  was not flown to its end, and has not passed: the display is gone\n"));
    EXPECT_THAT(text, HasSubstr("1 of 2 expectations hold, 1 of 3 scripts are judged, 2 conditions are not judged on a board, 1 "
                                "script is left out, 1 script was not flown to its end\n"));
    const auto json = flight_tests_json(board_tests());
    EXPECT_EQ(json["holds"], false) << "of the one that did not end";
    EXPECT_EQ(json["tests"][0]["holds"], true);
    EXPECT_EQ(json["tests"][0]["not_judged"], 2);
    EXPECT_TRUE(json["tests"][0]["expectations"][1]["holds"].is_null());
    EXPECT_TRUE(json["tests"][1]["holds"].is_null());
    EXPECT_EQ(json["tests"][2]["holds"], false);
    EXPECT_EQ(json["tests"][0]["expectations"][1]["judged"], false);
    EXPECT_FALSE(json["tests"][0]["expectations"][1].contains("found"));
    EXPECT_EQ(json["tests"][1]["left_out"], "is one of another terrain");
    EXPECT_EQ(json["tests"][2]["fault"], "the display is gone");
    const std::string xml = flight_tests_junit(board_tests());
    EXPECT_THAT(xml, HasSubstr("<skipped message=\"not judged on a board\"/>"));
    EXPECT_THAT(xml, HasSubstr("<skipped message=\"is one of another terrain\"/>"));
    EXPECT_THAT(xml, HasSubstr("<error message=\"was not flown to its end, and has not passed: the display is gone\"/>"));
}

/// What nobody has looked at neither holds nor fails.
TEST(FlightTestReport, WithoutAnyThatIsJudgedNothingHolds) {
    auto tests = board_tests();
    tests.pop_back();
    EXPECT_EQ(flight_tests_json(tests)["holds"], true);
    tests[0].result.expectations[0] = tests[0].result.expectations[1];
    EXPECT_FALSE(tests[0].holds());
    EXPECT_TRUE(flight_tests_json(tests)["holds"].is_null());
    EXPECT_TRUE(flight_tests_json(tests)["tests"][0]["holds"].is_null());
    EXPECT_EQ(judged_tests(tests), 0u);
    EXPECT_THAT(flight_tests_text(tests), HasSubstr("0 of 2 expectations hold, 0 of 2 scripts are judged"));
}

TEST(FlightTestReport, JUnitIsEscapedAndCounts) {
    const std::string xml = flight_tests_junit(sample_tests());
    EXPECT_THAT(xml, HasSubstr("<testsuite name=\"A &amp; B\" tests=\"2\" failures=\"1\" errors=\"0\">"));
    EXPECT_THAT(xml, HasSubstr("name=\"first\" file=\"a.toml\" line=\"0\"/>"));
    EXPECT_THAT(xml, HasSubstr("name=\"says &quot;&lt;x&gt;&quot;\""));
    EXPECT_THAT(xml, HasSubstr("<failure message=\"at 2.500 s phase: expected cruise, found ground (why)\">"));
    EXPECT_THAT(xml, Not(HasSubstr("<x>")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_test_report
