#include "host_sim/terrain_builder/drape_sampler.hpp"

#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster_source.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/support/files/image_file.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_drape_sampler {
namespace {

using namespace terrain;
using test_support::expect_user_error;
using test_support::ImageFile;
using test_support::Rgba;

constexpr std::uint32_t kSteps = kDrapePosts - 1;

/// The middle of a terrain of 3 arc seconds in the north-west of Switzerland.
constexpr double kWest = 9.6, kNorth = 47.1, kStep = 1.0 / 1200;

BuildPlan plan_of(std::uint32_t columns, std::uint32_t rows, double west_deg = kWest, double step_deg = kStep) {
    const Raster raster = test_support::make_raster(
        columns, rows, [](auto, auto) { return 500.0f; }, west_deg, kNorth, step_deg);
    return make_build_plan(test_support::posts_of(raster)()->grid(), {});
}

class DrapeSamplerTest : public ::testing::Test {
protected:
    DrapeOptions written(const ImageFile& image) { return {image.write(folder_.file("i.tif")), {}, {}}; }

    static std::unique_ptr<DrapePage> page(DrapeSampler& sampler, std::uint32_t i, std::uint32_t j) {
        auto made = std::make_unique<DrapePage>();
        sampler.sample(i, j, *made);
        return made;
    }
    static Rgba texel(const DrapePage& page, std::uint32_t a, std::uint32_t b) {
        const std::uint8_t* p = page.rgba[std::size_t{b} * kDrapePosts + a];
        return {p[0], p[1], p[2], p[3]};
    }
    /// The same page by GDAL's own warper; alpha 0 where the image has nothing.
    std::vector<Rgba> warped(const DrapeOptions& image, const BuildPlan& plan, std::uint32_t level, std::uint32_t i,
                             std::uint32_t j, const char* method) {
        const double texel_deg = std::ldexp(plan.header.step_lon_deg / 4, static_cast<int>(level));
        const double west = plan.header.west_deg + texel_deg * (i * kSteps - 0.5),
                     north = kNorth - texel_deg * (j * kSteps - 0.5);
        const double side = texel_deg * kDrapePosts;
        std::vector<std::string> words = {"-t_srs",
                                          "EPSG:4326",
                                          "-te",
                                          number(west),
                                          number(north - side),
                                          number(west + side),
                                          number(north),
                                          "-ts",
                                          "129",
                                          "129",
                                          "-r",
                                          method,
                                          "-dstalpha",
                                          "-et",
                                          "0",
                                          "-of",
                                          "MEM"};
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        GDALWarpAppOptions* const options = GDALWarpAppOptionsNew(arguments.data(), nullptr);
        GDALDatasetH source = GDALOpen(image.file.c_str(), GA_ReadOnly);
        GDALDatasetH made = GDALWarp("", nullptr, 1, &source, options, nullptr);
        std::vector<Rgba> pixels(std::size_t{kDrapePosts} * kDrapePosts);
        const int bands = GDALGetRasterCount(made);
        for (int band = 1; band <= bands; ++band)
            EXPECT_EQ(
                GDALRasterIO(GDALGetRasterBand(made, band), GF_Read, 0, 0, 129, 129,
                             &pixels[0][band == bands ? 3u : static_cast<std::size_t>(band - 1)], 129, 129, GDT_Byte, 4, 4 * 129),
                CE_None);
        GDALWarpAppOptionsFree(options);
        GDALClose(made);
        GDALClose(source);
        return pixels;
    }
    /// The largest difference between texels that both call covered in full; `compared` counts them.
    static int worst(const DrapePage& page, const std::vector<Rgba>& expected, int& compared) {
        int most = 0;
        compared = 0;
        for (std::uint32_t n = 0; n < expected.size(); ++n) {
            if (page.rgba[n][3] != 255 || expected[n][3] != 255) continue;
            ++compared;
            for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(page.rgba[n][c] - expected[n][c]));
        }
        return most;
    }
    static std::string number(double value) {
        char text[40];
        std::snprintf(text, sizeof text, "%.15g", value);
        return text;
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
};

/// Over all of a terrain of 100 by 80 posts, in its own coordinates.
ImageFile over_all(double pixel_deg) {
    ImageFile image;
    image.transform = {kWest - 5 * kStep, pixel_deg, 0, kNorth + 5 * kStep, 0, -pixel_deg};
    image.columns = static_cast<int>(110 * kStep / pixel_deg);
    image.rows = static_cast<int>(90 * kStep / pixel_deg);
    return image;
}

TEST_F(DrapeSamplerTest, TheLevelIsTheCoarsestThatLosesNothing) {
    const BuildPlan plan = plan_of(400, 300);
    struct Case {
        double pixel_posts;
        std::uint32_t level;
    };
    for (const Case& c :
         {Case{0.1, 0}, Case{0.25, 0}, Case{0.49, 0}, Case{0.5, 1}, Case{1, 2}, Case{1.7, 2}, Case{2.001, 3}, Case{50, 4}}) {
        const DrapeSampler sampler(plan, written(over_all(c.pixel_posts * kStep)));
        EXPECT_EQ(sampler.finest_level(), c.level) << c.pixel_posts;
    }
}

TEST_F(DrapeSamplerTest, TexelsAreWhatTheWarperOfGdalMakesOfTheImage) {
    const BuildPlan plan = plan_of(100, 80);
    for (const double pixel_posts : {0.25, 0.37, 0.49}) {
        ImageFile image = over_all(pixel_posts * kStep);
        image.color = test_support::wavy(9);
        const DrapeOptions options = written(image);
        DrapeSampler sampler(plan, options);
        for (const auto& [i, j] : {std::pair{0u, 0u}, std::pair{1u, 1u}, std::pair{2u, 0u}}) {
            int compared = 0;
            EXPECT_LE(worst(*page(sampler, i, j), warped(options, plan, 0, i, j, "bilinear"), compared), 1) << pixel_posts;
            EXPECT_GT(compared, 9000);
            EXPECT_GT(worst(*page(sampler, i, j), warped(options, plan, 0, i + 1, j, "bilinear"), compared), 50)
                << "control: beside it";
        }
    }
}

TEST_F(DrapeSamplerTest, OtherCoordinateSystemsTheSame) {
    const BuildPlan plan = plan_of(100, 80);
    ImageFile image;
    image.crs = "EPSG:2056";
    image.columns = 420;
    image.rows = 420;
    // Turned a little; the Swiss grid is turned by more than a degree here as it is.
    image.transform = {2762000, 22, 1.5, 1221000, 1.5, -22};
    image.color = test_support::wavy(14);
    const DrapeOptions options = written(image);
    DrapeSampler sampler(plan, options);
    EXPECT_EQ(sampler.finest_level(), 0u);
    int compared = 0;
    for (const auto& [i, j] : {std::pair{0u, 0u}, std::pair{1u, 1u}}) {
        EXPECT_LE(worst(*page(sampler, i, j), warped(options, plan, 0, i, j, "bilinear"), compared), 3);
        EXPECT_GT(compared, 9000);
    }
}

TEST_F(DrapeSamplerTest, OfFinePixelsTexelsHaveTheMean) {
    const BuildPlan plan = plan_of(60, 40);
    // Five pixels a texel: chance that no filter of one or two pixels could tell from its mean.
    ImageFile image = over_all(kStep / 20);
    image.columns = image.rows = 1300;
    image.color = [](int i, int j) {
        const auto grey = static_cast<std::uint8_t>((i + j) % 2 == 0 ? 10 + i / 10 : 200 - i / 10);
        return Rgba{grey, static_cast<std::uint8_t>(i % 5 == 0 ? 250 : 0), static_cast<std::uint8_t>(j / 6), 255};
    };
    DrapeSampler sampler(plan, written(image));
    const auto made = page(sampler, 0, 0);
    for (std::uint32_t b = 3; b < 60; b += 7)
        for (std::uint32_t a = 3; a < 60; a += 5) {
            EXPECT_NEAR(texel(*made, a, b)[0], 105, 3);
            EXPECT_NEAR(texel(*made, a, b)[1], 50, 2);
            EXPECT_NEAR(texel(*made, a, b)[2], (100 + 5 * b) / 6, 2) << "and is where it belongs";
        }
}

TEST_F(DrapeSamplerTest, BeyondTheImageAndWhereItHasNoDataNothingIsCovered) {
    const BuildPlan plan = plan_of(100, 80);
    ImageFile image = over_all(0.5 * kStep);
    image.transform[0] = kWest + 20 * kStep;  // the terrain's west has none
    image.bands = 4;
    image.color = [](int i, int j) {
        return Rgba{200, 100, 60, static_cast<std::uint8_t>(i > 20 && i < 40 && j > 50 && j < 80 ? 0 : 255)};
    };
    DrapeSampler sampler(plan, written(image));
    const auto made = page(sampler, 0, 0);  // level 1: half a post a texel
    ASSERT_EQ(sampler.finest_level(), 1u);
    EXPECT_EQ(texel(*made, 30, 20), (Rgba{0, 0, 0, 0})) << "west of the image";
    EXPECT_EQ(texel(*made, 60, 20), (Rgba{200, 100, 60, 255}));
    EXPECT_EQ(texel(*made, 70, 55), (Rgba{0, 0, 0, 0})) << "a hole";
    int half = 0;
    for (std::uint32_t n = 0; n < kDrapePosts * kDrapePosts; ++n) {
        const std::uint8_t* p = made->rgba[n];
        EXPECT_NEAR(p[0], 200 * p[3] / 255.0, 1) << "colours are multiplied";
        half += p[3] > 0 && p[3] < 255 ? 1 : 0;
    }
    EXPECT_GT(half, 100) << "and fade";
}

TEST_F(DrapeSamplerTest, PagesSideBySideShareTheirTexels) {
    const BuildPlan plan = plan_of(130, 70);
    ImageFile image;
    image.crs = "EPSG:32632";
    image.columns = image.rows = 900;
    image.transform = {545000, 13, 0, 5219000, 0, -13};
    image.color = test_support::wavy(7);
    DrapeSampler sampler(plan, written(image));
    const auto first = page(sampler, 0, 0), east = page(sampler, 1, 0), south = page(sampler, 0, 1);
    int covered = 0;
    for (std::uint32_t n = 0; n < kDrapePosts; ++n) {
        EXPECT_EQ(texel(*first, kSteps, n), texel(*east, 0, n)) << n;
        EXPECT_EQ(texel(*first, n, kSteps), texel(*south, n, 0)) << n;
        covered += texel(*first, n, kSteps)[3] == 255 ? 1 : 0;
    }
    EXPECT_EQ(covered, 129);
}

TEST_F(DrapeSamplerTest, GoesOnOverTheAntimeridian) {
    // An image round the Earth that begins at 180 W, and a terrain across its seam.
    const BuildPlan plan = plan_of(400, 100, 178, 0.01);
    ImageFile image;
    image.columns = 3600;
    image.rows = 200;
    image.transform = {-180, 0.1, 0, 57, 0, -0.1};
    image.color = [](int i, int j) {
        const double turn = (i + 0.5) / 3600 * 2 * 3.14159265358979;
        return Rgba{static_cast<std::uint8_t>(std::lround(127 + 120 * std::sin(200 * turn))), static_cast<std::uint8_t>(j), 90,
                    255};
    };
    DrapeSampler sampler(plan, written(image));
    ASSERT_EQ(sampler.finest_level(), 4u) << "the top";
    const auto made = page(sampler, 0, 0);  // 0.04 degrees a texel
    for (std::uint32_t a = 0; a < 100; ++a) {
        const double longitude = 178 + 0.04 * a, turn = (longitude + 180) / 360 * 2 * 3.14159265358979;
        EXPECT_EQ(texel(*made, a, 10)[3], 255);
        EXPECT_NEAR(texel(*made, a, 10)[0], 127 + 120 * std::sin(200 * turn), 4) << longitude;
    }
    image.columns = 1800;  // control: half the Earth, west of Greenwich
    image.transform[0] = -180;
    DrapeSampler half(plan, written(image));
    const auto cut = page(half, 0, 0);
    EXPECT_EQ(texel(*cut, 20, 10)[3], 0);
    EXPECT_EQ(texel(*cut, 80, 10)[3], 255);
}

TEST_F(DrapeSamplerTest, ASmallImageInALargeTerrainIsFound) {
    const BuildPlan plan = plan_of(1000, 900);
    ImageFile image;
    image.columns = image.rows = 30;
    image.transform = {kWest + 612.3 * kStep, kStep / 8, 0, kNorth - 403.1 * kStep, 0, -kStep / 8};
    const DrapeSampler sampler(plan, written(image));
    EXPECT_EQ(sampler.finest_level(), 0u);
}

TEST_F(DrapeSamplerTest, AnImageOfSomewhereElseIsRefused) {
    const BuildPlan plan = plan_of(100, 80);
    ImageFile image;
    image.transform[0] = 12;
    expect_user_error([&] { const DrapeSampler sampler(plan, written(image)); }, "shows nothing of synthetic");
    image.crs = "EPSG:2056";
    expect_user_error([&] { const DrapeSampler sampler(plan, written(image)); }, "shows nothing of synthetic");
}

}  // namespace
}  // namespace tedavis::host_sim::test_drape_sampler
