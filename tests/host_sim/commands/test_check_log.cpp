#include "host_sim/commands/check_log.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_check_log {
namespace {

constexpr char kFlight[] = "(1.000000) can0 40C#090300011C2B5590\n(1.100000) can0 40D#0903000105C5D4B0\n(2.000000) can0 123#11\n";

TEST(CheckLog, SaysHowMuchOfItTheBusDecodes) {
    const test_support::TemporaryFolder place;
    const std::string log = place.write("x.log", kFlight);
    const CheckedFile checked = check_log(log, "canaerospace");
    EXPECT_EQ(checked.is, "a candump log of 3 frames, of which the bus canaerospace decodes 2");
    EXPECT_TRUE(checked.warnings.empty());
    const CheckedFile prose = check_log(place.write("x.log", std::string(kFlight) + "prose\n"), "canaerospace");
    EXPECT_EQ(prose.is, checked.is + ", 1 line that does not begin with '('");
}

TEST(CheckLog, ReadsByTheBusThatIsNamed) {
    const test_support::TemporaryFolder place;
    const std::string log = place.write("x.log", kFlight);
    const std::string strict = place.write("strict.toml", "protocol = 'canaerospace'\n[dialect]\naccept_long_position = false\n");
    const CheckedFile checked = check_log(log, strict);
    ASSERT_EQ(checked.warnings.size(), 1u) << "positions as LONG are foreign to it";
    EXPECT_EQ(checked.warnings[0].name, "bus.nothing_decoded");
    test_support::expect_user_error([&] { (void)check_log(log, "smoke_signals"); }, "smoke_signals");
}

}  // namespace
}  // namespace tedavis::host_sim::test_check_log
