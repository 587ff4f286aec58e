#include "bus/socketcan/raw_can_socket.hpp"

#include <gtest/gtest.h>
#include <linux/can.h>

namespace tedavis::bus::test_raw_can_socket {
namespace {

TEST(RawCanSocket, SaysWhyItCannotBeOpened) {
    SocketCanSettings settings;
    settings.interface_name = "nosuchcan0";
    const OpenedSocket opened = RawCanSocket().open(settings);
    EXPECT_EQ(opened.descriptor, -1);
    EXPECT_EQ(opened.reason.view().substr(0, 28), "CAN interface 'nosuchcan0': ");
    EXPECT_GT(opened.reason.size(), 40u);
    EXPECT_FALSE(opened.reason.cut());
}

bool passes(const SocketCanSettings& settings, std::uint32_t can_id) {
    for (const CanFilter& filter : settings.filters)
        if ((can_id & filter.mask) == (filter.identifier & filter.mask)) return true;
    return false;
}

TEST(RawCanSocket, IdentifierFiltersPassAllRedundancyChannelsAndNothingElse) {
    SocketCanSettings settings;
    ASSERT_TRUE(add_identifier_filters(settings, 304));
    EXPECT_TRUE(passes(settings, 304));
    EXPECT_TRUE(passes(settings, 304 | CAN_EFF_FLAG));
    EXPECT_TRUE(passes(settings, (304 + 65536) | CAN_EFF_FLAG));
    EXPECT_TRUE(passes(settings, (304 + 3 * 65536) | CAN_EFF_FLAG));
    EXPECT_FALSE(passes(settings, 305));
    EXPECT_FALSE(passes(settings, 304 | CAN_RTR_FLAG));
    EXPECT_FALSE(passes(settings, (304 | 0x800) | CAN_EFF_FLAG));
}

TEST(RawCanSocket, FiltersEndAtTheKernelsLimit) {
    SocketCanSettings settings;
    for (std::uint16_t i = 0; i < 256; ++i) EXPECT_TRUE(add_identifier_filters(settings, i));
    EXPECT_FALSE(add_identifier_filters(settings, 300));
    EXPECT_EQ(settings.filters.size(), 512u);
}

}  // namespace
}  // namespace tedavis::bus::test_raw_can_socket
