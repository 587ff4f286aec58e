#include "render_core/design/warning_bands.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "render_core/base/units.hpp"

namespace tedavis::design::test_warning_bands {
namespace {

std::size_t band_at(const WarningBands& bands, double above_ft, bool gear_down = false) {
    return band_of(bands, above_ft * base::kMetresPerFoot, gear_down);
}

TEST(WarningBands, EgpwsLimitsOfTheManual) {
    const WarningBands bands = egpws_bands();
    EXPECT_EQ(band_at(bands, 2001), 0u);
    EXPECT_EQ(band_at(bands, 1999), 1u);
    EXPECT_EQ(band_at(bands, 1001), 1u);
    EXPECT_EQ(band_at(bands, 999), 2u);
    EXPECT_EQ(band_at(bands, -499), 2u);
    EXPECT_EQ(band_at(bands, -501), 3u);
    EXPECT_EQ(band_at(bands, -999), 3u);
    EXPECT_EQ(band_at(bands, -1001), 4u);
    EXPECT_EQ(band_at(bands, -1999), 4u);
    EXPECT_EQ(band_at(bands, -2001), bands.size());
    EXPECT_EQ(bands[1].color, bands[2].color);  // two densities of yellow
    EXPECT_GT(bands[1].strength, bands[2].strength);
    EXPECT_EQ(bands[3].color, bands[4].color);  // and of green
    EXPECT_GT(bands[3].strength, bands[4].strength);
}

TEST(WarningBands, GearDownNarrowsTheYellowBandOnly) {
    const WarningBands bands = egpws_bands();
    EXPECT_EQ(band_at(bands, -300, false), 2u);
    EXPECT_EQ(band_at(bands, -300, true), 3u);
    EXPECT_EQ(band_at(bands, -249, true), 2u);
    for (double ft : {2500.0, 1500.0, -700.0, -1500.0, -3000.0})
        EXPECT_EQ(band_at(bands, ft, true), band_at(bands, ft, false)) << ft;
}

TEST(WarningBands, GarminLimits) {
    const WarningBands bands = garmin_bands();
    EXPECT_EQ(band_at(bands, 5000), 0u);
    EXPECT_EQ(band_at(bands, -99), 0u);
    EXPECT_EQ(band_at(bands, -101), 1u);
    EXPECT_EQ(band_at(bands, -999), 1u);
    EXPECT_EQ(band_at(bands, -1001), bands.size());
}

TEST(WarningBands, OrderCheckFindsEverySwap) {
    for (const WarningBands& good : {egpws_bands(), garmin_bands()}) {
        EXPECT_EQ(first_band_out_of_order(good), good.size());
        for (std::size_t i = 1; i < good.size(); ++i) {
            WarningBands swapped = good;
            std::swap(swapped[i], swapped[i - 1]);
            EXPECT_EQ(first_band_out_of_order(swapped), i);
        }
    }
    WarningBands not_a_number = garmin_bands();
    not_a_number[1].lower_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(first_band_out_of_order(not_a_number), 1u);
}

}  // namespace
}  // namespace tedavis::design::test_warning_bands
