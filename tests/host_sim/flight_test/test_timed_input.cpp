#include "host_sim/flight_test/timed_input.hpp"

#include <gtest/gtest.h>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_timed_input {
namespace {

bus::SwitchConfig panel_of(const std::string& name) {
    const std::string path = resolve_config(name, "switches");
    return bus::load_switch_config(read_file(path), path).value();
}

class TimedInputTest : public ::testing::Test {
protected:
    TimedInput read(const std::string& log, const std::string& switches = "") {
        PlayerFiles files;
        files.log = place_.write("a.log", log);
        if (!switches.empty()) files.switches = place_.write("a.switches", "# tedavis switch log 1\n" + switches);
        return read_timed_input(files, panel_);
    }
    test_support::TemporaryFolder place_;
    bus::SwitchConfig panel_ = panel_of("one_hot");
};

const std::string kTwoFrames = "(100.500000) can0 137#0902000040A00000\n(101.000250) can0 138#0902000040A00000\n";

TEST_F(TimedInputTest, TimesCountFromTheFirstFrame) {
    const TimedInput input = read(kTwoFrames);
    ASSERT_EQ(input.frames.size(), 2u);
    EXPECT_EQ(input.frames[0].time.ns, 0);
    EXPECT_EQ(input.frames[1].time.ns, 500'250'000);
    EXPECT_EQ(input.frames[1].id, 0x138u);
    EXPECT_DOUBLE_EQ(input.end_s(), 0.50025);
    EXPECT_FALSE(input.throws_panel);
    EXPECT_EQ(input.first_levels, 1u << 6) << "AUTO";
}

TEST_F(TimedInputTest, LevelsUpToTheFirstFrameAreThoseAtTheStart) {
    const TimedInput input =
        read(kTwoFrames, "(99.000000) panel.GROUND 1\n(99.000000) panel.AUTO 0\n(100.750000) panel.GROUND 0\n");
    EXPECT_TRUE(input.throws_panel);
    EXPECT_EQ(input.first_levels, 1u);
    ASSERT_EQ(input.edges.size(), 1u);
    EXPECT_EQ(input.edges[0].time.ns, 250'000'000);
    EXPECT_FALSE(input.edges[0].level);
}

TEST_F(TimedInputTest, WhatCannotBeSentIsLeftOutOrRefused) {
    EXPECT_EQ(read("(100.000000) can0 20000080#0000000000000000\n" + kTwoFrames).frames.size(), 2u) << "an error frame";
    test_support::expect_user_error([&] { static_cast<void>(read("nothing\n")); }, "a.log: has no frame of a bus");
    test_support::expect_user_error([&] { static_cast<void>(read(kTwoFrames, "(99.000000) other.GROUND 1\n")); },
                                    "names no line of the panel");
}

TEST(RestingLevels, LeaveThePhaseToOthersWhereThePanelCan) {
    EXPECT_EQ(resting_levels(panel_of("one_hot")), 1u << 6);
    EXPECT_EQ(resting_levels(bus::SwitchConfig()), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_timed_input
