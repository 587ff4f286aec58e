// The look of natural ground (points P36 to P38 of the display): tints by height, grid lines at whole minutes, water apart from
// sky and land, and what tells depth: light, a grain that is as fine far away as near, and haze. On three devices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "render_core/base/units.hpp"
#include "render_core/design/color_difference.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/terrain/chunk_drawing.hpp"

namespace tedavis::draw::test_natural_ground {
namespace {

using design::Color;
using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::lit_from_above;
using test_support::pixel_of;
using test_support::RasterScene;

constexpr const char* kDevices[] = {"es2-small", "es3-mid", "sc2"};
constexpr double kPostStep_deg = 1.0 / 1200;

/// The shipped design without what is no ground.
design::DesignSettings natural_design() {
    design::DesignSettings design = test_support::shipped_design("default");
    design.sky.haze_distance_m = 0;
    design.terrain.style.sketch.silhouettes = 0;
    return design;
}

design::DesignSettings without_grain() {
    design::DesignSettings design = natural_design();
    design.terrain.style.grain = 0;
    design.terrain.style.grid.strength = 0;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.shade.ambient_occlusion = 0;
    return design;
}

host_sim::Raster flat_land() {
    return test_support::make_raster(257, 257, [](std::uint32_t, std::uint32_t) { return 1000.0f; });
}

double lightness(Color color) { return design::lab_of(design::linear_rgb(color)).lightness; }
double apart(Color a, Color b) {
    return design::color_difference(design::lab_of(design::linear_rgb(a)), design::lab_of(design::linear_rgb(b)));
}

/// Red plus green, of pixels of a row.
std::vector<double> row_of(const ChunkPicture& picture, std::uint32_t y, std::uint32_t from, std::uint32_t to) {
    std::vector<double> levels;
    for (std::uint32_t x = from; x < to; ++x) levels.push_back(picture.at(x, y).red + picture.at(x, y).green);
    return levels;
}

/// Correlation of neighbors `apart_px` from each other.
double correlation(const std::vector<double>& levels, std::size_t apart_px) {
    double mean = 0, variance = 0, product = 0;
    for (const double level : levels) mean += level / static_cast<double>(levels.size());
    for (std::size_t n = 0; n + apart_px < levels.size(); ++n) {
        variance += (levels[n] - mean) * (levels[n] - mean);
        product += (levels[n] - mean) * (levels[n + apart_px] - mean);
    }
    return variance > 0 ? product / variance : 1;
}

double roughness(const std::vector<double>& levels) {
    double sum = 0;
    for (std::size_t n = 1; n < levels.size(); ++n) sum += std::fabs(levels[n] - levels[n - 1]);
    return sum / static_cast<double>(levels.size() - 1);
}

TEST(NaturalGround, P38TintsFollowTheHeightWithinTheTerrain) {
    RasterScene scene(test_support::eastward_ramp());  // 4 m a post is no slope of woods
    for (const char* device : kDevices) {
        design::DesignSettings design = without_grain();
        design.terrain.palette = design::fitted_palette(design.terrain.palette, 0, 640);
        ChunkDrawing drawing(scene, design, "egl", device);
        const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
        const ChunkPicture picture = drawing.draw(input, 1);
        int compared = 0;
        for (std::uint32_t i = 20; i < 140; i += 5) {
            const auto at = pixel_of(input.view, scene.post(i, 80));
            if (!at) continue;
            const Color tint = design::color_of_value(design.terrain.palette, 4.0 * i),
                        woods = design::wooded(design.terrain.style, tint);
            const Color seen = picture.at(at->x, at->y);
            EXPECT_LE(std::min({apart(seen, tint), apart(seen, woods), apart(seen, design::blended(tint, woods, 0.5))}), 6)
                << device << " post " << i;
            ++compared;
        }
        EXPECT_GT(compared, 10);
    }
}

/// A slope of 12 degrees is all woods below the tree line and none above. Control: with a higher line it has woods throughout.
TEST(NaturalGround, P38WoodsEndAtTheTreeLine) {
    constexpr double kPerPost_m = 14, kLine_m = 1000, kFade_m = 200;
    RasterScene scene(test_support::make_raster(257, 257, [](std::uint32_t i, std::uint32_t) { return float(kPerPost_m * i); }));
    for (const char* device : kDevices) {
        for (const double line_m : {kLine_m, 9000.0}) {
            design::DesignSettings design = without_grain();
            design.terrain.palette = design::fitted_palette(design.terrain.palette, 0, kPerPost_m * 256);
            design.terrain.style.tree_line_m = line_m;
            ChunkDrawing drawing(scene, design, "egl", device);
            const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
            const ChunkPicture picture = drawing.draw(input, 1);
            int below = 0, above = 0;
            for (std::uint32_t i = 20; i < 140; i += 3) {
                const double height_m = kPerPost_m * i;
                const auto at = pixel_of(input.view, scene.post(i, 80));
                if (!at || std::fabs(height_m - line_m) < kFade_m) continue;
                const Color tint = design::color_of_value(design.terrain.palette, height_m);
                const Color expected = height_m < line_m ? design::wooded(design.terrain.style, tint) : tint;
                EXPECT_LE(apart(picture.at(at->x, at->y), expected), 3) << device << " at " << height_m << " m, line " << line_m;
                ++(height_m < line_m ? below : above);
            }
            EXPECT_GT(below, 5);
            EXPECT_GT(line_m == kLine_m ? above : 6, 5);
        }
    }
}

/// Of level land from above at any height: neighbors differ, and what lies 24 pixels apart is not alike, so that no block of a
/// cell is seen. Control: without the grain the ground is one color.
TEST(NaturalGround, P38TheGrainIsAsFineFarAwayAsNear) {
    RasterScene scene(flat_land());
    const auto seen = [&](const char* device, const design::DesignSettings& design, auto&& look) {
        ChunkDrawing drawing(scene, design, "egl", device);
        for (const double above_m : {60.0, 250.0, 1000.0, 4000.0})
            look(above_m, drawing.draw(lit_from_above(scene.view(128, 128, 1000 + above_m, 0, -90)), 1));
    };
    for (const char* device : kDevices) {
        seen(device, natural_design(), [&](double above_m, const ChunkPicture& picture) {
            double rough = 0, alike = 0;
            for (const std::uint32_t y : {60u, 90u, 150u, 190u}) {
                const std::vector<double> row = row_of(picture, y, 20, 300);
                rough += roughness(row) / 4;
                alike += correlation(row, 24) / 4;
            }
            EXPECT_GT(rough, 1.5) << device << " " << above_m << " m above";
            EXPECT_LT(alike, 0.5) << device << " " << above_m << " m above";
        });
        seen(device, without_grain(), [&](double above_m, const ChunkPicture& picture) {
            EXPECT_LT(roughness(row_of(picture, 90, 20, 300)), 0.25) << device << " " << above_m << " m above";
        });
    }
}

/// The grain belongs to the ground: from a little farther on it is the same, a little lower in the picture.
TEST(NaturalGround, TheGrainStandsStillOnTheGround) {
    RasterScene scene(flat_land());
    ChunkDrawing drawing(scene, natural_design());
    const TerrainDrawInput from = lit_from_above(scene.view(128, 128, 2000, 0, -90));
    const TerrainDrawInput on = lit_from_above(scene.view(128, 126, 2000, 0, -90));
    const ChunkPicture before = drawing.draw(from, 1), after = drawing.draw(on, 1);
    double same = 0, beside = 0;
    int compared = 0;
    for (std::uint32_t i = 122; i < 135; ++i)
        for (std::uint32_t j = 122; j < 133; ++j) {
            const auto a = pixel_of(from.view, scene.post(i, j)), b = pixel_of(on.view, scene.post(i, j));
            if (!a || !b) continue;
            same += std::abs(before.at(a->x, a->y).green - after.at(b->x, b->y).green);
            beside += std::abs(before.at(a->x, a->y).green - after.at(a->x, a->y).green);
            ++compared;
        }
    ASSERT_GT(compared, 60);
    EXPECT_LT(same, 0.6 * beside);
}

/// Dark lines at whole minutes of longitude and latitude, and none halfway. Control: without the grid there are none.
TEST(NaturalGround, P36GridLinesLieAtWholeMinutes) {
    RasterScene scene(flat_land());
    for (const char* device : kDevices) {
        design::DesignSettings design = without_grain();
        const TerrainDrawInput input = lit_from_above(scene.view(128, 128, 6000, 0, -90));
        const auto seen = [&](double strength) {
            design.terrain.style.grid.strength = strength;
            return ChunkDrawing(scene, design, "egl", device).draw(input, 1);
        };
        const ChunkPicture without = seen(0), with = seen(natural_design().terrain.style.grid.strength);
        const auto darkest_at = [&](double minutes_east, double minutes_south) {
            const double i = (minutes_east / 60 - scene.raster.west_deg) / kPostStep_deg;
            const double j = (scene.raster.north_deg + minutes_south / 60) / kPostStep_deg;
            const auto pixel = pixel_of(input.view, earth::to_ecef(scene.place(i, j, 1000)));
            if (!pixel || pixel->x < 3 || pixel->y < 3 || pixel->x > 316 || pixel->y > 236) return -1.0;
            double darkest = 0;
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    darkest = std::max(darkest, lightness(without.at(pixel->x + x, pixel->y + y)) -
                                                    lightness(with.at(pixel->x + x, pixel->y + y)));
            return darkest;
        };
        const double middle_east = std::round((scene.raster.west_deg + 128 * kPostStep_deg) * 60);
        const double middle_south = -std::round((scene.raster.north_deg - 128 * kPostStep_deg) * 60);
        int lines = 0;
        for (int k = -2; k <= 2; ++k) {
            for (const bool is_meridian : {true, false}) {
                const double on = is_meridian ? darkest_at(middle_east + k, middle_south + 0.5)
                                              : darkest_at(middle_east + 0.5, middle_south + k);
                const double off = is_meridian ? darkest_at(middle_east + k + 0.5, middle_south + 0.5)
                                               : darkest_at(middle_east + 0.5, middle_south + k + 0.5);
                if (on < 0 || off < 0) continue;
                EXPECT_GT(on, 4) << device << " line " << k;
                EXPECT_LT(off, 1) << device << " beside line " << k;
                ++lines;
            }
        }
        EXPECT_GE(lines, 4) << device;
    }
}

/// Sea is told from any tint of the land and from the sky by its color, and is darker than the sky; at the coast it is lighter.
TEST(NaturalGround, P37WaterIsToldFromSkyAndLand) {
    const design::DesignSettings design = natural_design();
    const Color sea = design.terrain.sea;
    EXPECT_LT(lightness(sea) + 15, lightness(design.sky.horizon));
    for (const Color sky : {design.sky.horizon, design.sky.zenith}) EXPECT_GT(apart(sea, sky), 10);
    for (const design::ColorStop& stop : design.terrain.palette.stops) {
        EXPECT_GT(apart(sea, stop.color), 20);
        EXPECT_GT(apart(sea, design::wooded(design.terrain.style, stop.color)), 15);
    }
    host_sim::Raster raster = flat_land();
    for (std::uint32_t j = 0; j < 257; ++j)
        for (std::uint32_t i = 0; i < 128; ++i) {
            raster.height_m[raster.at(i, j)] = 0;
            raster.post_class[raster.at(i, j)] = terrain::PostClass::sea;
        }
    RasterScene scene(raster);
    for (const char* device : kDevices) {
        ChunkDrawing drawing(scene, without_grain(), "egl", device);
        const TerrainDrawInput input = lit_from_above(scene.view(116, 128, 1200, 0, -90));
        const ChunkPicture picture = drawing.draw(input, 0.5);
        const auto open = pixel_of(input.view, earth::to_ecef(scene.place(118, 128, 0)));
        ASSERT_TRUE(open);
        EXPECT_LT(apart(picture.at(open->x, open->y), sea), 3) << device;
    }
}

/// Far ground is nearer to the color of the haze than near ground. Control: without haze it is not.
TEST(NaturalGround, P38HazeTellsTheDistance) {
    RasterScene scene(flat_land());
    for (const char* device : kDevices) {
        design::DesignSettings design = natural_design();
        const auto differences = [&](double haze_m) {
            ChunkDrawing drawing(scene, design, "egl", device);
            TerrainDrawInput input = lit_from_above(scene.view(128, 250, 1300, 0, -4));
            input.haze_per_m = haze_m > 0 ? 1 / haze_m : 0;
            const ChunkPicture picture = drawing.draw(input, 1);
            double near = 0, far = 0;
            for (std::uint32_t x = 100; x < 220; ++x) {
                near += apart(picture.at(x, 225), design.sky.haze) / 120;
                far += apart(picture.at(x, 106), design.sky.haze) / 120;
            }
            return near - far;
        };
        EXPECT_GT(differences(15'000), 8) << device;
        EXPECT_LT(std::fabs(differences(0)), 4) << device;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_natural_ground
