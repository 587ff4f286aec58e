#include "host_sim/commands/fly.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "host_sim/reports/run_folder.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/flown_across.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_fly {
namespace {

namespace fs = std::filesystem;
using test_support::CommandRun;
using test_support::expect_user_error;
using test_support::FlownAcross;
using test_support::frame_lines;
using test_support::summary_of;
using ::testing::HasSubstr;
using ::testing::Not;

/// The cache of all tests, as Mesa keeps what it compiles in the same place and expects it to stay.
const std::string& cache() {
    static const test_support::TemporaryFolder kFolder;
    return kFolder.path();
}

/// A recording across a small raster, which no other test has built.
class Fly : public ::testing::Test {
protected:
    Fly() {
        setenv("XDG_CACHE_HOME", cache().c_str(), 1);
        options_.flight.flight = place_.write("flight.igc", FlownAcross().igc());
        options_.flight.assume_geometric = true;
        options_.terrain.rasters = {raster()};
        options_.replay.output = output_;
        options_.replay.spread = 12;
        options_.replay.picture.size = PictureSize{160, 120};
    }
    ~Fly() override { unsetenv("XDG_CACHE_HOME"); }

    /// Of the place of the terrain of flown_circle.hpp.
    [[nodiscard]] std::string raster() const {
        test_support::RasterFile file;
        file.columns = file.rows = 193;
        file.transform = {9.6 - 0.5 / 1200, 1.0 / 1200, 0, 47.1 + 0.5 / 1200, 0, -1.0 / 1200};
        file.value = [](int i, int j) { return 1000 + 30 * ((i / 8 + j / 11) % 7); };
        return file.write(place_.file("alps.tif"));
    }
    CommandRun fly() {
        return test_support::run_command([&](Console& console) { return run_fly(options_, console); });
    }

    test_support::TemporaryFolder place_;
    std::string output_ = place_.file("out");
    FlyOptions options_;
};

TEST_F(Fly, GoesFromARecordingToAReport) {
    const CommandRun run = fly();
    EXPECT_EQ(run.code, 0);
    const auto lines = frame_lines(output_);
    ASSERT_GE(lines.size(), 11u);
    EXPECT_THAT(run.results, HasSubstr(output_ + "/report.html: " + std::to_string(lines.size()) + " frames, "));
    EXPECT_EQ(run.results.find('\n'), run.results.size() - 1) << "one sentence";
    for (const char* const name : {"report.html", "summary.json", "flight.log", "flight.log.json"})
        EXPECT_TRUE(fs::exists(output_ + "/" + name)) << name;
    EXPECT_TRUE(fs::exists(frame_picture_path(output_, lines.front().at("frame"))));
    EXPECT_GT(lines.front().at("time_s").get<double>(), FlownAcross().time_at(9.6) - 0.1);
    EXPECT_LT(lines.back().at("time_s").get<double>(), FlownAcross().time_at(9.76) + 0.1);
    for (const auto& line : lines) EXPECT_EQ(line.dump().find("terrain.outside_database"), std::string::npos);
    EXPECT_EQ(summary_of(output_).at("terrain").get<std::string>().find(cache()), 0u);
}

TEST_F(Fly, TheReportShowsTheDisplayAtTheClosestPoints) {
    EXPECT_EQ(fly().code, 0);
    const auto summary = summary_of(output_);
    const auto& closest = summary.at("closest").at("by_distance");
    ASSERT_GE(closest.size(), 1u);
    constexpr double kFrame_s = 1.0 / 20;
    const double late_s = closest[0].at("frame_time_s").get<double>() - closest[0].at("time_s").get<double>();
    EXPECT_GE(late_s, -1e-6);
    EXPECT_LE(late_s, kFrame_s) << "the frame was drawn for it";
    EXPECT_THAT(read_file(output_ + "/report.html"),
                HasSubstr("alt='The display at " + closest[0].at("utc").get<std::string>().substr(11, 10) + " UTC: "));
}

TEST_F(Fly, TheSecondTimeTheTerrainIsThere) {
    EXPECT_THAT(fly().notes, HasSubstr("terrain was built"));
    const auto first = test_support::hashes_by_time(output_);
    options_.replay.output = place_.file("again");
    const CommandRun again = fly();
    EXPECT_THAT(again.notes, HasSubstr("terrain from the cache"));
    EXPECT_THAT(again.notes, Not(HasSubstr("was built")));
    EXPECT_EQ(test_support::hashes_by_time(options_.replay.output), first);
}

TEST_F(Fly, WhatConvertSaysIsInTheReport) {
    const CommandRun run = fly();
    const std::string report = read_file(output_ + "/report.html");
    for (const std::string& said : {std::string("height: "), std::string("heading ")}) {
        EXPECT_THAT(run.notes, HasSubstr("note: " + said));
        EXPECT_THAT(report, HasSubstr("<li>" + said));
    }
}

TEST_F(Fly, AnIgcFileIsTheRecordOfAGliderUnlessSomebodySaysOtherwise) {
    constexpr const char* kSaid = "phases by motion are those of a glider";
    EXPECT_THAT(fly().notes, HasSubstr(kSaid));
    EXPECT_THAT(read_file(output_ + "/report.html"), HasSubstr(kSaid));
    options_.replay.picture.aircraft = "light_piston";
    EXPECT_THAT(fly().notes, Not(HasSubstr(kSaid)));
    options_.replay.picture.aircraft = "";
    options_.replay.aircraft_class = flight::AircraftClass::light;
    EXPECT_THAT(fly().notes, Not(HasSubstr(kSaid)));
}

TEST_F(Fly, ABusLogIsReplayedAsItIs) {
    options_.replay.aircraft_class = flight::AircraftClass::glider;
    (void)fly();
    const auto converted = test_support::hashes_by_time(output_);
    options_.flight.flight = place_.file("given.log");
    fs::rename(output_ + "/flight.log", options_.flight.flight);
    options_.replay.output = place_.file("of_log");
    expect_user_error([&] { fly(); },
                      "a bus log, which is replayed as it is; leave out --aircraft, --qnh and --assume-geometric");
    options_.flight.assume_geometric = false;
    EXPECT_EQ(fly().code, 0);
    EXPECT_EQ(test_support::hashes_by_time(options_.replay.output), converted);
    EXPECT_FALSE(fs::exists(options_.replay.output + "/flight.log"));
}

TEST_F(Fly, ADatabaseIsTakenAsItIs) {
    (void)fly();
    options_.terrain.rasters = {summary_of(output_).at("terrain").get<std::string>()};
    options_.replay.output = place_.file("of_database");
    const CommandRun run = fly();
    EXPECT_THAT(run.notes, Not(HasSubstr("cache")));
    EXPECT_EQ(test_support::hashes_by_time(options_.replay.output), test_support::hashes_by_time(output_));
    options_.terrain.rasters.push_back(raster());
    expect_user_error([&] { fly(); }, "--terrain: one database, or rasters");
}

TEST_F(Fly, WithoutTerrainItIsSaidInTheReport) {
    options_.terrain.rasters.clear();
    const CommandRun run = fly();
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.notes, HasSubstr("no terrain was given (--terrain)"));
    EXPECT_THAT(read_file(output_ + "/report.html"), HasSubstr("no terrain was given (--terrain)"));
    EXPECT_LT(frame_lines(output_).front().at("time_s").get<double>(), 0.1) << "from the flight's begin";
}

/// Echoes around the terrain.
std::string radar_file(const test_support::TemporaryFolder& place) {
    test_support::RasterFile radar;
    radar.columns = radar.rows = 100;
    radar.transform = {9.2, 0.01, 0, 47.5, 0, -0.01};
    radar.unit = "dBZ";
    radar.value = [](int i, int j) { return double((i + j) % 60); };
    return radar.write(place.file("radar.tif"));
}

TEST_F(Fly, WeatherBecomesASceneOfTheRun) {
    options_.weather = {radar_file(place_)};
    options_.replay.picture.design = "priority";
    const CommandRun run = fly();
    EXPECT_EQ(run.code, 0);
    EXPECT_TRUE(fs::exists(output_ + "/scene.toml"));
    EXPECT_EQ(summary_of(output_).at("scene"), output_ + "/scene.sdb");
    const auto with_weather = test_support::hashes_by_time(output_);
    options_.weather.clear();
    options_.scene = output_ + "/scene.toml";
    options_.replay.output = place_.file("of_file");
    EXPECT_EQ(fly().code, 0);
    EXPECT_EQ(test_support::hashes_by_time(options_.replay.output), with_weather)
        << "the scene file that was written says it all";
    options_.scene = output_ + "/scene.sdb";
    options_.replay.output = place_.file("of_database");
    EXPECT_EQ(fly().code, 0);
    EXPECT_EQ(test_support::hashes_by_time(options_.replay.output), with_weather);
    options_.scene.clear();
    options_.replay.output = place_.file("without");
    EXPECT_EQ(fly().code, 0);
    EXPECT_NE(test_support::hashes_by_time(options_.replay.output), with_weather) << "control";
}

TEST_F(Fly, UnknownWeatherLeavesNothing) {
    test_support::RasterFile many;
    many.bands = 2;
    options_.weather = {many.write(place_.file("many.tif"))};
    expect_user_error([&] { fly(); }, "write a scene file that says what of it is shown");
    EXPECT_FALSE(fs::exists(output_));
    options_.scene = "jacksboro";
    expect_user_error([&] { fly(); }, "--weather and --scene");
}

TEST_F(Fly, NeverOverTheTerrainLeavesNothing) {
    options_.flight.flight = place_.write("south.igc", FlownAcross{46.04}.igc());
    expect_user_error([&] { fly(); },
                      "the flight is never over it: it covers 46.940 .. 47.100 N, 9.600 .. 9.760 E, the flight 46.04");
    EXPECT_FALSE(fs::exists(output_));
}

TEST_F(Fly, NeverOverTheTerrainIsFoundBeforeTheFlightIsConverted) {
    // What conversion would refuse as well: with both faults, the first one that is met is said.
    options_.flight.qnh_hpa = 1;
    options_.flight.flight = place_.write("south.igc", FlownAcross{46.04}.igc());
    expect_user_error([&] { fly(); }, "the flight is never over it");
    options_.flight.flight = place_.write("flight.igc", FlownAcross().igc());
    expect_user_error([&] { fly(); }, "--qnh");
}

TEST_F(Fly, TooManyFramesNeedAYesAndLeaveNothing) {
    FlownAcross slow;
    slow.seconds = 1280;
    slow.step_deg = 0.0002;
    options_.flight.flight = place_.write("slow.igc", slow.igc());
    options_.replay.spread = kMaxSpread;
    expect_user_error([&] { fly(); }, "frames, about ");
    EXPECT_FALSE(fs::exists(output_));
}

TEST_F(Fly, AnEarlierRunOutlastsAFaultyFlight) {
    (void)fly();
    const std::string report = read_file(output_ + "/report.html");
    options_.flight.flight = place_.write("words.igc", "no flight");
    expect_user_error([&] { fly(); }, "words.igc");
    EXPECT_EQ(read_file(output_ + "/report.html"), report);
    EXPECT_TRUE(fs::exists(output_ + "/flight.log"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_fly
