#include "host_sim/terrain_builder/file_sources.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_file_sources {
namespace {

class FileSources : public ::testing::Test {
protected:
    std::string file(const std::string& name, double west, double north, double step, int columns, int rows, int bands = 1) {
        test_support::RasterFile raster;
        raster.columns = columns;
        raster.rows = rows;
        raster.bands = bands;
        raster.transform = {west, step, 0, north, 0, -step};
        return raster.write(folder_.file(name));
    }
    TerrainSources sources(const std::vector<std::string>& files, const RasterOptions& options = {}) {
        notes_.clear();
        return sources_of_files(files, options, notes_);
    }

    test_support::TemporaryFolder folder_;
    std::vector<std::string> notes_;
};

TEST_F(FileSources, AFinerFileWithinTheOthersIsAnInset) {
    const std::string west = file("w.tif", 9, 47, 0.01, 60, 60), east = file("e.tif", 9.6, 47, 0.01, 60, 60),
                      fine = file("fine.tif", 9.5, 46.8, 0.002, 80, 50, 2);
    const TerrainSources made = sources({west, fine, east});
    ASSERT_EQ(made.insets.size(), 1u);
    EXPECT_EQ(made.open()->grid().source, "w.tif, e.tif");
    EXPECT_NEAR(made.open()->grid().step_lat_deg, 0.01, 1e-12);
    EXPECT_EQ(made.insets[0]()->grid().columns, 80u);
    ASSERT_EQ(notes_.size(), 1u);
    EXPECT_NE(notes_[0].find("fine.tif"), std::string::npos) << notes_[0];
}

TEST_F(FileSources, FilesThatReachBeyondTheOthersAreOneRaster) {
    const std::string coarse = file("c.tif", 9, 47, 0.01, 60, 60), beside = file("b.tif", 9.5, 46.8, 0.005, 80, 50);
    EXPECT_TRUE(sources({coarse, beside}).insets.empty());
    const std::string alike = file("a.tif", 9.1, 46.9, 0.008, 20, 20);
    EXPECT_TRUE(sources({coarse, alike}).insets.empty()) << "not much finer";
    EXPECT_TRUE(sources({coarse}).insets.empty());
}

TEST_F(FileSources, BoundsAreTheGroundsOnly) {
    const std::string coarse = file("c.tif", 9, 47, 0.01, 60, 60), fine = file("f.tif", 9.1, 46.9, 0.002, 80, 50);
    RasterOptions options;
    options.bounds = GeoBounds{9.0, 46.6, 9.5, 46.85};
    const TerrainSources made = sources({coarse, fine}, options);
    ASSERT_EQ(made.insets.size(), 1u);
    EXPECT_EQ(made.insets[0]()->grid().rows, 50u);
    EXPECT_LT(made.open()->grid().rows, 30u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_file_sources
