#include "bus/socketcan/interface_list.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace tedavis::bus::test_interface_list {
namespace {

using Message = std::vector<unsigned char>;

// The kernel's numbers (rtnetlink(7), <linux/if_link.h>, <linux/can/netlink.h>), written out so that the reader's are checked.
constexpr unsigned kNewLink = 16, kDone = 3, kErrorMessage = 2;
constexpr unsigned kName = 3, kLinkInfo = 18, kKind = 1, kData = 2;
constexpr unsigned kBitTiming = 1, kState = 4, kRestartMs = 6, kListedRates = 13;
constexpr unsigned kUp = 1, kRunning = 0x40;
constexpr unsigned kCanType = 280, kEthernetType = 1;

void put(Message& to, std::uint64_t value, std::size_t bytes) {
    for (std::size_t n = 0; n < bytes; ++n) to.push_back(static_cast<unsigned char>(value >> 8 * n));
}
Message text(const std::string& value) {
    Message made(value.begin(), value.end());
    made.push_back(0);
    return made;
}
Message number(std::uint32_t value) {
    Message made;
    put(made, value, 4);
    return made;
}
void attribute(Message& to, unsigned type, const Message& payload) {
    put(to, 4 + payload.size(), 2);
    put(to, type, 2);
    to.insert(to.end(), payload.begin(), payload.end());
    while (to.size() % 4 != 0) to.push_back(0);
}
Message message(unsigned type, const Message& body) {
    Message made;
    put(made, 16 + body.size(), 4);
    put(made, type, 2);
    put(made, 2, 2);  // of several
    put(made, 0, 8);
    made.insert(made.end(), body.begin(), body.end());
    return made;
}
Message link(const std::string& name, unsigned type, unsigned flags, const Message& info = {}) {
    Message body;
    put(body, 0, 2);  // family and padding
    put(body, type, 2);
    put(body, 7, 4);  // index
    put(body, flags, 4);
    put(body, 0, 4);
    attribute(body, kName, text(name));
    if (!info.empty()) attribute(body, kLinkInfo, info);
    return message(kNewLink, body);
}
Message controller(std::uint32_t bit_rate, std::uint32_t state, std::uint32_t restart_ms, const char* kind = "can") {
    Message timing = number(bit_rate);
    timing.resize(32);
    Message data, info;
    attribute(data, kBitTiming, timing);
    attribute(data, kState, number(state));
    attribute(data, kRestartMs, number(restart_ms));
    attribute(info, kKind, text(kind));
    attribute(info, kData, data);
    return info;
}
Message joined(std::initializer_list<Message> parts) {
    Message all;
    for (const Message& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}
LinkMessages read(const Message& bytes, InterfaceList& list) { return add_links({bytes.data(), bytes.size()}, list); }

TEST(InterfaceList, HasWhatTheKernelSaysOfEachInterface) {
    Message vcan;
    attribute(vcan, kKind, text("vcan"));
    const Message bytes = joined({link("lo", 772, kUp), link("can0", kCanType, kUp | kRunning, controller(500000, 1, 100)),
                                  link("vcan0", kCanType, 0, vcan), link("slcan0", kCanType, kUp)});
    InterfaceList list;
    EXPECT_EQ(read(bytes, list), LinkMessages::go_on);
    ASSERT_EQ(list.interfaces.size(), 4u);
    EXPECT_EQ(list.interfaces[0].name.view(), "lo");
    EXPECT_FALSE(list.interfaces[0].is_can);
    const NetInterface& can = list.interfaces[1];
    EXPECT_TRUE(can.is_can && can.is_up && can.has_carrier);
    EXPECT_EQ(can.kind.view(), "can");
    EXPECT_EQ(can.bit_rate_hz, 500000u);
    EXPECT_EQ(can.state, ControllerState::warning);
    EXPECT_EQ(can.restart_ms, 100u);
    EXPECT_EQ(list.interfaces[2].kind.view(), "vcan");
    EXPECT_FALSE(list.interfaces[2].is_up);
    EXPECT_TRUE(list.interfaces[3].is_can && list.interfaces[3].kind.empty());
    EXPECT_EQ(read(message(kDone, number(0)), list), LinkMessages::ended);
    EXPECT_EQ(read(message(kErrorMessage, number(0)), list), LinkMessages::damaged);
}

TEST(InterfaceList, EveryStateOfAControllerIsKnown) {
    const ControllerState states[] = {ControllerState::active,  ControllerState::warning, ControllerState::passive,
                                      ControllerState::bus_off, ControllerState::stopped, ControllerState::sleeping,
                                      ControllerState::unknown};
    for (std::uint32_t n = 0; n < 7; ++n) {
        InterfaceList list;
        EXPECT_EQ(read(link("can0", kCanType, kUp, controller(1, n, 0)), list), LinkMessages::go_on);
        EXPECT_EQ(list.interfaces[0].state, states[n]) << n;
    }
}

TEST(InterfaceList, DataOfAnotherKindAreNoControllers) {
    InterfaceList list;
    EXPECT_EQ(read(link("eth0", kEthernetType, kUp, controller(500000, 3, 1, "bridge")), list), LinkMessages::go_on);
    EXPECT_EQ(list.interfaces[0].bit_rate_hz, 0u);
    EXPECT_EQ(list.interfaces[0].state, ControllerState::unknown);
}

TEST(InterfaceList, ASerialAdapterWithoutARateHasNone) {
    InterfaceList list;
    Message data, info;
    attribute(data, kListedRates, number(1000000));
    attribute(info, kKind, text("can"));
    attribute(info, kData, data);
    EXPECT_EQ(read(link("can7", kCanType, 0, info), list), LinkMessages::go_on);
    EXPECT_TRUE(list.interfaces[0].has_listed_rates);
    list = InterfaceList();
    EXPECT_EQ(read(link("can0", kCanType, kUp, controller(UINT32_MAX, 0, 0)), list), LinkMessages::go_on);
    EXPECT_EQ(list.interfaces[0].bit_rate_hz, 0u);
}

TEST(InterfaceList, CutAndDamagedMessagesReadNothingBeyondTheirEnd) {
    const Message whole = link("can0", kCanType, kUp, controller(500000, 0, 100));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Message cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));  // its own memory: a sanitizer sees
        InterfaceList list;
        EXPECT_EQ(read(cut, list), size == 0 ? LinkMessages::go_on : LinkMessages::damaged) << size;
        EXPECT_TRUE(list.interfaces.empty());
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const unsigned char value : {0x00, 0x01, 0x7F, 0xFF}) {
            Message changed = whole;
            changed[at] = value;
            InterfaceList list;
            static_cast<void>(read(changed, list));
            EXPECT_LE(list.interfaces.size(), 1u);
        }
    }
}

TEST(InterfaceList, MoreInterfacesThanFitAreCounted) {
    InterfaceList list;
    for (int n = 0; n < 70; ++n) EXPECT_EQ(read(link("eth" + std::to_string(n), kEthernetType, 0), list), LinkMessages::go_on);
    EXPECT_EQ(list.interfaces.size(), 64u);
    EXPECT_EQ(list.interfaces.refused(), 6u);
}

TEST(InterfaceList, OfThisMachineHasTheLoopback) {
    InterfaceList list;
    list_interfaces(list);
    ASSERT_TRUE(list.is_read);
    bool found = false;
    for (const NetInterface& one : list.interfaces) found = found || (one.name.view() == "lo" && !one.is_can);
    EXPECT_TRUE(found);
}

}  // namespace
}  // namespace tedavis::bus::test_interface_list
