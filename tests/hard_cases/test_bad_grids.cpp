// Rasters that are wrong or unusual, from the file through scene file and database to the pixels that a display draws of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/hard_cases/scene_files.hpp"

namespace tedavis::tests::test_bad_grids {
namespace {

using design::Color;
using test_support::color_difference;
using test_support::DataPicture;
using test_support::DataSite;
using test_support::expect_refusal;
using test_support::kBareGround;
using test_support::plain_ground_design;
using test_support::RasterFile;
using test_support::SceneFiles;
using test_support::site_raster;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

std::string field_layer(const std::string& more = "") {
    return "[[layer]]\nname = 'field'\ntitle = 'Field'\nsource = 'grid.tif'\n" + more +
           "[[layer.attribute]]\nname = 'value'\nvariable = 'band 1'\n[layer.attribute.uncertainty]\n"
           "kind = 'standard_deviation'\nvalue = 0\n";
}
std::string ground_design(const std::string& more = "") {
    return plain_ground_design("[data.ground]\nlayer = 'field'\nattribute = 'value'\npalette = 'scale.toml'\nopacity = 1\n" +
                               more);
}
Color scale_color(double value) {
    return design::color_of_value(test_support::greens(), value);  // the palette alone: the value is this test's
}

/// The raster's value at a place by the four pixels round it, as whoever wrote the file means them.
struct Expected {
    enum Kind { beside, missing, valued, undecided } kind = beside;
    double value = 0;
};
Expected expected_at(const RasterFile& raster, const earth::Geodetic& place) {
    constexpr double kEdge = 0.02;  // of a cell: the middle of a pixel is known to a tenth of this
    const double u = (base::degrees(place.longitude_rad) - raster.x(0, 0)) / raster.transform[1],
                 v = (base::degrees(place.latitude_rad) - raster.y(0, 0)) / raster.transform[5];
    const double inside = std::fmin(std::fmin(u, raster.columns - 1 - u), std::fmin(v, raster.rows - 1 - v));
    if (std::fabs(inside) < kEdge) return {Expected::undecided};
    if (inside < 0) return {};
    const double i = std::floor(u), j = std::floor(v), x = u - i, y = v - j;
    Expected expected{Expected::valued};
    bool has_edge = std::fmin(std::fmin(x, 1 - x), std::fmin(y, 1 - y)) < kEdge;
    for (const auto& [a, b, weight] :
         {std::tuple{0, 0, (1 - x) * (1 - y)}, {1, 0, x * (1 - y)}, {0, 1, (1 - x) * y}, {1, 1, x * y}}) {
        const double value = raster.value(static_cast<int>(i) + a, static_cast<int>(j) + b);
        if (!std::isfinite(value) || (raster.no_data && value == *raster.no_data)) expected.kind = Expected::missing;
        expected.value += weight * value;
    }
    return has_edge && expected.kind == Expected::missing ? Expected{Expected::undecided} : expected;
}

class BadGridsOf : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Lanes, BadGridsOf, ::testing::Values("es2-small", "es3-mid"));

/// Pixels of each kind that are as the file says; every other one is a failure.
struct Tally {
    int beside = 0, valued = 0, missing_bare = 0, missing_dots = 0, wrong = 0;
};
Tally compared(const DataPicture& drawn, const RasterFile& raster) {
    const Color missing = design::default_design_settings().data.missing;
    Tally tally;
    for (std::uint32_t y = 1; y + 1 < drawn.picture.height; ++y)
        for (std::uint32_t x = 1; x + 1 < drawn.picture.width; ++x) {
            const Expected expected = expected_at(raster, DataSite::places_from_above()[y * drawn.picture.width + x]);
            const Color color = drawn.at(x, y);
            const bool is_bare = color == kBareGround;
            switch (expected.kind) {
                case Expected::undecided: break;
                case Expected::beside: ++(is_bare ? tally.beside : tally.wrong); break;
                case Expected::missing:
                    ++(is_bare ? tally.missing_bare : color == missing ? tally.missing_dots : tally.wrong);
                    break;
                case Expected::valued:
                    ++(color_difference(color, scale_color(expected.value)) <= 1 ? tally.valued : tally.wrong);
                    break;
            }
        }
    return tally;
}

TEST_P(BadGridsOf, WhatIsNoNumberIsMarkedMissingAndTaintsNoNeighbour) {
    SceneFiles files(GetParam());
    RasterFile sound = site_raster(), holed = sound;
    holed.no_data = -9999;
    holed.value = [&](int i, int j) {
        if (i == 3 && j == 3) return kNan;
        if (i == 5 && j == 4) return kInfinity;
        if (i == 2 && j == 5) return -kInfinity;
        return i == 6 && j == 2 ? -9999 : site_raster().value(i, j);
    };
    files.write(holed);
    const DataPicture drawn = files.drawn(field_layer(), ground_design());
    const Tally tally = compared(drawn, holed);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.beside, 10'000);
    EXPECT_GT(tally.valued, 15'000);
    EXPECT_GT(tally.missing_bare, 5'000);
    EXPECT_GT(tally.missing_dots, 300);
    // Control: over the file without holes the same expectation fails, and its own holds.
    files.write(sound);
    const DataPicture whole = files.drawn(field_layer(), ground_design());
    EXPECT_GT(compared(whole, holed).wrong, 5'000);
    const Tally all = compared(whole, sound);
    EXPECT_EQ(all.wrong + all.missing_bare + all.missing_dots, 0);
}

TEST_P(BadGridsOf, OneValueEverywhereHasItsColor) {
    SceneFiles files(GetParam());
    for (const double value : {42.0, 0.0, 100.0, 1e-30}) {
        RasterFile raster = site_raster();
        raster.value = [value](int, int) { return value; };
        files.write(raster);
        const DataPicture drawn = files.drawn(field_layer(), ground_design());
        const Tally tally = compared(drawn, raster);
        EXPECT_EQ(tally.wrong, 0) << value;
        EXPECT_GT(tally.valued, 20'000) << value;
        // In classes, on a limit of which it belongs to the class above.
        const Color above = design::color_of_value(test_support::greens(), 70);
        const DataPicture classed = files.draw(ground_design("breaks = [-5, 40]\n"));
        EXPECT_EQ(classed.count(above) > 20'000, value > 40) << value;
        EXPECT_EQ(files.draw(ground_design("breaks = [-5, " + std::to_string(value) + "]\n")).count(kBareGround) +
                      files.draw(ground_design("shown_from = " + std::to_string(value) + "\n")).count(kBareGround),
                  2 * drawn.count(kBareGround))
            << "nothing is without a colour";
    }
}

/// The legend is of the scale, so that it is the same whatever the data are.
TEST_P(BadGridsOf, TheLegendOfOneValueIsThatOfMany) {
    SceneFiles files(GetParam());
    const auto drawn = [&](double step) {
        RasterFile raster = site_raster();
        raster.value = [step](int i, int) { return 42 + step * i; };
        files.write(raster);
        EXPECT_EQ(files.build(field_layer()).code, 0);
        return files.draw_with_legend(ground_design());
    };
    const DataPicture one = drawn(0), many = drawn(5), plain = files.draw_with_legend(plain_ground_design(""));
    // The legend stands in the upper half, over the sky: all that differs there from a picture without data is its own.
    std::size_t in_legend = 0, others = 0;
    for (std::uint32_t y = 0; y < one.picture.height / 3; ++y)
        for (std::uint32_t x = 0; x < one.picture.width; ++x) {
            in_legend += one.at(x, y) == plain.at(x, y) ? 0 : 1;
            others += one.at(x, y) == many.at(x, y) ? 0 : 1;
        }
    EXPECT_GT(in_legend, 2'000u);
    EXPECT_EQ(others, 0u);
    EXPECT_GT(one.differing(many), 2'000u) << "the ground does differ";
}

TEST_P(BadGridsOf, ReversedAxesDrawTheSamePicture) {
    SceneFiles files(GetParam());
    const auto drawn = [&](bool to_west, bool to_north, bool is_told) {
        RasterFile raster = site_raster();
        if (to_west && is_told) raster.transform[0] += 8 * raster.transform[1], raster.transform[1] *= -1;
        if (to_north && is_told) raster.transform[3] += 8 * raster.transform[5], raster.transform[5] *= -1;
        raster.value = [=](int i, int j) { return site_raster().value(to_west ? 7 - i : i, to_north ? 7 - j : j); };
        files.write(raster);
        return files.drawn(field_layer(), ground_design());
    };
    const DataPicture usual = drawn(false, false, true);
    EXPECT_GT(usual.count(kBareGround), 10'000u);
    for (const auto& [to_west, to_north] : {std::pair{true, false}, {false, true}, {true, true}}) {
        EXPECT_EQ(drawn(to_west, to_north, true), usual);
        EXPECT_GT(drawn(to_west, to_north, false).differing(usual), 10'000u) << "control: the same bytes, not told";
    }
}

TEST_P(BadGridsOf, LongitudesOverTheWholeTurnDrawTheSamePicture) {
    SceneFiles files(GetParam());
    const auto drawn = [&](double shift_deg) {
        RasterFile raster = site_raster();
        raster.transform[0] += shift_deg;
        files.write(raster);
        return files.drawn(field_layer(), ground_design());
    };
    const DataPicture usual = drawn(0);
    EXPECT_EQ(drawn(360), usual);
    EXPECT_GT(drawn(1.0 / 128).differing(usual), 10'000u) << "control";
    EXPECT_GT(drawn(180).differing(usual), 10'000u) << "control";
}

/// The whole Earth from Greenwich eastwards, as weather services give it: our place is in its second half.
TEST(BadGrids, TheWholeEarthFromGreenwichOn) {
    SceneFiles files("es3-mid");  // which has room for so many posts
    RasterFile raster = site_raster();
    raster.columns = 720;
    raster.rows = 8;
    raster.transform = {-0.25, 0.5, 0, 38.25, 0, -0.5};
    raster.value = [](int i, int j) { return 50 + 30 * std::sin(0.9 * i + j); };
    files.write(raster);
    const DataPicture east = files.drawn(field_layer(), ground_design());
    raster.transform[0] = -180.25;
    raster.value = [](int i, int j) { return 50 + 30 * std::sin(0.9 * ((i + 360) % 720) + j); };
    files.write(raster);
    EXPECT_LE(files.drawn(field_layer(), ground_design()).most_difference(east), 1) << "places among 720 posts are rounded";
    EXPECT_EQ(east.count(kBareGround), 0u);
    RasterFile shifted = raster;
    shifted.transform[0] += 0.5;
    files.write(shifted);
    EXPECT_GT(files.drawn(field_layer(), ground_design()).most_difference(east), 10) << "control";
}

TEST(BadGrids, WithoutASystemTheyAreRefusedUntilItIsNamed) {
    SceneFiles files;
    RasterFile raster = site_raster();
    raster.crs = "EPSG:32616";  // UTM, metres
    raster.columns = raster.rows = 30;
    raster.transform = {746'000, 200, 0, 4'069'000, 0, -200};
    raster.value = [](int i, int j) { return 20.0 + i + j; };
    files.write(raster);
    const DataPicture stated = files.drawn(field_layer(), ground_design());
    EXPECT_LT(stated.count(kBareGround), 60'000u);
    raster.crs = "";
    files.write(raster);
    expect_refusal(files.build(field_layer()), "grid.tif: does not say in which reference system it lies; name it with crs");
    EXPECT_FALSE(files.has_database());
    EXPECT_EQ(files.drawn(field_layer("crs = 'EPSG:32616'\n"), ground_design()), stated);
    EXPECT_NE(files.drawn(field_layer("crs = 'EPSG:32617'\n"), ground_design()), stated) << "control";
    // Metres near their origin could be degrees by their first corner, but not by their size.
    raster.columns = 500;
    raster.transform = {0, 1, 0, 20, 0, -1};
    files.write(raster);
    expect_refusal(files.build(field_layer()), "grid.tif: does not say in which reference system it lies; name it with crs");
    EXPECT_FALSE(files.has_database());
    expect_refusal(files.build(field_layer("crs = 'no such'\n")), "check 'crs'");
    EXPECT_FALSE(files.has_database());
}

TEST(BadGrids, DegreesWithoutASystemAreLongitudeAndLatitude) {
    SceneFiles files;
    RasterFile raster = site_raster();
    files.write(raster);
    const DataPicture usual = files.drawn(field_layer(), ground_design());
    EXPECT_EQ(files.notes(), "");
    raster.crs = "";
    files.write(raster);
    EXPECT_EQ(files.drawn(field_layer(), ground_design()), usual);
    EXPECT_THAT(files.notes(),
                HasSubstr("note: field: grid.tif states no reference system and is taken for longitude and latitude"));
}

/// A refused build leaves what was there before as it was.
TEST(BadGrids, ADatabaseThatIsThereStays) {
    SceneFiles files;
    files.write(site_raster());
    EXPECT_EQ(files.build(field_layer()).code, 0);
    const std::string before = files.folder().read("s.sdb");
    RasterFile raster = site_raster();
    raster.crs = "";
    raster.transform = {746'000, 200, 0, 4'069'000, 0, -200};
    files.write(raster);
    const std::size_t entries = files.folder().entries();
    expect_refusal(test_support::run_words({"scene", "build", files.folder().file("s.toml"), "-o", files.database()}),
                   "grid.tif");
    EXPECT_EQ(files.folder().read("s.sdb"), before);
    EXPECT_EQ(files.folder().entries(), entries) << "nothing half written";
}

}  // namespace
}  // namespace tedavis::tests::test_bad_grids
