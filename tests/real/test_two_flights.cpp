// Two flights that somebody flew over Davos, three days apart: beside each other on a page, and one as the ghost of the other.
// The oracles are the recorded fixes, the raster as GDAL reads it and the records of the runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "host_sim/commands/compare.hpp"
#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/replay/ghost_flights.hpp"
#include "tests/real/raster_heights.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_two_flights {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char *kOwn = "4b1c22", *kOther = "4b088c";

std::string recording() { return test_support::real_data_dir() + "/flights/adsb_switzerland_map.json.gz"; }
std::string raster() { return test_support::real_data_dir() + "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif"; }

template <class Command>
void run(Command command) {
    const auto done = test_support::run_command(command, true);
    EXPECT_EQ(done.code, 0) << done.results << done.notes;
}

/// On a sphere, by the haversine.
double metres_between(double lat_a, double lon_a, double lat_b, double lon_b) {
    constexpr double kRad = 3.14159265358979323846 / 180, kEarth_m = 6'371'008.8;
    const double north = std::sin((lat_b - lat_a) * kRad / 2), east = std::sin((lon_b - lon_a) * kRad / 2);
    return 2 * kEarth_m * std::asin(std::sqrt(north * north + std::cos(lat_a * kRad) * std::cos(lat_b * kRad) * east * east));
}

struct Fix {
    double utc_s, lat_deg, lon_deg;
};

std::vector<Fix> fixes_of(const std::string& aircraft) {
    std::vector<Fix> fixes;
    for (const json& row : json::parse(host_sim::read_file_unpacked(recording())))
        if (row["icao24"] == aircraft)
            fixes.push_back({row["timestamp"].get<double>() / 1000, row["latitude"], row["longitude"]});
    return fixes;
}

/// Where the ground speed between two fixes first is above 20 m/s.
double takeoff_utc_s(const std::vector<Fix>& fixes) {
    for (std::size_t n = 1; n < fixes.size(); ++n) {
        const Fix &a = fixes[n - 1], &b = fixes[n];
        if (metres_between(a.lat_deg, a.lon_deg, b.lat_deg, b.lon_deg) > 20 * (b.utc_s - a.utc_s)) return a.utc_s;
    }
    return 0;
}

/// The terrain and both logs; the own flight takes pressure altitudes for heights, the other one does not.
struct DavosFlights {
    DavosFlights() {
        host_sim::TerrainBuildOptions build;
        build.rasters = {raster()};
        build.output = folder.file("t.tdb");
        run([&](host_sim::Console& console) { return run_terrain_build(build, console); });
        for (const char* const aircraft : {kOwn, kOther}) {
            host_sim::ConvertOptions convert;
            convert.flight = recording();
            convert.aircraft = aircraft;
            convert.assume_geometric = aircraft == std::string(kOwn);
            convert.output = log_of(aircraft);
            run([&](host_sim::Console& console) { return run_convert(convert, console); });
        }
    }
    [[nodiscard]] std::string log_of(const std::string& aircraft) const { return folder.file(aircraft + ".log"); }
    [[nodiscard]] host_sim::ReplayOptions replay_of(const std::string& aircraft, double from_s, double to_s) const {
        host_sim::ReplayOptions replay;
        replay.log = log_of(aircraft);
        replay.output = folder.file("run_" + aircraft);
        replay.picture.terrain = folder.file("t.tdb");
        replay.picture.device = "es2-small";
        replay.from_s = from_s;
        replay.to_s = to_s;
        replay.step_s = 5;
        replay.frames = host_sim::FrameOutput::none;
        return replay;
    }
    test_support::TemporaryFolder folder;
};

const DavosFlights& flights() {
    static const DavosFlights kFlights;
    return kFlights;
}

bool is_over_the_raster(const json& frame) {
    const json& own = frame["own_ship"];
    return own["state"] == "valid" && own["lat_deg"] > 46.5 && own["lat_deg"] < 47.1 && own["lon_deg"] > 9.6 &&
           own["lon_deg"] < 10.2;
}

/// Each run begins before the raster and ends behind it.
class TwoRuns : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        for (const auto& [aircraft, from_s, to_s] : {std::tuple{kOwn, 10500.0, 11100.0}, {kOther, 9900.0, 10500.0}}) {
            const host_sim::ReplayOptions replay = flights().replay_of(aircraft, from_s, to_s);
            run([&](host_sim::Console& console) { return run_replay(replay, console); });
        }
        host_sim::CompareOptions compare;
        compare.run_a = flights().folder.file(std::string("run_") + kOwn);
        compare.run_b = flights().folder.file(std::string("run_") + kOther);
        compare.output = flights().folder.file("compared/page.html");
        compare.align.by = host_sim::Alignment::place;
        run([&](host_sim::Console& console) { return run_compare(compare, console); });
        compared() = json::parse(host_sim::read_file(flights().folder.file("compared/compare.json")));
    }
    static json& compared() {
        static json read;
        return read;
    }
    static std::vector<json> frames_of(const char* aircraft) {
        return test_support::frame_lines(flights().folder.file(std::string("run_") + aircraft));
    }
};

TEST_F(TwoRuns, ThePageSaysWhatTheHeightsRestOnAndWhereTheGroundIsKnown) {
    const json& heights = compared()["heights"];
    for (const auto& [key, aircraft] : {std::pair{"a", kOwn}, {"b", kOther}}) {
        const std::vector<json> frames = frames_of(aircraft);
        const auto over = static_cast<double>(std::count_if(frames.begin(), frames.end(), is_over_the_raster));
        EXPECT_EQ(heights[key]["frames"], frames.size());
        EXPECT_GT(over, 20) << "control: it was over the raster";
        EXPECT_LT(over, static_cast<double>(frames.size()) - 20) << "control: it was elsewhere, too";
        EXPECT_NEAR(heights[key]["ground_known_frames"].get<double>(), over, 2) << aircraft;
    }
    EXPECT_EQ(heights["a"]["are_assumed"], true);
    EXPECT_EQ(heights["b"]["are_assumed"], false);
    EXPECT_EQ(heights["a"]["pressure_frames"], 0);
    EXPECT_EQ(heights["b"]["pressure_frames"], heights["b"]["frames"]);
    const std::string page = host_sim::read_file(flights().folder.file("compared/page.html"));
    EXPECT_THAT(page,
                AllOf(HasSubstr("Heights of A are pressure altitudes, taken for heights above sea level (--assume-geometric); "
                                "those of B are pressure altitudes alone"),
                      HasSubstr("The ground below is known in ")));
}

TEST_F(TwoRuns, DistancesAndHeightsAreThoseOfPlacesAndRaster) {
    const test_support::RasterHeights heights(raster());
    std::size_t over = 0;
    for (const json& instant : compared()["instants"]) {
        const json &a = instant["a"], &b = instant["b"];
        ASSERT_LE(instant["distance_m"].get<double>(), 3000);
        if (a["height_above_terrain"].is_number()) {
            const double above_m = a["altitude"].get<double>() - heights.at(a["lat_deg"], a["lon_deg"]);
            EXPECT_NEAR(a["height_above_terrain"].get<double>(), above_m, 1) << instant["axis"];
            ++over;
        }
        // The place of B in the record is that of its nearest frame, up to 2.5 s of flight from the counterpart.
        const double nearest_m = metres_between(a["lat_deg"], a["lon_deg"], b["lat_deg"], b["lon_deg"]);
        EXPECT_LE(instant["distance_m"].get<double>(), nearest_m * 1.01 + 1) << "the counterpart is the nearest place";
        EXPECT_GE(instant["distance_m"].get<double>(), nearest_m - 2.5 * 150);
    }
    EXPECT_GT(over, 20u);
    EXPECT_GT(compared()["instants"].size(), 60u);
}

TEST_F(TwoRuns, WhereOnlyPressureIsKnownNoTerrainAlertCouldBeGiven) {
    const auto alerts_of = [](const char* aircraft) {
        return test_support::summary_of(flights().folder.file(std::string("run_") + aircraft))["terrain_alerts"];
    };
    const json own = alerts_of(kOwn), other = alerts_of(kOther);
    EXPECT_EQ(other["possible_frames"], 0);
    EXPECT_GT(other["impossible"]["degraded"]["frames"].get<int>(), 20);
    EXPECT_GT(other["impossible"]["outside"]["frames"].get<int>(), 20);
    const std::vector<json> frames = frames_of(kOwn);
    EXPECT_NEAR(own["possible_frames"].get<double>(),
                static_cast<double>(std::count_if(frames.begin(), frames.end(), is_over_the_raster)), 2);
    const auto report_of = [](const char* aircraft) {
        return host_sim::read_file(flights().folder.file(std::string("run_") + aircraft + "/report.html"));
    };
    EXPECT_THAT(report_of(kOther), HasSubstr("No terrain alert could be given: in all frames "));
    EXPECT_THAT(report_of(kOwn), AllOf(HasSubstr("No terrain alert was given; alerts were possible in "),
                                       HasSubstr("for in the others the aircraft was outside the terrain database.")));
}

TEST(GhostOfAFlight, ByTakeOffItIsWhereItsFixesAre) {
    const std::vector<Fix> own = fixes_of(kOwn), other = fixes_of(kOther);
    host_sim::ReplayOptions replay = flights().replay_of(kOwn, 10700, 11050);
    replay.ghosts = {flights().log_of(kOther)};
    replay.ghost_align = host_sim::GhostAlign::takeoff;
    const test_support::TemporaryFolder folder;
    host_sim::ShownGhosts ghosts;
    run([&](host_sim::Console& console) {
        ghosts = host_sim::make_ghosts(replay, folder.path(), console);
        return 0;
    });
    ASSERT_EQ(ghosts.flights.size(), 1u);
    const host_sim::ShownGhost& ghost = ghosts.flights[0];
    ASSERT_TRUE(ghost.shift_s.has_value());
    EXPECT_NEAR(*ghost.shift_s, takeoff_utc_s(own) - takeoff_utc_s(other), 15) << "fixes are 10 s apart";
    std::size_t met = 0;
    for (std::size_t n = 0; n < other.size(); n += 10) {
        const double time_s = other[n].utc_s + *ghost.shift_s - own.front().utc_s;
        const auto at = std::lower_bound(ghost.places.begin(), ghost.places.end(), time_s,
                                         [](const auto& place, double time) { return place.time_s < time; });
        if (at == ghost.places.begin() || at == ghost.places.end()) continue;
        const auto& before = *(at - 1);
        const double share = (time_s - before.time_s) / (at->time_s - before.time_s);
        const double lat = before.latitude_deg + share * (at->latitude_deg - before.latitude_deg),
                     lon = before.longitude_deg + share * (at->longitude_deg - before.longitude_deg);
        EXPECT_LT(metres_between(lat, lon, other[n].lat_deg, other[n].lon_deg), 150) << time_s;
        ++met;
    }
    EXPECT_GT(met, 150u);
}

TEST(GhostOfAFlight, TheMapShowsTheFlightAndCutsTheGhost) {
    host_sim::ReplayOptions replay = flights().replay_of(kOwn, 10700, 11050);
    replay.output = flights().folder.file("beside");
    replay.ghosts = {flights().log_of(kOther)};
    replay.ghost_align = host_sim::GhostAlign::takeoff;
    run([&](host_sim::Console& console) { return run_replay(replay, console); });
    const std::string page = host_sim::read_file(replay.output + "/report.html");
    EXPECT_THAT(page, HasSubstr(std::string("The line of ghost ") + kOther +
                                " is cut at the border: a part of its flight lies beyond this map"));
    const json ghost = test_support::summary_of(replay.output)["ghosts"][0];
    const std::vector<Fix> other = fixes_of(kOther);
    EXPECT_NEAR(ghost["to_s"].get<double>() - ghost["from_s"].get<double>(), other.back().utc_s - other.front().utc_s, 15);
    replay.output = flights().folder.file("alone");
    replay.ghosts.clear();
    run([&](host_sim::Console& console) { return run_replay(replay, console); });
    EXPECT_THAT(host_sim::read_file(replay.output + "/report.html"), Not(HasSubstr("ghost"))) << "control";
}

}  // namespace
}  // namespace tedavis::test_two_flights
