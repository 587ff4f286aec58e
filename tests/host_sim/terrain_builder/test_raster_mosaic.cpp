#include "host_sim/terrain_builder/raster_mosaic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_raster_mosaic {
namespace {

using test_support::RasterFile;

struct Warped {
    GeoLattice lattice;
    std::vector<float> heights;

    [[nodiscard]] float at(std::int64_t i, std::int64_t j) const {
        return heights[static_cast<std::size_t>(j * lattice.columns + i)];
    }
    [[nodiscard]] double longitude(std::int64_t i) const {
        return lattice.west_deg + lattice.step_lon_deg * static_cast<double>(i);
    }
    [[nodiscard]] double latitude(std::int64_t j) const {
        return lattice.north_deg - lattice.step_lat_deg * static_cast<double>(j);
    }
};

class RasterMosaicTest : public ::testing::Test {
protected:
    Warped warp(const std::vector<RasterFile>& rasters, const RasterOptions& options = {}) {
        std::vector<std::string> files;
        for (std::size_t n = 0; n < rasters.size(); ++n)
            files.push_back(rasters[n].write(folder_.file("r" + std::to_string(n) + ".tif")));
        const Raster raster = load_rasters(files, options);
        EXPECT_TRUE(raster.resampled);
        return {{raster.west_deg, raster.north_deg, raster.step_lon_deg, raster.step_lat_deg, raster.columns, raster.rows},
                raster.height_m};
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
};

/// A tile of 1200 posts a degree whose heights are a function of its places, `columns` by `rows` posts from the north-west
/// one on; pixels reach half a step beyond the posts, as in SRTM tiles.
RasterFile tile(double west_deg, double north_deg, int columns, int rows, const std::function<double(double, double)>& height,
                double step_deg = 1.0 / 1200) {
    RasterFile raster;
    raster.columns = columns;
    raster.rows = rows;
    raster.transform = {west_deg - step_deg / 2, step_deg, 0, north_deg + step_deg / 2, 0, -step_deg};
    raster.value = [=](int i, int j) { return height(west_deg + step_deg * i, north_deg - step_deg * j); };
    return raster;
}

double bumpy(double lon_deg, double lat_deg) { return 1000 + 300 * std::sin(lon_deg * 700) * std::cos(lat_deg * 900); }

TEST_F(RasterMosaicTest, AlignedTilesKeepTheirPosts) {
    const Warped warped =
        warp({tile(9, 47, 61, 41, bumpy), tile(9.05, 47, 61, 41, bumpy), tile(9, 47 - 40.0 / 1200, 61, 41, bumpy)});
    ASSERT_EQ(warped.lattice.columns, 121);
    ASSERT_EQ(warped.lattice.rows, 81);
    EXPECT_NEAR(warped.lattice.west_deg, 9, 1e-12);
    EXPECT_NEAR(warped.lattice.north_deg, 47, 1e-12);
    for (std::int64_t j = 0; j < 81; ++j) {
        for (std::int64_t i = 0; i < 121; ++i) {
            const bool covered = i <= 60 || j <= 40;
            ASSERT_EQ(std::isnan(warped.at(i, j)), !covered) << i << "," << j;
            if (covered) {
                ASSERT_NEAR(warped.at(i, j), bumpy(warped.longitude(i), warped.latitude(j)), 0.01) << i << "," << j;
            }
        }
    }
}

TEST_F(RasterMosaicTest, TheFinestStepCountsAndTheLaterFileLiesOnTop) {
    const auto flat = [](double height) { return [height](double, double) { return height; }; };
    const Warped warped = warp({tile(9, 47, 30, 30, flat(100)), tile(9.005, 46.995, 40, 40, flat(200), 1.0 / 3600)});
    EXPECT_NEAR(warped.lattice.step_lon_deg, 1.0 / 3600, 1e-12);
    EXPECT_NEAR(warped.lattice.step_lat_deg, 1.0 / 3600, 1e-12);
    EXPECT_EQ(warped.at(0, 0), 100);
    EXPECT_EQ(warped.at(36, 36), 200) << "at 9.010 E 46.990 N";
}

TEST_F(RasterMosaicTest, VoidsDoNotBleedIntoTheirNeighbours) {
    RasterFile marked = tile(9, 47, 40, 40, [](double, double) { return 700; });
    marked.value = [](int i, int j) { return i == 20 && j == 20 ? -9999.0 : 700.0; };
    RasterOptions options;
    options.void_value = -9999;
    RasterFile turned = marked;  // the same, turned by a few degrees about its corner, so that every post is interpolated
    turned.transform = {9, 0.8e-3, 0.1e-3, 47, 0.1e-3, -0.8e-3};
    const Warped warped = warp({turned}, options);
    int voids = 0, heights = 0;
    for (const float h : warped.heights) {
        if (std::isnan(h)) {
            ++voids;
        } else {
            ++heights;
            ASSERT_NEAR(h, 700, 1e-3);
        }
    }
    EXPECT_GT(heights, 1000);
    EXPECT_GT(voids, 0) << "the corners at least";
}

/// swisstopo, "Formulas and constants for the calculation of the Swiss conformal cylindrical projection": WGS84 to LV03,
/// approximate, good to a metre.
struct Lv03 {
    double east, north;
};
Lv03 lv03(double longitude_deg, double latitude_deg) {
    const double p = (latitude_deg * 3600 - 169028.66) / 10000, l = (longitude_deg * 3600 - 26782.5) / 10000;
    return {600072.37 + 211455.93 * l - 10938.51 * l * p - 0.36 * l * p * p - 44.54 * l * l * l,
            200147.07 + 308807.95 * p + 3745.25 * l * l + 76.63 * p * p - 194.56 * l * l * p + 119.79 * p * p * p};
}

/// Tilted plane over Swiss coordinates, which bilinear interpolation reproduces.
double swiss_plane(double east, double north) { return 1500 + 0.04 * (east - 780000) - 0.07 * (north - 185000); }

void expect_swiss_plane(const Warped& warped, std::size_t fewest) {
    std::size_t compared = 0;
    for (std::int64_t j = 0; j < warped.lattice.rows; ++j) {
        for (std::int64_t i = 0; i < warped.lattice.columns; ++i) {
            if (std::isnan(warped.at(i, j))) continue;
            const Lv03 place = lv03(warped.longitude(i), warped.latitude(j));
            ASSERT_NEAR(warped.at(i, j), swiss_plane(place.east, place.north), 1.5) << i << "," << j;
            ++compared;
        }
    }
    EXPECT_GT(compared, fewest);
}

/// The largest difference of a post from the mean of its neighbours: a plane has next to none, a shifted sample has.
double roughness_m(const Warped& warped) {
    double largest = 0;
    for (std::int64_t j = 2; j + 2 < warped.lattice.rows; ++j)
        for (std::int64_t i = 2; i + 2 < warped.lattice.columns; ++i) {
            const double bend = warped.at(i, j) - 0.25 * (double{warped.at(i - 1, j)} + warped.at(i + 1, j) +
                                                          warped.at(i, j - 1) + warped.at(i, j + 1));
            if (!std::isnan(bend)) largest = std::max(largest, std::abs(bend));
        }
    return largest;
}

RasterFile swiss(std::array<double, 6> transform) {
    RasterFile raster;
    raster.columns = 120;
    raster.rows = 90;
    raster.crs = "EPSG:21781";
    raster.transform = transform;
    const RasterFile place = raster;
    raster.value = [place](int i, int j) { return swiss_plane(place.x(i, j), place.y(i, j)); };
    return raster;
}

TEST_F(RasterMosaicTest, SwissCoordinatesComeWhereSwisstopoPutsThem) {
    const Warped warped = warp({swiss({780000, 25, 0, 187000, 0, -25})});
    expect_swiss_plane(warped, 120 * 90 * 9 / 10);
    EXPECT_NEAR(warped.lattice.step_lat_deg, 25 / 111180.0, 25 / 111180.0 * 0.01) << "25 m northwards";
    EXPECT_NEAR(warped.lattice.step_lon_deg, 25 / (111420.0 * std::cos(base::radians(46.8))), 25 / 76000.0 * 0.01)
        << "25 m eastwards";
    EXPECT_LT(roughness_m(warped), 0.6) << "a border extrapolates by half a post at most";
}

TEST_F(RasterMosaicTest, TurnedAndUpsideDownRastersLieRight) {
    const double c = 25 * std::cos(0.5), s = 25 * std::sin(0.5);
    expect_swiss_plane(warp({swiss({780000, c, s, 187000, s, -c})}), 120 * 90 * 9 / 10);
    expect_swiss_plane(warp({swiss({780000, 25, 0, 185000, 0, 25})}), 120 * 90 * 9 / 10);
}

TEST_F(RasterMosaicTest, AMosaicOfProjectionsIsOneSurface) {
    const Warped warped = warp({swiss({780000, 25, 0, 187000, 0, -25}), swiss({783000, 20, 0, 187000, 0, -20})});
    expect_swiss_plane(warped, 120 * 90 * 15 / 10);
    EXPECT_NEAR(warped.lattice.step_lat_deg, 20 / 111180.0, 20 / 111180.0 * 0.01);
}

TEST_F(RasterMosaicTest, TilesMeetAtTheAntimeridian) {
    const auto by_place = [](double lon_deg, double lat_deg) {
        return 500 + 1000 * std::remainder(lon_deg - 180, 360.0) + 100 * (lat_deg + 17);
    };
    for (const bool east_first : {false, true}) {
        std::vector<RasterFile> tiles = {tile(179.95, -17, 61, 41, by_place), tile(-180, -17, 61, 41, by_place)};
        if (east_first) std::swap(tiles[0], tiles[1]);
        const Warped warped = warp(tiles);
        ASSERT_EQ(warped.lattice.columns, 121);
        ASSERT_EQ(warped.lattice.rows, 41);
        for (std::int64_t j = 0; j < 41; ++j)
            for (std::int64_t i = 0; i < 121; ++i)
                ASSERT_NEAR(warped.at(i, j), by_place(warped.longitude(i), warped.latitude(j)), 0.01) << i << "," << j;
    }
}

TEST_F(RasterMosaicTest, AProjectedRasterCrossesTheAntimeridian) {
    RasterFile raster;  // UTM zone 60 south, across its east border
    raster.crs = "EPSG:32760";
    raster.columns = raster.rows = 60;
    raster.transform = {815000, 100, 0, 8115000, 0, -100};
    raster.value = [](int, int) { return 400; };
    const Warped warped = warp({raster});
    ASSERT_LT(warped.lattice.columns, 200);
    EXPECT_LT(warped.longitude(0), 180);
    EXPECT_GT(warped.longitude(warped.lattice.columns - 1), 180);
    std::int64_t heights = 0;
    for (const float h : warped.heights) heights += h == 400 ? 1 : 0;
    EXPECT_GT(heights, 60 * 60 * 9 / 10);
    EXPECT_EQ(warped.at(warped.lattice.columns / 2, warped.lattice.rows / 2), 400);
}

TEST_F(RasterMosaicTest, BoundsCutWholeSteps) {
    RasterOptions options;
    options.bounds = GeoBounds{9.0100001, 46.98, 9.05, 46.9899999};
    const std::vector<RasterFile> tiles = {tile(9, 47, 61, 41, bumpy), tile(9.05, 47, 61, 41, bumpy)};
    const Warped warped = warp(tiles, options);
    EXPECT_EQ(warped.lattice.columns, 48);
    EXPECT_EQ(warped.lattice.rows, 12);
    EXPECT_NEAR(warped.longitude(0), 9 + 13.0 / 1200, 1e-9);
    EXPECT_NEAR(warped.latitude(0), 47 - 13.0 / 1200, 1e-9);
    EXPECT_NEAR(warped.at(5, 5), bumpy(warped.longitude(5), warped.latitude(5)), 0.01);
    options.bounds = GeoBounds{20, 10, 30, 11};
    std::vector<RasterSource> sources;
    sources.push_back(open_raster_source(folder_.file("r0.tif"), {}));
    EXPECT_LT(plan_lattice(sources, options).columns, 2);
}

}  // namespace
}  // namespace tedavis::host_sim::test_raster_mosaic
