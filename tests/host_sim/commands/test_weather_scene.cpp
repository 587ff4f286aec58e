// Each scene file is built, so that what it says is what the builder reads.
#include "host_sim/commands/weather_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/replay/scene_findings.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/scene_builder/scene_build.hpp"
#include "tests/host_sim/scene_builder/netcdf_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_weather_scene {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class WeatherSceneFiles : public ::testing::Test {
protected:
    /// A grid with bands of these descriptions and a unit.
    std::string grid(const std::string& name, const std::vector<std::string>& bands, const std::string& unit) {
        test_support::RasterFile raster;
        raster.bands = static_cast<int>(bands.size());
        raster.unit = unit;
        raster.value = [](int i, int) { return i < 3 ? -50.0 : double(i); };
        std::string path = raster.write(folder_.file(name));
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(path.c_str(), GDAL_OF_UPDATE));
        for (std::size_t n = 0; n < bands.size(); ++n)
            file->GetRasterBand(static_cast<int>(n) + 1)->SetDescription(bands[n].c_str());
        return path;
    }
    /// The scene's layers with their attributes: "wind: east north speed".
    std::vector<std::string> layers(const std::vector<std::string>& files) {
        scene_ = weather_scene(files, window_);
        (void)build_scene(folder_.write("scene.toml", scene_.toml), folder_.file("scene.sdb"), [](auto, auto, auto) {});
        std::vector<std::string> words;
        const OpenScene open(folder_.file("scene.sdb"));
        for (const scene::Layer& layer : open.scene().layers()) {
            words.push_back(std::string(layer.entry->name) + ":");
            for (const scene::Attribute& attribute : layer.attributes) words.back() += std::string(" ") + attribute.entry->name;
        }
        return words;
    }
    test_support::TemporaryFolder folder_;
    WeatherWindow window_;
    WeatherScene scene_;
};

TEST_F(WeatherSceneFiles, WindAndRadarHaveTheNamesThatDesignsShow) {
    const std::string wind = grid("wind.tif", {"u", "v", "pressure"}, "m/s"), radar = grid("echo.tif", {""}, "dBZ");
    EXPECT_THAT(layers({wind, radar}), ElementsAre("wind: east north speed", "radar: reflectivity"));
    EXPECT_TRUE(scene_.notes.empty());
}

TEST_F(WeatherSceneFiles, TwoOfAKindHaveTwoNames) {
    const std::string radar = grid("echo.tif", {""}, "dBZ");
    EXPECT_THAT(layers({radar, radar}), ElementsAre("radar: reflectivity", "radar_2: reflectivity"));
}

TEST_F(WeatherSceneFiles, WhatIsNotDetectedIsNoEchoAndWhatIsMissingStaysMissing) {
    const std::string radar = grid("echo.tif", {""}, "dBZ");
    {
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(radar.c_str(), GDAL_OF_UPDATE));
        file->SetMetadataItem("what_undetect", "-50");
        file->SetMetadataItem("what_nodata", "5");
    }
    (void)layers({radar});
    const OpenScene open(folder_.file("scene.sdb"));
    const scene::Attribute& echo = open.scene().layers()[0].attributes[0];
    EXPECT_EQ(echo.values[0], -32);
    EXPECT_EQ(echo.state(5), scene::ValueState::missing);
    EXPECT_EQ(echo.values[6], 6);
}

TEST_F(WeatherSceneFiles, TheOnlyVariableIsAFieldAndItIsSaidThatNoDesignShowsIt) {
    EXPECT_THAT(layers({grid("Air temperature.tif", {""}, "K")}), ElementsAre("air_temperature: air_temperature"));
    ASSERT_EQ(scene_.notes.size(), 1u);
    EXPECT_THAT(scene_.notes[0], HasSubstr("which no shipped design shows"));
}

TEST_F(WeatherSceneFiles, SeveralUnknownOnesAreRefusedByName) {
    test_support::expect_user_error(
        [&] {
            (void)layers({grid("many.tif", {"t", "q"}, "")});
        },
        "many.tif: holds 2 variables, none of which is known as wind or radar: band 1 (t), band 2 (q); "
        "write a scene file");
}

TEST_F(WeatherSceneFiles, OnlyTheHoursAndTheRegionOfTheFlightAreTaken) {
    test_support::NetcdfFile file;
    for (int hour = 0; hour < 24; ++hour) file.times_h.push_back(438'288 + hour);
    file.write(folder_.file("u.nc"));
    const auto hour = [](int n) { return base::Time{} + base::Duration::seconds((438'288LL + n) * 3600); };
    window_.begin = hour(5);
    window_.end = hour(6);
    window_.region.include(46.4, 9.4);
    window_.region.include(46.6, 9.6);
    (void)layers({folder_.file("u.nc")});
    const OpenScene open(folder_.file("scene.sdb"));
    const scene::GridShape& grid = open.scene().layers()[0].entry->grid;
    EXPECT_EQ(grid.times, 4u) << "with an hour before and after";
    EXPECT_EQ(grid.columns, 3u) << "with a post beyond each side";
    window_.begin = hour(500);
    window_.end = hour(501);
    (void)layers({folder_.file("u.nc")});
    const OpenScene other(folder_.file("scene.sdb"));
    EXPECT_EQ(other.scene().layers()[0].entry->grid.times, 24u) << "of another day: all are kept, and shown as old";
    const auto warnings = [&] {
        return time_findings("weather", times_of_scene(folder_.file("scene.sdb")), *window_.begin, *window_.end);
    };
    ASSERT_EQ(warnings().size(), 1u);
    EXPECT_EQ(warnings()[0].name, "scene.other_time");
    window_.begin = hour(5);
    window_.end = hour(6);
    (void)layers({folder_.file("u.nc")});
    EXPECT_TRUE(warnings().empty()) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_weather_scene
