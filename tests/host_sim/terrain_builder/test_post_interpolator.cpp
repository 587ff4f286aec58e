#include "host_sim/terrain_builder/post_interpolator.hpp"

#include <cpl_string.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/quiet_gdal.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_post_interpolator {
namespace {

using test_support::RasterFile;

RasterFile swiss_hills() {
    RasterFile raster;
    raster.crs = "EPSG:21781";
    raster.columns = 120;
    raster.rows = 90;
    raster.transform = {780000, 25, 0, 187000, 0, -25};
    raster.no_data = -9999;
    raster.value = [](int i, int j) {
        if (i > 70 && i < 75 && j > 20 && j < 30) return -9999.0;
        return 1500 + 300 * std::sin(0.2 * i) * std::cos(0.17 * j);
    };
    return raster;
}

class PostInterpolatorTest : public ::testing::Test {
protected:
    void open(const RasterFile& raster) {
        path_ = raster.write(folder_.file("r.tif"));
        sources_.clear();
        sources_.push_back(open_raster_source(path_, {}));
        lattice_ = plan_lattice(sources_, {});
    }
    /// All posts of the lattice, in windows of a size.
    std::vector<float> heights(std::int64_t step) {
        const PostInterpolator interpolator(sources_[0], lattice_);
        std::vector<float> all(static_cast<std::size_t>(lattice_.columns * lattice_.rows));
        for (std::int64_t j = 0; j < lattice_.rows; j += step) {
            for (std::int64_t i = 0; i < lattice_.columns; i += step) {
                const std::int64_t columns = std::min(step, lattice_.columns - i), rows = std::min(step, lattice_.rows - j);
                const PostInterpolator::Block block = interpolator.locate(i, j, columns, rows);
                const std::vector<float> pixels =
                    block.pixels.columns == 0 ? std::vector<float>() : read_heights(sources_[0], block.pixels, {});
                for (std::int64_t n = 0; n < columns * rows; ++n)
                    all[static_cast<std::size_t>((j + n / columns) * lattice_.columns + i + n % columns)] =
                        interpolator.height_at(block, static_cast<std::size_t>(n), pixels);
            }
        }
        return all;
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
    std::string path_;
    std::vector<RasterSource> sources_;
    GeoLattice lattice_;
};

/// Oracle: GDAL's warper, exact and bilinear, onto the same lattice.
std::vector<float> warped_by_gdal(const std::string& path, const GeoLattice& l) {
    const double west = l.west_deg - 0.5 * l.step_lon_deg, north = l.north_deg + 0.5 * l.step_lat_deg;
    const auto columns = static_cast<double>(l.columns), rows = static_cast<double>(l.rows);
    CPLStringList arguments;
    for (const char* word : {"-of", "MEM", "-r", "bilinear", "-et", "0", "-wo", "XSCALE=1", "-wo", "YSCALE=1", "-t_srs",
                             "OGC:CRS84", "-dstnodata", "-32768", "-te"})
        arguments.AddString(word);
    for (const double edge : {west, north - l.step_lat_deg * rows, west + l.step_lon_deg * columns, north})
        arguments.AddString(CPLSPrintf("%.17g", edge));
    arguments.AddString("-ts");
    arguments.AddString(CPLSPrintf("%d", static_cast<int>(l.columns)));
    arguments.AddString(CPLSPrintf("%d", static_cast<int>(l.rows)));
    GDALWarpAppOptions* const options = GDALWarpAppOptionsNew(arguments.List(), nullptr);
    GDALDatasetH from = GDALOpen(path.c_str(), GA_ReadOnly);
    const GdalDataset warped(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &from, options, nullptr)));
    GDALWarpAppOptionsFree(options);
    GDALClose(from);
    std::vector<float> heights(static_cast<std::size_t>(l.columns * l.rows));
    EXPECT_NE(warped, nullptr);
    EXPECT_EQ(
        warped->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, static_cast<int>(l.columns), static_cast<int>(l.rows), heights.data(),
                                           static_cast<int>(l.columns), static_cast<int>(l.rows), GDT_Float32, 0, 0),
        CE_None);
    return heights;
}

TEST_F(PostInterpolatorTest, AgreesWithGdalsWarper) {
    open(swiss_hills());
    const std::vector<float> ours = heights(PostInterpolator::kBlock), theirs = warped_by_gdal(path_, lattice_);
    std::size_t compared = 0, edges = 0;
    for (std::size_t n = 0; n < ours.size(); ++n) {
        if (std::isnan(ours[n]) != (theirs[n] == -32768)) {
            ++edges;
        } else if (!std::isnan(ours[n])) {
            ASSERT_NEAR(ours[n], theirs[n], 2e-3) << n;
            ++compared;
        }
    }
    EXPECT_GT(compared, ours.size() * 8 / 10);
    EXPECT_LE(edges, ours.size() / 1000) << "places that lie on an edge to the last bit";
}

TEST_F(PostInterpolatorTest, GivesEqualBitsFromEveryWindow) {
    open(swiss_hills());
    const std::vector<float> whole = heights(PostInterpolator::kBlock);
    for (const std::int64_t step : {1, 16, 32}) {
        const std::vector<float> parts = heights(step);
        for (std::size_t n = 0; n < whole.size(); ++n)
            ASSERT_TRUE(whole[n] == parts[n] || (std::isnan(whole[n]) && std::isnan(parts[n]))) << step << ": " << n;
    }
}

TEST_F(PostInterpolatorTest, AlignedPostsKeepTheirBits) {
    RasterFile raster;
    raster.transform = {9.6 - 0.5 / 1200, 1.0 / 1200, 0, 47.1 + 0.5 / 1200, 0, -1.0 / 1200};
    raster.value = [](int i, int j) { return 1000.1 + 7.7 * i + 3.3 * j; };
    open(raster);
    ASSERT_TRUE(sources_[0].plain);
    ASSERT_EQ(lattice_.columns, raster.columns);
    const std::vector<float> all = heights(8);
    for (int j = 0; j < raster.rows; ++j)
        for (int i = 0; i < raster.columns; ++i)
            ASSERT_EQ(all[static_cast<std::size_t>(j * raster.columns + i)], static_cast<float>(raster.value(i, j)));
}

TEST_F(PostInterpolatorTest, ReachesEveryBlockThatHasAHeight) {
    open(swiss_hills());
    lattice_.columns += 1000;
    lattice_.west_deg -= 500 * lattice_.step_lon_deg;
    const PostInterpolator interpolator(sources_[0], lattice_);
    int reached = 0, left_out = 0;
    for (std::int64_t j = 0; j < lattice_.rows; j += PostInterpolator::kBlock) {
        for (std::int64_t i = 0; i < lattice_.columns; i += PostInterpolator::kBlock) {
            const bool holds =
                interpolator.locate(i, j, std::min(PostInterpolator::kBlock, lattice_.columns - i), 1).pixels.columns > 0;
            ++(interpolator.reaches(i, j) ? reached : left_out);
            ASSERT_TRUE(interpolator.reaches(i, j) || !holds);
        }
    }
    EXPECT_GT(reached, 0);
    EXPECT_GT(left_out, reached) << "most of the lattice is beyond it";
}

TEST_F(PostInterpolatorTest, KnowsGridsInGradsFromParis) {
    RasterFile raster;  // NTF (Paris): grads, 2.5969213 grads west of which lies Greenwich
    raster.crs = "EPSG:4807";
    raster.transform = {4, 0.001, 0, 50, 0, -0.001};
    raster.value = [](int, int) { return 321; };
    open(raster);
    EXPECT_NEAR(lattice_.west_deg, 4 * 0.9 + 2.33722917, 0.01);
    EXPECT_NEAR(lattice_.north_deg, 45, 0.01);
    std::size_t found = 0;
    for (const float height_m : heights(PostInterpolator::kBlock)) found += height_m == 321 ? 1 : 0;
    EXPECT_GT(found, 200u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_post_interpolator
