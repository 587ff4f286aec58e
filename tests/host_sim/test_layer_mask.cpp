#include "host_sim/layer_mask.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/png_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_layer_mask {
namespace {

using ::testing::ElementsAre;

TEST(LayerMask, HoldsTheValuesOfAGreyPng) {
    const test_support::TemporaryFolder place;
    const RgbaPicture grey{3, 1, {0, 0, 0, 255, 1, 1, 1, 255, 255, 255, 255, 255}};
    (void)place.write("a.layers.png", encode_small_png(view_of(grey)));  // one channel
    EXPECT_EQ(layer_mask_path(place.file("a.png")), place.file("a.layers.png"));
    const auto mask = read_layer_mask(place.file("a.png"), {"terrain", "data"}, 3, 1);
    ASSERT_TRUE(mask.has_value());
    EXPECT_THAT(mask->layers, ElementsAre(0, 1, 255));
    EXPECT_THAT(mask->names, ElementsAre("terrain", "data"));
    EXPECT_FALSE(read_layer_mask(place.file("a.png"), {}, 3, 1).has_value());
    EXPECT_FALSE(read_layer_mask(place.file("b.png"), {"terrain"}, 3, 1).has_value());
    test_support::expect_user_error([&] { (void)read_layer_mask(place.file("a.png"), {"terrain"}, 3, 2); },
                                    "3x1 pixels where its picture has 3x2");
}

}  // namespace
}  // namespace tedavis::host_sim::test_layer_mask
