#include "host_sim/terrain_builder/generated_image.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "host_sim/terrain_builder/image_source.hpp"
#include "render_core/base/hash.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"

namespace tedavis::host_sim::test_generated_image {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

bool is_greenish(const Rgb& c) { return c[1] > c[0] && c[1] > c[2]; }

/// Gentle in the west, steep in the east, a lake between.
Raster three_parts() {
    return test_support::make_raster(300, 120, [](std::uint32_t i, std::uint32_t) {
        if (i < 100) return 400.0f + static_cast<float>(i % 3);
        if (i < 140) return 300.0f;
        return 300.0f + 60.0f * static_cast<float>(i - 140);
    });
}

TEST(GeneratedImage, ShowsWoodsOnSlopesLakesWhereItIsLevelAndParcelsElsewhere) {
    const Raster raster = three_parts();
    const GeneratedImage image(raster);
    ASSERT_EQ(image.columns(), 1200);
    std::set<Rgb> lake;
    int green = 0, steep = 0;
    std::map<int, int> crops;  // brightness of the gentle part, in steps
    for (int row = 20; row < 460; row += 5) {
        lake.insert(image.pixel(480, row));
        for (int column = 620; column < 1190; column += 7, ++steep) green += is_greenish(image.pixel(column, row)) ? 1 : 0;
        for (int column = 10; column < 390; column += 7)
            ++crops[(image.pixel(column, row)[0] + image.pixel(column, row)[1]) / 40];
    }
    for (const Rgb& c : lake) EXPECT_LT(c[0], 60) << "water is dark";
    EXPECT_GT(green, 0.9 * steep);
    EXPECT_GT(crops.size(), 4u) << "fields differ";
}

TEST(GeneratedImage, EqualHeightsGiveEqualBytes) {
    const Raster raster = three_parts();
    const GeneratedImage image(raster), again(raster);
    base::Fnv1a64 hash;
    for (int row = 0; row < image.rows(); row += 3)
        for (int column = 0; column < image.columns(); column += 3) {
            const Rgb c = image.pixel(column, row);
            ASSERT_EQ(c, again.pixel(column, row));
            hash.add(c.data(), c.size());
        }
    Raster other = raster;
    for (float& h : other.height_m) h *= 1.5f;
    base::Fnv1a64 of_other;
    const GeneratedImage steeper(other);
    for (int row = 0; row < image.rows(); row += 3)
        for (int column = 0; column < image.columns(); column += 3) of_other.add(steeper.pixel(column, row).data(), 3);
    EXPECT_NE(hash.value(), of_other.value());
}

TEST(GeneratedImage, LiesOverItsRaster) {
    const test_support::TemporaryFolder folder;
    test_support::RasterFile heights;  // posts in the middle of pixels of 0.01 degrees from 9.6 E, 47.1 N
    write_generated_image(heights.write(folder.file("h.tif")), folder.file("i.tif"));
    const ImageSource image({folder.file("i.tif"), {}, {}});
    EXPECT_EQ(image.columns(), 4 * heights.columns);
    EXPECT_EQ(image.rows(), 4 * heights.rows);
    EXPECT_NEAR(image.transform()[0], 9.6, 1e-9);
    EXPECT_NEAR(image.transform()[1], 0.0025, 1e-12);
    EXPECT_NEAR(image.transform()[3], 47.1, 1e-9);
    test_support::expect_user_error([&] { write_generated_image(folder.file("h.tif"), folder.file("none/i.tif")); },
                                    "could not be written");
}

}  // namespace
}  // namespace tedavis::host_sim::test_generated_image
