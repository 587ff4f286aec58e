#include "host_sim/flight_test/input_logs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/flight_test/read_flight_test.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_input_logs {
namespace {

using ::testing::HasSubstr;

FlightTest read(const test_support::TemporaryFolder& place, const std::string& text) {
    ScriptFaults faults;
    return read_flight_test(place.write("a.toml", text), {}, faults);
}

TEST(InputLogs, StepsAreWrittenAndLogsAreNamed) {
    const test_support::TemporaryFolder place;
    const FlightTest steps = read(place, "[[step]]\nat_s = 1\nswitch = \"CRUISE\"\n[[expect]]\nat_s = 2\nphase = \"cruise\"\n");
    const PlayerFiles written = test_input_files(steps, place.path());
    EXPECT_THAT(place.read("steps.switches"), HasSubstr("panel.CRUISE 1"));
    EXPECT_EQ(written.switches, place.file("steps.switches"));
    const FlightTest log = read(place, "[input]\nlog = \"./steps.log\"\n[[expect]]\nat_s = 2\nphase = \"cruise\"\n");
    EXPECT_EQ(test_input_files(log, "/nowhere").log, log.log);
    EXPECT_EQ(test_input_files(log, "/nowhere").switches, "");
}

TEST(InputLogs, ExpectationsBeyondTheEndAreNamed) {
    const test_support::TemporaryFolder place;
    const FlightTest test = read(place, "[[expect]]\nat_s = 2\nphase = \"cruise\"\n[[expect]]\nat_s = 3\nphase = \"cruise\"\n");
    require_within_input(test, 3, {});
    test_support::expect_user_error([&] { require_within_input(test, 2.5, {}); }, "a.toml:4: this [[expect]] lies beyond");
}

/// Neither can hold, whatever the display shows. At 30 frames a second the next one after 3 s comes 0.0334 s later.
TEST(InputLogs, TimesWithoutAFrameAreNamed) {
    const test_support::TemporaryFolder place;
    const std::string phase = "phase = \"cruise\"\n";
    const auto refused = [&](const std::string& window, double rate_hz, const std::string& words) {
        const FlightTest test = read(place, "[[expect]]\n" + window + phase);
        test_support::expect_user_error([&] { require_within_input(test, 10, {rate_hz}); }, words);
        require_within_input(test, 10, {});  // on a board frames come when they come
    };
    const auto taken = [&](const std::string& window, double rate_hz) {
        require_within_input(read(place, "[[expect]]\n" + window + phase), 10, {rate_hz});
    };
    refused("after_s = 3\nwithin_s = 0.01\n", 30,
            "a.toml:1: no frame lies within 0.01 s after 3 s: the device shows 30 a second; say within_s = 0.034 or more");
    refused("after_s = 3\nwithin_s = 0.033\n", 30, "say within_s = 0.034 or more");
    taken("after_s = 3\nwithin_s = 0.034\n", 30);
    refused("from_s = 3.01\nto_s = 3.02\n", 30,
            "no frame lies from 3.01 s to 3.02 s: the device shows 30 a second; say to_s = 3.034 or more");
    taken("from_s = 3.01\nto_s = 3.034\n", 30);
    taken("from_s = 3\nto_s = 3\n", 30);
    refused("after_s = 3\nwithin_s = 0.09\n", 10, "say within_s = 0.1 or more");
    taken("after_s = 3\nwithin_s = 0.1\n", 10);
}

TEST(InputLogs, AFrameAfterTheEndIsNone) {
    const test_support::TemporaryFolder place;
    const FlightTest test = read(place, "[[expect]]\nat_s = 9.95\nphase = \"cruise\"\n");
    require_within_input(test, 10, {10});
    test_support::expect_user_error([&] { require_within_input(test, 9.97, {10}); },
                                    "a.toml:1: the input, which lasts 9.970 s, ends before the frame");
}

}  // namespace
}  // namespace tedavis::host_sim::test_input_logs
