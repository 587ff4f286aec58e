// Displays over a database with an image, and over one without.
#include <gtest/gtest.h>

#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/display/hills_display.hpp"
#include "tests/support/terrain/draped_database.hpp"

namespace tedavis::display::test_display_drape {
namespace {

using test_support::aircraft_over_hills;
using test_support::has_flag;
using test_support::HeadlessDisplay;
using test_support::hills;
using test_support::hills_picture;
using test_support::HillsPicture;

design::DesignSettings image_design() {
    design::DesignSettings design = test_support::shipped_design("styles/aerial_image");
    design.sky.haze_distance_m = 0;
    return design;
}

const EffectRecord* effect_of(HeadlessDisplay& display, std::string_view name) {
    for (const EffectRecord& effect : display.display().record().effects)
        if (effect.name.view() == name) return &effect;
    return nullptr;
}

/// How many pixels are as blue as the image.
std::size_t image_pixels(const HillsPicture& picture) {
    std::size_t count = 0;
    for (std::size_t n = 0; n < picture.rgba.size(); n += 4)
        count += picture.rgba[n] < 30 && picture.rgba[n + 1] < 60 && picture.rgba[n + 2] > 200 ? 1 : 0;
    return count;
}

TEST(Display, AnImageIsShownWithinItsBudgetOnEveryDevice) {
    const host_sim::Raster raster = test_support::make_rough_raster(241, 241);
    const std::vector<std::uint8_t> image = test_support::draped_image(raster, test_support::image_over(raster, 2, [](int, int) {
                                                                           return test_support::Rgba{10, 40, 250, 255};
                                                                       }));
    test_support::MemoryBytes bytes(image);
    for (const char* device : {"es2-small", "es3-mid", "desktop"}) {
        HeadlessDisplay display("egl", device, 320, 240, &bytes, image_design());
        const HillsPicture picture = hills_picture(display, aircraft_over_hills(2500, 30, -15));
        EXPECT_GT(image_pixels(picture), 10000u) << device;
        ASSERT_NE(effect_of(display, "drape"), nullptr);
        EXPECT_EQ(effect_of(display, "drape")->state, EffectState::run);
        EXPECT_EQ(display.display().record().terrain_aspect.technique.view(), "image");
        for (const base::BudgetLine& line : display.display().planner().budget().lines())
            EXPECT_LE(line.use.in_use, line.bytes) << device << ": " << line.name.view();
        EXPECT_GT(display.display().planner().budget().find(effects::kTerrainDrape)->use.in_use, 0u);
        EXPECT_GT(display.display().planner().budget().find(effects::kTerrainDrapePages)->use.in_use, 0u);
    }
}

TEST(Display, WhereTheDatabaseHasNoImageThePlainColorIsDrawnAndSaid) {
    test_support::MemoryBytes bytes(hills().image);
    HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes, image_design());
    const HillsPicture picture = hills_picture(display, aircraft_over_hills(2500, 30, -15));
    EXPECT_EQ(image_pixels(picture), 0u);
    const EffectRecord* const drape = effect_of(display, "drape");
    ASSERT_NE(drape, nullptr);
    EXPECT_EQ(drape->state, EffectState::replaced);
    EXPECT_EQ(drape->replaced_by.view(), "plain_color");
    EXPECT_EQ(drape->reason.view(), "the terrain database has no image");
    EXPECT_EQ(display.display().record().terrain_aspect.technique.view(), "plain");
    EXPECT_TRUE(has_flag(display, "terrain.no_image"));
    EXPECT_EQ(display.display().planner().budget().find(effects::kTerrainDrape)->use.in_use, 0u) << "nothing is read for it";
}

TEST(Display, OtherStylesReadNoImage) {
    const host_sim::Raster raster = test_support::make_rough_raster(241, 241);
    const std::vector<std::uint8_t> image = test_support::draped_image(raster, test_support::image_over(raster, 2, [](int, int) {
                                                                           return test_support::Rgba{10, 40, 250, 255};
                                                                       }));
    test_support::MemoryBytes bytes(image);
    const auto shown = [](test_support::MemoryBytes& database) {
        HeadlessDisplay display("egl", "es3-mid", 320, 240, &database);
        const HillsPicture picture = hills_picture(display, aircraft_over_hills(2500));
        EXPECT_EQ(effect_of(display, "drape"), nullptr);
        EXPECT_FALSE(has_flag(display, "terrain.no_image"));
        return std::pair(picture.rgba, display.display().record().bytes.gpu);
    };
    test_support::MemoryBytes without(hills().image);
    EXPECT_EQ(shown(bytes), shown(without));
}

}  // namespace
}  // namespace tedavis::display::test_display_drape
