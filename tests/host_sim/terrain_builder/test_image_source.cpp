#include "host_sim/terrain_builder/image_source.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/quiet_gdal.hpp"
#include "tests/support/files/image_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_image_source {
namespace {

using test_support::expect_user_error;
using test_support::ImageFile;
using test_support::Rgba;

class ImageSourceTest : public ::testing::Test {
protected:
    DrapeOptions written(const ImageFile& image) { return {image.write(folder_.file("i.tif")), {}, {}}; }
    std::vector<Rgba> pixels(const ImageFile& image) {
        const ImageSource source(written(image));
        std::vector<Rgba> read(static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows));
        source.read(0, 0, image.columns, image.rows, read.front().data());
        return read;
    }
    void expect_colors(const ImageFile& image, const std::function<Rgba(int, int)>& expected) {
        const std::vector<Rgba> read = pixels(image);
        for (int j = 0; j < image.rows; ++j)
            for (int i = 0; i < image.columns; ++i)
                ASSERT_EQ(read[static_cast<std::size_t>(j * image.columns + i)], expected(i, j)) << i << ", " << j;
    }
    void refuses(const ImageFile& image, const std::string& words) {
        expect_user_error([&] { const ImageSource source(written(image)); }, words);
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
};

TEST_F(ImageSourceTest, ColorsAreTheFiles) {
    ImageFile image;
    expect_colors(image, image.color);
    image.bands = 4;
    image.color = [](int i, int j) { return Rgba{10, 20, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j * 5)}; };
    expect_colors(image, image.color);
    image.bands = 1;
    expect_colors(image, [](int, int) { return Rgba{10, 10, 10, 255}; });
    image.meanings = {GCI_GrayIndex, GCI_AlphaBand};
    image.bands = 2;
    expect_colors(image, [](int, int j) { return Rgba{10, 10, 10, static_cast<std::uint8_t>(j * 5)}; });
}

TEST_F(ImageSourceTest, BandsAreFoundByWhatTheySayTheyAre) {
    ImageFile image;
    image.bands = 4;
    image.meanings = {GCI_AlphaBand, GCI_BlueBand, GCI_GreenBand, GCI_RedBand};
    image.color = [](int i, int) { return Rgba{static_cast<std::uint8_t>(i), 33, 22, 11}; };
    expect_colors(image, [](int i, int) { return Rgba{11, 22, 33, static_cast<std::uint8_t>(i)}; });
}

TEST_F(ImageSourceTest, PaletteEntriesBecomeTheirColors) {
    ImageFile image;
    image.bands = 1;
    image.palette = {{1, 2, 3, 255}, {200, 100, 50, 255}, {9, 9, 9, 255}};
    image.color = [](int i, int) { return Rgba{static_cast<std::uint8_t>(i % 3), 0, 0, 0}; };
    expect_colors(image, [&image](int i, int) { return image.palette[static_cast<std::size_t>(i % 3)]; });
}

TEST_F(ImageSourceTest, APixelLacksDataWhereAllItsColorsSaySo) {
    ImageFile image;
    image.no_data = 0;
    image.color = [](int i, int) { return i < 10 ? Rgba{0, 0, 0, 255} : Rgba{0, 0, 80, 255}; };
    expect_colors(image, [](int i, int) { return i < 10 ? Rgba{0, 0, 0, 0} : Rgba{0, 0, 80, 255}; });
}

TEST_F(ImageSourceTest, ReadsTheWindowItIsAskedFor) {
    ImageFile image;
    const ImageSource source(written(image));
    std::vector<Rgba> read(6);
    source.read(7, 11, 3, 2, read.front().data());
    EXPECT_EQ(read[0], image.color(7, 11));
    EXPECT_EQ(read[5], image.color(9, 12));
}

TEST_F(ImageSourceTest, ItsPlaceIsTheFilesOrTheOptions) {
    ImageFile image;
    const ImageSource stated(written(image));
    EXPECT_EQ(stated.transform(), image.transform);
    const std::array<double, 6>& back = stated.to_pixels();
    EXPECT_NEAR(back[0] + back[1] * 9.602 + back[2] * 47.0, 2, 1e-9);
    EXPECT_NEAR(back[3] + back[4] * 9.602 + back[5] * 47.09, 10, 1e-9);
    image.placed = false;
    image.crs.clear();
    DrapeOptions options = written(image);
    std::filesystem::remove(folder_.file("i.tif.aux.xml"));
    options.extent = MapExtent{9, 46, 10, 47};
    const ImageSource placed(options);
    EXPECT_NEAR(placed.transform()[1], 1.0 / image.columns, 1e-15);
    EXPECT_NE(placed.crs().IsGeographic(), 0);
    options.crs = "EPSG:2056";
    EXPECT_NE(ImageSource(options).crs().IsProjected(), 0);
}

TEST_F(ImageSourceTest, WhatIsNoPlacedPictureIsRefusedInOneSentence) {
    ImageFile image;
    image.placed = false;
    refuses(image, "does not say where on Earth it lies; give its outer edges with --drape-extent");
    image = {};
    image.crs.clear();
    refuses(image, "names no coordinate system on Earth; give it with --drape-crs");
    image = {};
    image.type = GDT_UInt16;
    refuses(image, "no 8-bit colours (UInt16); convert it with gdal_translate");
    test_support::RasterFile heights;
    expect_user_error(
        [&] {
            const ImageSource source({heights.write(folder_.file("h.tif")), {}, {}});
        },
        "no 8-bit colours (Float32)");
    expect_user_error(
        [&] {
            const ImageSource source({folder_.write("text.tif", "not an image"), {}, {}});
        },
        "not an image that GDAL can read");
    expect_user_error([&] { const ImageSource source({folder_.file("none.tif"), {}, {}}); }, "no such file");
    DrapeOptions options = written(ImageFile());
    options.extent = MapExtent{9, 46, 10, 47};
    expect_user_error([&] { const ImageSource source(options); }, "--drape-extent: ");
    options.extent.reset();
    options.crs = "nonsense";
    expect_user_error([&] { const ImageSource source(options); }, "--drape-crs nonsense: unknown");
}

TEST_F(ImageSourceTest, ADamagedFileIsSaidWhereItIsRead) {
    ImageFile image;
    image.columns = image.rows = 300;
    const DrapeOptions options = written(image);
    std::filesystem::resize_file(options.file, 100000);
    const ImageSource source(options);
    std::vector<std::uint8_t> read(std::size_t{4} * 300 * 300);
    expect_user_error([&] { source.read(0, 0, 300, 300, read.data()); }, "ends early or is damaged");
}

}  // namespace
}  // namespace tedavis::host_sim::test_image_source
