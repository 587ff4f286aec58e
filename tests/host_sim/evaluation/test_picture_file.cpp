#include "host_sim/evaluation/picture_file.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_picture_file {
namespace {

constexpr int kColumns = 16, kRows = 8;
using Level = std::function<int(int band, int x, int y)>;

struct CloseFile {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// As other software writes it: bands in memory, copied by the format's driver.
std::string write(const std::string& path, const char* format, int bands, GDALDataType type, const Level& level,
                  const GDALColorTable* palette = nullptr) {
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, CloseFile> memory(
        GetGDALDriverManager()->GetDriverByName("MEM")->Create("", kColumns, kRows, bands, type, nullptr));
    for (int band = 1; band <= bands; ++band) {
        std::vector<int> values;
        for (int y = 0; y < kRows; ++y)
            for (int x = 0; x < kColumns; ++x) values.push_back(level(band, x, y));
        EXPECT_EQ(memory->GetRasterBand(band)->RasterIO(GF_Write, 0, 0, kColumns, kRows, values.data(), kColumns, kRows,
                                                        GDT_Int32, 0, 0, nullptr),
                  CE_None);
    }
    if (palette != nullptr) memory->GetRasterBand(1)->SetColorTable(const_cast<GDALColorTable*>(palette));
    const std::unique_ptr<GDALDataset, CloseFile> file(
        GetGDALDriverManager()->GetDriverByName(format)->CreateCopy(path.c_str(), memory.get(), 0, nullptr, nullptr, nullptr));
    EXPECT_NE(file, nullptr) << path;
    return path;
}

using Rgb = std::array<int, 3>;
using Color = std::function<Rgb(int x, int y)>;

/// The largest difference of any channel; alpha must be whole.
int worst(const RgbaPicture& picture, const Color& color) {
    EXPECT_EQ(picture.width, static_cast<std::uint32_t>(kColumns));
    EXPECT_EQ(picture.height, static_cast<std::uint32_t>(kRows));
    int largest = 0;
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            const std::uint8_t* pixel =
                &picture.pixels[(static_cast<std::size_t>(y) * kColumns + static_cast<std::size_t>(x)) * 4];
            EXPECT_EQ(pixel[3], 255);
            for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(pixel[c] - color(x, y)[c]));
        }
    }
    return largest;
}

int ramp(int band, int x, int y) { return (60 * band + 9 * x + 2 * y) % 256; }
Rgb ramp_color(int x, int y) { return {ramp(1, x, y), ramp(2, x, y), ramp(3, x, y)}; }

class PictureFile : public ::testing::Test {
protected:
    test_support::TemporaryFolder place_;
};

TEST_F(PictureFile, ReadsEveryKindOfPng) {
    EXPECT_EQ(worst(read_picture(write(place_.file("rgb.png"), "PNG", 3, GDT_Byte, ramp)), ramp_color), 0);
    const auto grey = [](int x, int y) { return Rgb{ramp(1, x, y), ramp(1, x, y), ramp(1, x, y)}; };
    EXPECT_EQ(worst(read_picture(write(place_.file("grey.png"), "PNG", 1, GDT_Byte, ramp)), grey), 0);
    const auto wide = [](int band, int x, int y) {
        return 257 * ramp(band, x, y) + (x % 3 - 1) * (ramp(band, x, y) % 255 == 0 ? 0 : 100);
    };
    EXPECT_EQ(worst(read_picture(write(place_.file("wide.png"), "PNG", 3, GDT_UInt16, wide)), ramp_color), 0)
        << "the nearest of 8 bits";
    EXPECT_EQ(worst(read_picture(write(place_.file("wide_grey.png"), "PNG", 1, GDT_UInt16, wide)), grey), 0);
}

TEST_F(PictureFile, PalettesAreLookedUp) {
    GDALColorTable table;
    const GDALColorEntry entries[] = {{200, 10, 20, 255}, {0, 0, 0, 255}, {5, 100, 250, 255}};
    for (int n = 0; n < 3; ++n) table.SetColorEntry(n, &entries[n]);
    const auto index = [](int, int x, int) { return x % 3; };
    const auto color = [&](int x, int) { return Rgb{entries[x % 3].c1, entries[x % 3].c2, entries[x % 3].c3}; };
    for (const char* format : {"PNG", "GTiff", "GIF"})
        EXPECT_EQ(worst(read_picture(write(place_.file(format), format, 1, GDT_Byte, index, &table)), color), 0) << format;
}

TEST_F(PictureFile, WhatIsTransparentLiesOnBlack) {
    const auto level = [](int band, int x, int y) { return band == 4 ? 17 * x : ramp(band, x, y); };
    const auto color = [](int x, int y) {
        const auto on_black = [&](int band) { return (ramp(band, x, y) * 17 * x + 127) / 255; };
        return Rgb{on_black(1), on_black(2), on_black(3)};
    };
    for (const char* format : {"PNG", "GTiff"})
        EXPECT_EQ(worst(read_picture(write(place_.file(format), format, 4, GDT_Byte, level)), color), 0) << format;
    const auto grey_level = [](int band, int x, int y) { return band == 2 ? 17 * x : ramp(1, x, y); };
    const auto grey = [&](int x, int y) { return Rgb{color(x, y)[0], color(x, y)[0], color(x, y)[0]}; };
    EXPECT_EQ(worst(read_picture(write(place_.file("grey.png"), "PNG", 2, GDT_Byte, grey_level)), grey), 0);
}

TEST_F(PictureFile, JpegIsNearWhatWasWritten) {
    const auto smooth = [](int band, int x, int y) { return 40 * band + 5 * x + 4 * y; };
    const auto color = [&](int x, int y) { return Rgb{smooth(1, x, y), smooth(2, x, y), smooth(3, x, y)}; };
    EXPECT_LE(worst(read_picture(write(place_.file("a.jpg"), "JPEG", 3, GDT_Byte, smooth)), color), 12);
    const auto grey = [&](int x, int y) { return Rgb{smooth(1, x, y), smooth(1, x, y), smooth(1, x, y)}; };
    EXPECT_LE(worst(read_picture(write(place_.file("g.jpg"), "JPEG", 1, GDT_Byte, smooth)), grey), 12);
    for (const auto& entry : std::filesystem::directory_iterator(place_.path()))
        EXPECT_EQ(entry.path().extension(), ".jpg") << "reading leaves nothing beside the picture";
}

TEST_F(PictureFile, SaysWhatIsNoPicture) {
    test_support::expect_user_error([&] { (void)read_picture(place_.file("none.png")); }, "no such file");
    test_support::expect_user_error([&] { (void)read_picture(place_.write("empty.png", "")); }, "empty.png: empty");
    test_support::expect_user_error([&] { (void)read_picture(place_.write("text.jpg", "a letter")); }, "not a picture");
    test_support::expect_user_error([&] { (void)read_picture(place_.path()); }, "is a folder");
    (void)write(place_.file("whole.png"), "PNG", 3, GDT_Byte, ramp);
    (void)write(place_.file("whole.jpg"), "JPEG", 3, GDT_Byte, ramp);
    for (const char* name : {"whole.png", "whole.jpg"}) {
        const std::string bytes = place_.read(name);
        const std::string cut = place_.write(std::string("cut_") + name, bytes.substr(0, bytes.size() * 7 / 10));
        test_support::expect_user_error([&] { (void)read_picture(cut); }, std::string("cut_") + name);
    }
    const std::string heights = write(place_.file("heights.tif"), "GTiff", 1, GDT_Float32, ramp);
    test_support::expect_user_error([&] { (void)read_picture(heights); }, "no colours of 8 or 16 bits");
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_file
