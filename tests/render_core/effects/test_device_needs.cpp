#include "render_core/effects/device_needs.hpp"

#include <gtest/gtest.h>

namespace tedavis::effects::test_device_needs {
namespace {

TEST(DeviceNeeds, ADeviceHasWhatItsFileSays) {
    DeviceCapability device;
    EXPECT_TRUE(has(device, Need::depth24_target));
    device.depth24_targets = false;
    EXPECT_FALSE(has(device, Need::depth24_target));
    EXPECT_TRUE(has(device, Need::nothing));
    EXPECT_TRUE(has(device, Need::picture_copy));
    device.gl.calls = CallClass::es3;
    EXPECT_TRUE(has(device, Need::half_float_texture));
    EXPECT_FALSE(has(device, Need::second_picture));
    device.off_screen_pictures = 2;
    EXPECT_TRUE(has(device, Need::second_picture));
    EXPECT_FALSE(has(device, Need::shadow_map));
    device.shadow_map_px = 1024;
    EXPECT_TRUE(has(device, Need::shadow_map));
    EXPECT_TRUE(has(device, Need::shadow_map_and_picture));
    device.gl.calls = CallClass::sc2;
    EXPECT_FALSE(has(device, Need::shadow_map));
    EXPECT_FALSE(has(device, Need::half_float_texture));
    EXPECT_FALSE(has(device, Need::second_picture));
    EXPECT_FALSE(has(device, Need::picture_copy));
    EXPECT_EQ(lack_of(Need::half_float_texture), "the device has no textures of half floats");
    EXPECT_EQ(lack_of(Need::depth24_target), "the device has no 24-bit depth off screen");
}

}  // namespace
}  // namespace tedavis::effects::test_device_needs
