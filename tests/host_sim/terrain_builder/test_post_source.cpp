#include "host_sim/terrain_builder/post_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_post_source {
namespace {

using terrain::PostClass;
using test_support::expect_user_error;
using test_support::RasterFile;

struct Posts {
    std::vector<float> heights_m;
    std::vector<PostClass> classes;
};

Posts read(PostSource& source, std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows) {
    Posts posts;
    posts.heights_m.resize(std::size_t{columns} * rows);
    posts.classes.resize(posts.heights_m.size());
    source.read(i, j, columns, rows, posts.heights_m, posts.classes);
    return posts;
}

/// Voids are equal too.
bool same_height(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Every window of a size against the raster that load_rasters gives.
void expect_windows(PostSource& source, const Raster& raster, std::uint32_t width, std::uint32_t height) {
    ASSERT_EQ(source.grid().columns, raster.columns);
    ASSERT_EQ(source.grid().rows, raster.rows);
    for (std::uint32_t j = 0; j < raster.rows; j += height) {
        for (std::uint32_t i = 0; i < raster.columns; i += width) {
            const std::uint32_t columns = std::min(width, raster.columns - i), rows = std::min(height, raster.rows - j);
            const Posts posts = read(source, i, j, columns, rows);
            for (std::uint32_t n = 0; n < columns * rows; ++n) {
                const std::size_t at = raster.at(i + n % columns, j + n / columns);
                ASSERT_TRUE(same_height(posts.heights_m[n], raster.height_m[at])) << i << "," << j << ": " << n;
                ASSERT_EQ(posts.classes[n], raster.post_class[at]);
            }
        }
    }
}

class PostSourceTest : public ::testing::Test {
protected:
    PostSourceTest() {
        plain_.columns = 150;
        plain_.rows = 110;
        plain_.transform = {9.6, 0.001, 0, 47.1, 0, -0.001};
        plain_.no_data = -9999;
        plain_.value = [](int i, int j) {
            return (i * j) % 37 == 5 ? -9999.0 : i < 20 ? 0.0 : 1000 + 30 * std::sin(0.3 * i) + 0.77 * j;
        };
        swiss_ = plain_;
        swiss_.crs = "EPSG:21781";
        swiss_.transform = {780000, 40, 0, 187000, 0, -40};
    }
    std::string write(const RasterFile& raster, const char* name) { return raster.write(folder_.file(name)); }
    void expect_every_window(const std::vector<std::string>& files, const RasterOptions& options = {}) {
        const Raster raster = load_rasters(files, options);
        PostSource source(files, options);
        EXPECT_EQ(source.grid().west_deg, raster.west_deg);
        EXPECT_EQ(source.grid().north_deg, raster.north_deg);
        EXPECT_EQ(source.grid().step_lon_deg, raster.step_lon_deg);
        EXPECT_EQ(source.grid().step_lat_deg, raster.step_lat_deg);
        EXPECT_EQ(source.resampled(), raster.resampled);
        EXPECT_EQ(source.grid().source, raster.source);
        expect_windows(source, raster, 65, 65);
        expect_windows(source, raster, 23, 200);
        expect_windows(source, raster, raster.columns, 1);
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
    RasterFile plain_, swiss_;
};

TEST_F(PostSourceTest, EveryWindowHoldsTheBitsOfTheWhole) {
    const std::string plain = write(plain_, "plain.tif"), swiss = write(swiss_, "swiss.tif");
    RasterFile fine = plain_;
    fine.transform = {9.63, 0.0007, 0, 47.05, 0, -0.0007};
    RasterOptions bounds;
    bounds.bounds = GeoBounds{9.62, 47.02, 9.71, 47.09};
    RasterOptions ellipsoid;
    ellipsoid.vertical_datum = VerticalDatum::ellipsoid;
    expect_every_window({plain});
    expect_every_window({plain}, bounds);
    expect_every_window({plain}, ellipsoid);
    expect_every_window({swiss});
    expect_every_window({swiss}, ellipsoid);
    expect_every_window({plain, write(fine, "fine.tif")}, bounds);
    expect_every_window({swiss, plain});
}

TEST_F(PostSourceTest, MoreFilesThanMayBeOpenAreReadAlike) {
    std::vector<std::string> files;
    for (int n = 0; n < 30; ++n) {
        RasterFile tile;
        tile.columns = tile.rows = 11;
        tile.transform = {9 + 0.1 * n, 0.01, 0, 47, 0, -0.01};
        tile.value = [n](int i, int j) { return 100 + 10 * n + i + 0.5 * j; };
        files.push_back(write(tile, ("t" + std::to_string(n) + ".tif").c_str()));
    }
    ASSERT_GT(files.size(), PostSource::kMaxOpenFiles);
    PostSource source(files, {});
    ASSERT_EQ(source.grid().columns, 301u);
    for (int pass = 0; pass < 2; ++pass) {
        const Posts posts = read(source, 0, 0, 301, 11);
        for (int i = 0; i < 300; ++i) ASSERT_EQ(posts.heights_m[static_cast<std::size_t>(i)], static_cast<float>(100 + i)) << i;
    }
}

TEST_F(PostSourceTest, OneObjectAThreadGivesEqualBits) {
    const std::vector<std::string> files = {write(swiss_, "swiss.tif"), write(plain_, "plain.tif")};
    const Raster raster = load_rasters(files, {});
    std::vector<std::thread> threads;
    std::vector<Posts> found(3);
    for (Posts& posts : found)
        threads.emplace_back([&] {
            PostSource source(files, {});
            posts = read(source, 0, 0, source.grid().columns, source.grid().rows);
        });
    for (std::thread& thread : threads) thread.join();
    for (const Posts& posts : found)
        EXPECT_EQ(std::memcmp(posts.heights_m.data(), raster.height_m.data(), raster.height_m.size() * sizeof(float)), 0);
}

TEST_F(PostSourceTest, AlignedTilesKeepTheirBits) {
    RasterFile east = plain_;
    east.transform[0] += 0.150;
    const Raster west_alone = load_rasters({write(plain_, "w.tif")}, {});
    const Raster both = load_rasters({write(east, "e.tif"), write(plain_, "w.tif")}, {});
    ASSERT_EQ(both.columns, 300u);
    for (std::uint32_t j = 0; j < 110; ++j)
        for (std::uint32_t i = 0; i < 150; ++i)
            ASSERT_TRUE(same_height(both.height_m[both.at(i, j)], west_alone.height_m[west_alone.at(i, j)])) << i << "," << j;
}

// A file of nothing but its header: 2^20 posts a side.
TEST_F(PostSourceTest, ARasterFarBeyondTheMemoryIsReadByWindows) {
    GDALAllRegister();
    const std::string path = folder_.file("sparse.tif");
    const char* const options[] = {"SPARSE_OK=TRUE", "TILED=YES", "BLOCKXSIZE=4096", "BLOCKYSIZE=4096", "BIGTIFF=YES", nullptr};
    constexpr int kSide = 1 << 20;
    {
        const GdalDataset file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), kSide, kSide, 1, GDT_Int16,
                                                                                        const_cast<char**>(options)));
        ASSERT_NE(file, nullptr);
        double transform[6] = {0, 1e-5, 0, 40, 0, -1e-5};
        file->SetGeoTransform(transform);
        const OGRSpatialReference wgs84 = wgs84_longitude_latitude();
        file->SetSpatialRef(&wgs84);
        std::int16_t summit = 4321;
        ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, kSide - 3, kSide - 2, 1, 1, &summit, 1, 1, GDT_Int16, 0, 0),
                  CE_None);
    }
    PostSource source({path}, {});
    EXPECT_EQ(source.grid().columns, 1u << 20);
    const Posts posts = read(source, kSide - 4, kSide - 4, 4, 4);
    EXPECT_EQ(posts.heights_m[2 * 4 + 1], 4321);
    EXPECT_EQ(posts.classes[0], PostClass::sea);
    expect_user_error([&] { (void)load_rasters({path}, {}); }, "more than 2^30 posts do not fit the memory");
}

TEST_F(PostSourceTest, DamageIsFoundWhereItIsRead) {
    RasterFile large = plain_;
    large.columns = large.rows = 300;
    write(large, "whole.tif");
    const std::string bytes = folder_.read("whole.tif");
    PostSource source({folder_.write("cut.tif", bytes.substr(0, bytes.size() / 2))}, {});
    EXPECT_NO_THROW((void)read(source, 0, 0, 300, 10));
    expect_user_error([&] { (void)read(source, 0, 290, 300, 10); }, "cut.tif: the raster ends early");
}

}  // namespace
}  // namespace tedavis::host_sim::test_post_source
