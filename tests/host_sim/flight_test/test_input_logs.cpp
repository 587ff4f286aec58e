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
    require_within_input(test, 3);
    test_support::expect_user_error([&] { require_within_input(test, 2.5); }, "a.toml:4: this [[expect]] lies beyond");
}

}  // namespace
}  // namespace tedavis::host_sim::test_input_logs
