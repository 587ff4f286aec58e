#include "bus/socketcan/interface_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tedavis::bus::test_interface_check {
namespace {

using ::testing::HasSubstr;

NetInterface controller(const char* name) {
    NetInterface link;
    link.name = name;
    link.kind = "can";
    link.is_can = link.is_up = true;
    link.bit_rate_hz = 500000;
    link.restart_ms = 100;
    link.state = ControllerState::active;
    return link;
}

struct InterfaceCheck : testing::Test {
    void SetUp() override {
        NetInterface ethernet;
        ethernet.name = "eth0";
        ethernet.is_up = true;
        add(ethernet);
        list.is_read = true;
    }
    void add(const NetInterface& link) { ASSERT_TRUE(list.interfaces.try_push_back(link)); }
    std::string fault(const char* name = "can0") const { return interface_fault(list, name).message.c_str(); }
    InterfaceList list;
};

TEST_F(InterfaceCheck, AControllerThatTakesPartServes) {
    add(controller("can0"));
    EXPECT_EQ(fault(), "");
    list.interfaces.back().state = ControllerState::warning;
    EXPECT_EQ(fault(), "") << "errors below the limit are no fault";
    EXPECT_EQ(interface_text(list.interfaces.back()).view(), "can, up, 500000 bit/s, error-warning, restart after 100 ms");
}

TEST_F(InterfaceCheck, AMissingInterfaceIsToldWithThoseThatAreThere) {
    EXPECT_EQ(fault(),
              "CAN interface 'can0': there is no such interface; CAN interfaces here: none; correct 'interface' of [can], "
              "or load the driver");
    add(controller("can1"));
    add(controller("vcan7"));
    EXPECT_THAT(fault(), HasSubstr("CAN interfaces here: can1, vcan7;"));
    EXPECT_EQ(fault("eth0"),
              "CAN interface 'eth0': is no CAN interface; CAN interfaces here: can1, vcan7; correct 'interface' of [can]");
}

TEST_F(InterfaceCheck, AnInterfaceThatIsDownIsToldWithTheCommand) {
    NetInterface link = controller("can0");
    link.is_up = false;
    link.state = ControllerState::stopped;
    add(link);
    EXPECT_EQ(fault(), "CAN interface 'can0': is down; switch it on: ip link set can0 up type can restart-ms 100");
    list.interfaces.back().has_listed_rates = true;
    EXPECT_EQ(fault(), "CAN interface 'can0': is down; switch it on: ip link set can0 up") << "a serial adapter";
    list.interfaces.back().has_listed_rates = false;
    list.interfaces.back().bit_rate_hz = 0;
    EXPECT_EQ(fault(),
              "CAN interface 'can0': is down and has no bit rate; set the rate of the bus, for example: ip link set can0 up "
              "type can bitrate 1000000 restart-ms 100");
    list.interfaces.back().has_listed_rates = true;
    EXPECT_THAT(fault(),
                HasSubstr("restart-ms 100; a serial adapter that got its rate already (slcand -s8) needs only: ip link set "
                          "can0 up"));
    list.interfaces.back().kind = "vcan";
    EXPECT_EQ(fault(), "CAN interface 'can0': is down; switch it on: ip link set can0 up") << "a virtual bus needs no rate";
    list.interfaces.back().is_up = true;
    EXPECT_EQ(fault(), "");
    EXPECT_EQ(interface_text(list.interfaces.back()).view(), "vcan, up");
}

TEST_F(InterfaceCheck, AControllerThatIsOffTheBusIsTold) {
    NetInterface link = controller("can0");
    link.state = ControllerState::bus_off;
    add(link);
    EXPECT_THAT(fault(), HasSubstr("is bus-off and tries again every 100 ms; check wiring"));
    list.interfaces.back().restart_ms = 0;
    EXPECT_EQ(fault(),
              "CAN interface 'can0': is bus-off and stays so (restart-ms 0); check wiring and bit rate, then: ip link set "
              "can0 down; ip link set can0 up type can restart-ms 100");
    list.interfaces.back().has_listed_rates = true;
    EXPECT_THAT(fault(), HasSubstr("; ip link set can0 up")) << "a serial adapter";
    EXPECT_EQ(fault().find("type can"), std::string::npos);
    EXPECT_THAT(std::string(interface_text(list.interfaces.back()).view()), HasSubstr("bus-off lasts (restart-ms 0)"));
    list.interfaces.back().state = ControllerState::passive;
    EXPECT_THAT(fault(), HasSubstr("is error-passive"));
}

TEST_F(InterfaceCheck, WithoutCanOrAListItSaysWhatItKnows) {
    list.is_read = false;
    EXPECT_EQ(fault(), "") << "nothing is known";
    list.has_can = false;
    EXPECT_EQ(fault(), "CAN interface 'can0': this kernel has no CAN; load the modules can and can_raw (modprobe can_raw)");
}

TEST_F(InterfaceCheck, NoSentenceIsCut) {
    for (int n = 0; n < 63; ++n) add(controller(("interface" + std::to_string(10000 + n)).c_str()));
    EXPECT_FALSE(interface_fault(list, "absent").message.cut());
    EXPECT_THAT(fault("absent"), HasSubstr("correct 'interface' of [can]"));
    EXPECT_LT(fault("absent").size(), 512u) << "a socket's reason holds as much";
}

}  // namespace
}  // namespace tedavis::bus::test_interface_check
