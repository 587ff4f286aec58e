#include "host_sim/accuracy/knobs/flown_pictures.hpp"

#include <gtest/gtest.h>

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/input_file.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flown_pictures {
namespace {

using Pixels = std::vector<std::uint8_t>;

FlownLevel level_with(const std::string& terrain, double tau_px) {
    FlownLevel level;
    level.picture.terrain = terrain;
    level.picture.size = PictureSize{160, 90};
    level.picture.tau_px = tau_px;
    return level;
}

TEST(FlownPictures, DoNotDependOnTheOrderInWhichTheyAreDrawn) {
    const test_support::ShippedKnobGround shipped;
    FlownLevel reduced = level_with(shipped.ground.path(), 1), dark = reduced;
    reduced.quality.emplace();
    reduced.quality->tau_factor = 4;
    dark.change = [](design::DesignSettings& design) { design.terrain.style.shade.ambient = 0.1; };
    FlownPictures pictures({level_with(shipped.ground.path(), 1), reduced, dark}, KnobFlight(shipped.ground).poses(3));
    const auto pixels = [&](std::size_t level, std::size_t pose) { return upright(pictures.picture(level, pose)).pixels; };
    const Pixels first = pixels(0, 1), other_pose = pixels(0, 2), other_quality = pixels(1, 1), other_design = pixels(2, 1);
    EXPECT_EQ(pixels(0, 1), first) << "after another pose";
    pictures.draw(0, 1);
    EXPECT_EQ(pixels(0, 1), first) << "a further frame";
    pictures.fly_to(0, pictures.poses()[2]);
    EXPECT_EQ(pixels(0, 1), first) << "after a flight";
    for (const Pixels* const other : {&other_pose, &other_quality, &other_design}) EXPECT_NE(*other, first) << "control";
    EXPECT_GT(pictures.build_ms(1), 0);
}

TEST(FlownPictures, ADeviceMayDifferInWhatALevelNames) {
    const TemporaryFolder folder;
    const std::string path = changed_device(folder.path(), "smaller", "es3-mid",
                                            {{"", "shadow_map_px", "512"}, {"name = \"render_targets\"", "bytes", "33554432"}});
    const std::string text = read_file(path);
    const auto device = effects::read_device_settings(text, path);
    ASSERT_TRUE(device.ok()) << device.error().message.view();
    EXPECT_EQ(device.value().capability.shadow_map_px, 512u);
    EXPECT_EQ(device.value().budget.find(effects::kRenderTargets)->use.capacity, 33554432u);
    EXPECT_EQ(device.value().width_px, 1024u) << "as shipped";
    test_support::expect_user_error(
        [&] {
            static_cast<void>(changed_device(folder.path(), "b", "es3-mid", {{"", "shadow_maps", "1"}}));
        },
        "has no 'shadow_maps'");
}

}  // namespace
}  // namespace tedavis::host_sim::test_flown_pictures
