#include "host_sim/device_plan/device_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/files/device_files.hpp"

namespace tedavis::host_sim::test_device_text {
namespace {

/// Written from one reader's result, compared by another writing of what is read back.
TEST(DeviceText, ReadsBackAsTheSameDevice) {
    for (const char* const name : {"desktop", "es3-mid", "es2-small", "sc2"}) {
        effects::DeviceSettings device = test_support::shipped_device(name);
        ASSERT_TRUE(device.capability.gl.also.try_push_back(effects::CallName("GetError")));
        device.frame_rate_hz = 12.5;
        device.deadline_ms = 33.25;
        device.affords_antialiasing = device.affords_antialiasing && name != std::string("desktop");
        device.capability.blur_square_px = 3;
        if (!device.affords_antialiasing) device.forbidden.add(effects::Effect::antialiasing);
        const std::string text = device_text(device, "one\ntwo");
        EXPECT_EQ(text.rfind("# one\n# two\nname = ", 0), 0u);
        const auto read = effects::read_device_settings(text, "x.toml");
        ASSERT_TRUE(read.ok()) << read.error().message.view();
        EXPECT_EQ(device_text(read.value(), "one\ntwo"), text);
        EXPECT_EQ(read.value().frame_rate_hz, 12.5);
        EXPECT_EQ(read.value().deadline_ms, 33.25);
        EXPECT_EQ(read.value().forbidden.has(effects::Effect::antialiasing), !device.affords_antialiasing);
        EXPECT_EQ(read.value().affords_antialiasing, device.affords_antialiasing);
        EXPECT_EQ(read.value().capability.shadow_map_px, device.capability.shadow_map_px);
        EXPECT_EQ(read.value().capability.blur_square_px, device.capability.blur_square_px);
        EXPECT_EQ(total_bytes(read.value()), total_bytes(device));
    }
}

TEST(DeviceText, ThePlanSaysWhatIsLeftAndGivenUp) {
    DevicePlan plan{
        test_support::shipped_device("es2-small"), "es2-small", {{"drape_pages", 7, "no pages"}}, {{"desktop", 12345}}};
    const std::uint64_t total = total_bytes(plan.device);
    const nlohmann::ordered_json json = plan_json(plan, total + 5);
    EXPECT_EQ(json["left_bytes"], 5u);
    EXPECT_EQ(json["cpu_bytes"].get<std::uint64_t>() + json["gpu_bytes"].get<std::uint64_t>(), total);
    std::uint64_t sum = 0;
    for (const auto& line : json["budget"]) sum += line["bytes"].get<std::uint64_t>();
    EXPECT_EQ(sum, total);
    EXPECT_EQ(json["given_up"][0]["what"], "drape_pages");
    EXPECT_NE(plan_text(plan, total).find("given up: no pages"), std::string::npos);
    EXPECT_EQ(json["larger"][0]["device"], "desktop");
    EXPECT_NE(plan_text(plan, total).find("the larger device desktop takes 12345 bytes"), std::string::npos);
    plan.given_up.clear();
    EXPECT_NE(plan_text(plan, total).find("nothing of this device is given up"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::host_sim::test_device_text
