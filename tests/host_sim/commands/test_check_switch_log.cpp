#include "host_sim/commands/check_switch_log.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_check_switch_log {
namespace {

std::string one_hot_log(const std::string& chip = "panel") {
    std::string log = "# tedavis switch log 1\n";
    for (const char* name : {"GROUND 0", "TAKEOFF 0", "CRUISE 1", "APPROACH 0", "GO_AROUND 0", "REPLAN 0", "AUTO 0"})
        log += "(2.000000) " + chip + "." + name + "\n";
    return log;
}

TEST(CheckSwitchLog, FindsTheShippedPanelThatFits) {
    const test_support::TemporaryFolder place;
    const CheckedFile checked = check_switch_log(place.write("x.switches", one_hot_log()), "");
    EXPECT_EQ(checked.is, "a switch log of the panel one_hot, 7 edges");
    EXPECT_TRUE(checked.warnings.empty());
}

TEST(CheckSwitchLog, ATypoAndAnotherPanelAreSaid) {
    const test_support::TemporaryFolder place;
    const std::string typo = place.write("x.switches", one_hot_log() + "(3.000000) panel.CRUZE 0\n");
    const CheckedFile checked = check_switch_log(typo, "");
    ASSERT_EQ(checked.warnings.size(), 1u);
    EXPECT_EQ(checked.warnings[0].name, "switches.unknown_line");
    const CheckedFile other = check_switch_log(place.write("y.switches", one_hot_log("desk")), "");
    ASSERT_EQ(other.warnings.size(), 1u);
    EXPECT_EQ(other.warnings[0].name, "switches.other_panel");
    EXPECT_EQ(other.is, "a switch log");
    const CheckedFile wrong = check_switch_log(place.write("x.switches", one_hot_log()), "coded_parity");
    ASSERT_EQ(wrong.warnings.size(), 1u) << "the panel is stated";
    EXPECT_EQ(wrong.warnings[0].name, "switches.other_panel");
}

TEST(CheckSwitchLog, BrokenLinesAreRefused) {
    const test_support::TemporaryFolder place;
    const std::string broken = place.write("x.switches", one_hot_log() + "(3.000000) panel.CRUISE 2\n");
    test_support::expect_user_error([&] { (void)check_switch_log(broken, ""); },
                                    "x.switches:9: the level is not a single 0 or 1");
    test_support::expect_user_error([&] { (void)check_switch_log(broken, "no_such_panel"); }, "no_such_panel");
}

}  // namespace
}  // namespace tedavis::host_sim::test_check_switch_log
