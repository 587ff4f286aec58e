#include "render_core/raytrace/paged/ray_packet.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace::test_ray_packet {
namespace {

TEST(RayPacket, ThereIsAKernelOfEachWidthThatTheMachineHas) {
    const auto views = view_kernels<float>();
    const auto packets = packet_kernels<float>();
    ASSERT_EQ(packets.size(), views.size());
    for (std::size_t n = 0; n < views.size(); ++n) {
        EXPECT_EQ(packets[n].lanes, static_cast<std::uint32_t>(views[n].lanes));
        EXPECT_LE(packets[n].lanes, RayPacket::kMaxLanes);
    }
    EXPECT_EQ(packets[packets.size() - 1].lanes, 1u);
    EXPECT_EQ(packet_kernels<std::int16_t>().size(), packets.size());
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_packet
