#include "host_sim/replay/read_switch_log.hpp"

#include <gtest/gtest.h>

#include "tests/support/expect_user_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tedavis::host_sim::test_read_switch_log {
namespace {

TEST(ReadSwitchLog, GivesTheWholeText) {
    const test_support::TemporaryFolder folder;
    const std::string text = "# tedavis switch log 1\n(1.000000) p.A 1\n";
    EXPECT_EQ(read_switch_log(folder.write("s", text)), text);
}

TEST(ReadSwitchLog, RefusesWhatIsNone) {
    const test_support::TemporaryFolder folder;
    const auto refuses = [&](const std::string& text) {
        test_support::expect_user_error([&] { (void)read_switch_log(folder.write("x.switches", text)); },
                                        "x.switches:1: not a switch log; give one whose first line is '# tedavis switch log 1'");
    };
    refuses("");
    refuses("(1.000000) can0 12C#0000\n");
    refuses("# tedavis switch log 12\n");
    test_support::expect_user_error([&] { (void)read_switch_log(folder.file("none")); }, "none: no such file; check the path");
}

}  // namespace
}  // namespace tedavis::host_sim::test_read_switch_log
