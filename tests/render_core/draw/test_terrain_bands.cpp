#include "render_core/draw/terrain_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::draw::test_terrain_bands {
namespace {

using design::WarningBands;

/// What the shader does with the bands of a chunk: index of the last that holds, from the lowest up; -1 for none.
int shaded_band(const TerrainBands& bands, float height_m) {
    int found = -1;
    for (std::size_t n = 0; n < design::kMaxWarningBands; ++n)
        if (height_m >= bands.lower_m[n]) found = static_cast<int>(n);
    return found;
}

TEST(TerrainBands, EveryHeightOfAChunkGetsTheColorOfTheDesignsTable) {
    for (const WarningBands& bands : {design::egpws_bands(), design::garmin_bands()})
        for (const bool gear_down : {false, true})
            for (double aircraft_m = 0; aircraft_m < 4000; aircraft_m += 173.3)
                for (float least = -100; least < 3000; least += 211)
                    for (const float relief : {0.0f, 40.0f, 700.0f, 5000.0f}) {
                        const TerrainBands within = bands_within(bands, aircraft_m, gear_down, least, least + relief);
                        for (float height = least; height <= least + relief; height += relief / 7 + 0.1f) {
                            const std::size_t expected = design::band_of(bands, double{height} - aircraft_m, gear_down);
                            const int shaded = shaded_band(within, height);
                            if (expected == bands.size()) {
                                EXPECT_EQ(shaded, -1) << height << " of " << aircraft_m;
                                continue;
                            }
                            ASSERT_GE(shaded, 0) << height << " of " << aircraft_m;
                            EXPECT_FLOAT_EQ(within.color[4 * shaded + 3], static_cast<float>(bands[expected].strength));
                            EXPECT_FLOAT_EQ(within.color[4 * shaded], static_cast<float>(bands[expected].color.red) / 255.0f);
                        }
                    }
}

TEST(TerrainBands, OnlyThoseThatTheChunkMeetsAreKept) {
    const WarningBands bands = design::egpws_bands();
    EXPECT_EQ(bands_within(bands, 3000, false, 100, 900).count, 0u) << "far below";
    EXPECT_EQ(bands_within(bands, 1000, false, 1700, 1800).count, 1u) << "all of it in the highest band";
    EXPECT_EQ(bands_within(bands, 1000, false, 0, 9000).count, bands.size());
}

TEST(TerrainBands, TheGearMovesItsOwnLimitOnly) {
    const WarningBands bands = design::egpws_bands();
    const float between = 1000 - 100;  // under the limit with the gear down, above the one with the gear up
    const TerrainBands up = bands_within(bands, 1000, false, between, between),
                       down = bands_within(bands, 1000, true, between, between);
    ASSERT_EQ(up.count, 1u);
    ASSERT_EQ(down.count, 1u);
    EXPECT_LT(up.lower_m[0], between);
    EXPECT_NE(up.lower_m[0], down.lower_m[0]);
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_bands
