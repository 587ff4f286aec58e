// Heights of the radio altimeter against those of an inclined plane, which the raster's posts lie in, worked out from the place.
#include "host_sim/scenario/radio_altimeter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_radio_altimeter {
namespace {

constexpr double kStripLatitude_deg = 47.02, kStripLongitude_deg = 9.7, kStripElevation_m = 1100;
constexpr double kMetresPerDegree = 111'180;  // of latitude, here, within 0.1 %
constexpr double kRange_m = 700;

class RadioAltimeterOverAPlane : public ::testing::Test {
protected:
    RadioAltimeterOverAPlane() {
        strip_.latitude_rad = base::radians(kStripLatitude_deg);
        strip_.longitude_rad = base::radians(kStripLongitude_deg);
        strip_.elevation_msl_m = kStripElevation_m;
        strip_.length_m = 1000;
        strip_.width_m = 30;
    }
    [[nodiscard]] double plane_m(double latitude_deg, double longitude_deg) const {
        const double i = (longitude_deg - raster_.transform[0]) / 0.01 - 0.5,
                     j = (raster_.transform[3] - latitude_deg) / 0.01 - 0.5;
        return 1000 + 7 * i + 3 * j;
    }
    [[nodiscard]] std::optional<double> height_m(double latitude_deg, double longitude_deg, double wheels_msl_m) const {
        const RadioAltimeter altimeter({path_, kRange_m}, strip_);
        return altimeter.height_m(base::radians(latitude_deg), base::radians(longitude_deg), wheels_msl_m);
    }
    /// Heading north, `along_m` from the middle of the strip.
    [[nodiscard]] double height_along_m(double along_m) const {
        return height_m(kStripLatitude_deg + along_m / kMetresPerDegree, kStripLongitude_deg, kStripElevation_m).value_or(NAN);
    }
    test_support::TemporaryFolder folder_;
    test_support::RasterFile raster_;
    std::string path_ = raster_.write(folder_.file("plane.tif"));
    LandingStrip strip_;
};

TEST_F(RadioAltimeterOverAPlane, ReadsTheHeightAboveTheRaster) {
    for (const double latitude_deg : {46.97, 46.993, 47.071})
        for (const double longitude_deg : {9.61, 9.6534, 9.771}) {
            const auto height = height_m(latitude_deg, longitude_deg, 1500);
            ASSERT_TRUE(height.has_value());
            EXPECT_NEAR(*height, 1500 - plane_m(latitude_deg, longitude_deg), 1e-3);
        }
}

TEST_F(RadioAltimeterOverAPlane, TheStripIsLevel) {
    EXPECT_NE(plane_m(kStripLatitude_deg, kStripLongitude_deg), kStripElevation_m);
    for (const double along_m : {-499.0, -200.0, 0.0, 499.0}) EXPECT_EQ(height_along_m(along_m), 0) << along_m;
}

TEST_F(RadioAltimeterOverAPlane, TheGroundRunsStraightFromTheStripToTheRaster) {
    const double beyond_m = kStripElevation_m - plane_m(kStripLatitude_deg + 650 / kMetresPerDegree, kStripLongitude_deg);
    EXPECT_NEAR(height_along_m(650), beyond_m, 0.5);
    EXPECT_NEAR(height_along_m(575), beyond_m / 2, 0.5);
    for (double along_m = 480; along_m < 700; along_m += 1)
        EXPECT_LT(std::fabs(height_along_m(along_m + 1) - height_along_m(along_m)), 0.5) << along_m;
}

TEST_F(RadioAltimeterOverAPlane, StatesNothingBeyondItsRangeAndTheRaster) {
    const double ground_m = plane_m(46.97, 9.65);
    EXPECT_TRUE(height_m(46.97, 9.65, ground_m + kRange_m - 1).has_value());
    EXPECT_FALSE(height_m(46.97, 9.65, ground_m + kRange_m + 1).has_value());
    EXPECT_FALSE(height_m(46.97, 9.3, 1100).has_value());
    EXPECT_FALSE(height_m(48, 9.65, 1100).has_value());
}

TEST_F(RadioAltimeterOverAPlane, AVoidPostHasNoHeight) {
    raster_.no_data = -9999;
    raster_.value = [](int i, int j) { return i == 5 && j == 12 ? -9999.0 : 1000.0; };
    raster_.write(path_);
    const double latitude_deg = raster_.y(5, 12), longitude_deg = raster_.x(5, 12);
    EXPECT_FALSE(height_m(latitude_deg - 0.002, longitude_deg + 0.002, 1200).has_value());
    EXPECT_TRUE(height_m(latitude_deg - 0.002, longitude_deg + 0.022, 1200).has_value());
}

TEST_F(RadioAltimeterOverAPlane, AFileThatIsNoRasterIsNamed) {
    const std::string path = folder_.write("words.tif", "no raster");
    test_support::expect_user_error([&] { const RadioAltimeter altimeter({path, kRange_m}, strip_); }, "words.tif");
}

}  // namespace
}  // namespace tedavis::host_sim::test_radio_altimeter
