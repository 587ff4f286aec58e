#include "host_sim/terrain_builder/attributes/surface_shape.hpp"

#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "host_sim/terrain_builder/attributes/direct_light.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/terrain/attribute_terrain.hpp"

namespace tedavis::host_sim::test_surface_shape {
namespace {

using terrain::PostClass;
using test_support::make_tile;
using test_support::post_of;

TEST(SurfaceShape, APlaneHasItsNormalAtEveryPostAndNoCurvature) {
    constexpr double kRiseEast = 0.25, kRiseNorth = -0.5;
    const AttributeTile tile =
        make_tile(9, 6, 16, 32, [](int i, int j) { return 512 + kRiseEast * 16 * i - kRiseNorth * 32 * j; });
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    const double length = std::sqrt(1 + kRiseEast * kRiseEast + kRiseNorth * kRiseNorth);
    for (int row = -kHorizonReach; row < tile.rows + kHorizonReach; ++row) {
        for (int column = -kHorizonReach; column < tile.columns + kHorizonReach; ++column) {
            const std::size_t at = planes.at(column, row);
            const NormalLanes normal = normal_of(load(&gradients.east[at]), load(&gradients.north[at]));
            ASSERT_NEAR(normal.east[0], -kRiseEast / length, 1e-6) << column << " " << row;
            ASSERT_NEAR(normal.north[0], -kRiseNorth / length, 1e-6);
            ASSERT_NEAR(normal.up[0], 1 / length, 1e-6);
            ASSERT_EQ(curvature(planes, gradients, at, 16)[0], 0);
        }
    }
}

/// The nearest number with 11 bits, as a half float holds it: above 4096 m in steps of 4 m.
double half_of(double height_m) {
    int exponent = 0;
    static_cast<void>(std::frexp(height_m, &exponent));
    return std::ldexp(std::round(std::ldexp(height_m, 11 - exponent)), exponent - 11);
}

/// The worst angle of the normal of planes on posts 30 m apart, whose heights are rounded.
template <class Rounded>
double worst_normal_deg(double lowest_m, const Rounded& rounded) {
    double worst_deg = 0;
    for (const double rise : {0.013, 0.07, 0.21, 0.55}) {
        const AttributeTile tile =
            make_tile(60, 1, 30, 30, [&](int i, int j) { return rounded(lowest_m + 30 * rise * (i - 0.37 * j)); });
        const HeightPlanes planes(tile);
        const Gradients gradients(planes);
        const double length = std::sqrt(1 + rise * rise * (1 + 0.37 * 0.37));
        for (int column = 0; column < tile.columns; ++column) {
            const std::size_t at = planes.at(column, 0);
            const NormalLanes n = normal_of(load(&gradients.east[at]), load(&gradients.north[at]));
            const double cosine = (-rise * n.east[0] - 0.37 * rise * n.north[0] + n.up[0]) / length;
            worst_deg = std::max(worst_deg, base::degrees(std::acos(std::min(1.0, cosine))));
        }
    }
    return worst_deg;
}

// Whole metres: steps of the heights turn the normal by less than a degree.
TEST(SurfaceShape, HeightsInWholeMetresKeepTheNormalOfAPlane) {
    const auto whole = [](double height_m) { return std::round(height_m); };
    const double worst_deg = std::max(worst_normal_deg(700, whole), worst_normal_deg(6000, whole)),
                 half_deg = worst_normal_deg(6000, half_of);
    EXPECT_LT(worst_deg, 0.96);
    EXPECT_GT(worst_deg, 0.1) << "whole metres do show";
    EXPECT_GT(half_deg, 0.96) << "control: half floats";
    EXPECT_LT(worst_normal_deg(6000, [](double height_m) { return height_m; }), 0.05) << "all that an arc cosine of floats tells";
    test_support::record_worst("A09", worst_deg);
    test_support::record_control("A09", half_deg);
}

// All 2^9 patterns of voids in the stencil: a plane keeps its rises wherever two posts of a line are left, and is level
// where none is.
TEST(SurfaceShape, VoidsInTheStencilDoNotBendAPlane) {
    for (int pattern = 0; pattern < 512; ++pattern) {
        AttributeTile tile = make_tile(1, 1, 16, 16, [](int i, int j) { return 100 + 4 * i - 8 * j; });
        bool known[3][3];
        for (int n = 0; n < 9; ++n) {
            known[n / 3][n % 3] = (pattern >> n & 1) == 0;
            if (known[n / 3][n % 3]) continue;
            tile.post_class[post_of(tile, n % 3 - 1, n / 3 - 1)] = PostClass::void_;
            tile.height_m[post_of(tile, n % 3 - 1, n / 3 - 1)] = -32768;
        }
        const HeightPlanes planes(tile);
        const Gradients gradients(planes);
        bool row_known = false, column_known = false;
        for (int n = 0; n < 3; ++n) {
            row_known = row_known || known[n][0] + known[n][1] + known[n][2] > 1;
            column_known = column_known || known[0][n] + known[1][n] + known[2][n] > 1;
        }
        ASSERT_EQ(gradients.east[planes.at(0, 0)], row_known ? 0.25f : 0.0f) << pattern;
        ASSERT_EQ(gradients.north[planes.at(0, 0)], column_known ? 0.5f : 0.0f) << pattern;
        ASSERT_EQ(curvature(planes, gradients, planes.at(0, 0), 16)[0], 0) << pattern;
    }
}

// Oracle: mean curvature of surfaces whose curvature is known; ridges are positive.
TEST(SurfaceShape, CurvatureIsThatOfSpheresAndCylinders) {
    constexpr double kRadius_m = 5000;
    const auto at_centre = [](double east_m, double north_m, const test_support::HeightFormula& height_m) {
        const AttributeTile tile = make_tile(1, 1, east_m, north_m, height_m);
        const HeightPlanes planes(tile);
        return static_cast<double>(curvature(planes, Gradients(planes), planes.at(0, 0), east_m)[0]);
    };
    const auto dome = [](double x, double y) { return std::sqrt(kRadius_m * kRadius_m - x * x - y * y) - kRadius_m; };
    EXPECT_NEAR(at_centre(20, 20, [&](int i, int j) { return dome(20.0 * i, 20.0 * j); }), 20 / kRadius_m, 2e-5);
    EXPECT_NEAR(at_centre(20, 20, [&](int i, int j) { return -dome(20.0 * i, 20.0 * j); }), -20 / kRadius_m, 2e-5);
    EXPECT_NEAR(at_centre(20, 45, [&](int i, int j) { return dome(20.0 * i, 45.0 * j); }), 30 / kRadius_m, 5e-5)
        << "times the geometric mean of the spacings";
    const auto tilted = [&](int i, int j) { return dome(20.0 * i + 2000, 20.0 * j + 1000); };
    EXPECT_NEAR(at_centre(20, 20, tilted), 20 / kRadius_m, 5e-5) << "the curvature of a sphere does not depend on the slope";
    const auto cylinder = [&](int i, int) { return dome(20.0 * i, 0); };
    EXPECT_NEAR(at_centre(20, 20, cylinder), 10 / kRadius_m, 2e-5) << "half of the sphere's";
}

class Gdaldem {
public:
    Gdaldem(const Raster& raster, double east_m, double north_m) {
        GDALAllRegister();
        GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
        const int columns = static_cast<int>(raster.columns), rows = static_cast<int>(raster.rows);
        source_.reset(memory->Create("", columns, rows, 1, GDT_Float32, nullptr));
        double transform[6] = {0, east_m, 0, 0, 0, -north_m};
        source_->SetGeoTransform(transform);
        EXPECT_EQ(source_->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, const_cast<float*>(raster.height_m.data()),
                                                      columns, rows, GDT_Float32, 0, 0),
                  CE_None);
    }
    std::vector<float> run(const char* processing, std::vector<const char*> words) {
        words.insert(words.begin(), {"-of", "MEM"});
        words.push_back(nullptr);
        GDALDEMProcessingOptions* const options = GDALDEMProcessingOptionsNew(const_cast<char**>(words.data()), nullptr);
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> result(GDALDataset::FromHandle(
            GDALDEMProcessing("", GDALDataset::ToHandle(source_.get()), processing, nullptr, options, nullptr)));
        GDALDEMProcessingOptionsFree(options);
        const int columns = source_->GetRasterXSize(), rows = source_->GetRasterYSize();
        std::vector<float> values(static_cast<std::size_t>(columns * rows));
        EXPECT_EQ(
            result->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float32, 0, 0),
            CE_None);
        return values;
    }

private:
    std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> source_;
};

TEST(SurfaceShape, SlopeAndHillshadeOfTheShippedTerrainAreGdals) {
    const Raster raster = load_rasters({test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif"}, {});
    const int columns = static_cast<int>(raster.columns), rows = static_cast<int>(raster.rows);
    constexpr double kEast_m = 74.5, kNorth_m = 92.6, kAzimuth = base::radians(315), kElevation = base::radians(45);
    const AttributeTile tile = make_tile(columns, rows, kEast_m, kNorth_m, [&](int i, int j) {
        return raster.height_m[raster.at(static_cast<std::uint32_t>(std::clamp(i, 0, columns - 1)),
                                         static_cast<std::uint32_t>(std::clamp(j, 0, rows - 1)))];
    });
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    Gdaldem gdal(raster, kEast_m, kNorth_m);
    const std::vector<float> slope = gdal.run("slope", {}), shade = gdal.run("hillshade", {"-az", "315", "-alt", "45"});
    double worst_slope = 0, worst_shade = 0, steepest = 0;
    for (int j = 1; j + 1 < rows; ++j) {
        for (int i = 1; i + 1 < columns; ++i) {
            const std::size_t at = planes.at(i, j), pixel = index_of(i, j, columns);
            const NormalLanes n = normal_of(load(&gradients.east[at]), load(&gradients.north[at]));
            const double slope_deg = base::degrees(std::acos(std::min(1.0, static_cast<double>(n.up[0]))));
            const double lambert = std::cos(kElevation) * (std::sin(kAzimuth) * n.east[0] + std::cos(kAzimuth) * n.north[0]) +
                                   std::sin(kElevation) * n.up[0];
            worst_slope = std::max(worst_slope, std::abs(slope_deg - slope[pixel]));
            worst_shade = std::max(worst_shade, std::abs(1 + 254 * std::max(0.0, lambert) - shade[pixel]));
            steepest = std::max(steepest, slope_deg);
        }
    }
    EXPECT_LT(worst_slope, 0.02) << "degrees; acos of a float near 1";
    EXPECT_LE(worst_shade, 1);
    EXPECT_GT(steepest, 20) << "or there was nothing to compare";
}

}  // namespace
}  // namespace tedavis::host_sim::test_surface_shape
