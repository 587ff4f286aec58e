#include "target/probe/machine_offer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/target/captured_output.hpp"
#include "tests/target/probe/fake_machine.hpp"

namespace tedavis::target::test_machine_offer {
namespace {

using ::testing::HasSubstr;

std::string printed_offer(bool json) {
    SelfTestReport report;
    list_offer(FakeMachine::ports(), report);
    EXPECT_TRUE(report.holds()) << "an offer is no fault";
    return printed([&](std::FILE* out) { print_offer(report, json, out); });
}

TEST(MachineOffer, NamesWhatABoardFileMayName) {
    FakeMachine machine;
    machine.add_card();
    platform::ScreenCard& closed = machine.add_card("/dev/dri/card2", "");
    closed.access = platform::CardAccess::no_permission;
    closed.group = "video";
    machine.add_controller("can0");
    machine.add_controller("can1").is_up = false;
    machine.add_chip("gpiochip3", "panel", {"GROUND", "TAKEOFF"});
    const std::string text = printed_offer(false);
    EXPECT_THAT(text, HasSubstr("card             /dev/dri/card1 (virtio_gpu): 2 connectors\n"));
    EXPECT_THAT(text, HasSubstr("connector        Virtual-1 of /dev/dri/card1: 1024x768@60, 640x480@60\n"));
    EXPECT_THAT(text, HasSubstr("connector        HDMI-A-1 of /dev/dri/card1: not connected\n"));
    EXPECT_THAT(text, HasSubstr("card             /dev/dri/card2: may not be opened; it belongs to the group video"));
    EXPECT_THAT(text, HasSubstr("gl               es3, off-screen: "));
    EXPECT_THAT(text, HasSubstr("can_interface    can0: can, up, 500000 bit/s, error-active, restart after 100 ms\n"));
    EXPECT_THAT(text, HasSubstr("CAN interface 'can1': is down"));
    EXPECT_THAT(text, HasSubstr("gpio_chip        panel (gpiochip3): 0 GROUND, 1 TAKEOFF\n"));
    const auto json = nlohmann::json::parse(printed_offer(true));
    EXPECT_EQ(json.at("probe"), true);
    EXPECT_EQ(json.at("checks").at(0).at("name"), "card");
}

TEST(MachineOffer, WhatIsNotThereIsSaid) {
    FakeMachine machine;
    machine.interfaces.has_can = false;
    const std::string text = printed_offer(false);
    EXPECT_THAT(text, HasSubstr("card             none that the kernel drives"));
    EXPECT_THAT(text, HasSubstr("can_interface    none: this kernel has no CAN"));
    EXPECT_THAT(text, HasSubstr("gpio_chip        none"));
    machine.interfaces.has_can = true;
    EXPECT_THAT(printed_offer(false), HasSubstr("can_interface    none; load its driver"));
}

}  // namespace
}  // namespace tedavis::target::test_machine_offer
