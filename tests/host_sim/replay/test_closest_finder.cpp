#include "host_sim/replay/closest_finder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "host_sim/replay/run_recorder.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_lines.hpp"

namespace tedavis::host_sim::test_closest_finder {
namespace {

/// Frames at the first and the last second of the flight alone.
nlohmann::json summary_of_two_frames(const FlightSource& flight, bool interrupted = false) {
    const tedavis::test_support::FlownFiles files(flight);
    const ReplayOptions options = files.options("run");
    std::ostringstream results, notes;
    Console console{results, notes, true, false};
    DisplaySession session{options.picture, false};
    FlightPlayer player{{options.log, options.picture.bus, "", options.switch_config}, session.display()};
    RunRecorder recorder(options, session, player);
    for (const double seconds : {0.5, 7.5}) {
        static_cast<void>(recorder.draw(player.first() + base::Duration::from_seconds(seconds)));
        recorder.keep();
    }
    static_cast<void>(recorder.finish(interrupted, console));
    const auto lines = tedavis::test_support::frame_lines(options.output);
    nlohmann::json summary = tedavis::test_support::summary_of(options.output);
    summary["frames_read"] = lines;
    return summary;
}

TEST(ClosestFinder, SearchesBetweenTheFrames) {
    const tedavis::test_support::FlownCircle flight;
    const nlohmann::json summary = summary_of_two_frames(flight);
    const nlohmann::json& closest = summary["closest"];
    ASSERT_FALSE(closest.is_null());
    EXPECT_LE(closest["sample_step_s"].get<double>(), 1.01);
    ASSERT_GE(closest["by_distance"].size(), 1u);
    double least_m = 1e9;
    for (const nlohmann::json& line : summary["frames_read"]) {
        ASSERT_FALSE(line["clearance"].is_null());
        least_m = std::min(least_m, line["clearance"]["nearest"]["distance_m"].get<double>());
        EXPECT_LE(line["clearance"]["nearest"]["distance_m"], line["alerts"]["terrain"]["height_above_terrain_m"]);
    }
    EXPECT_LE(closest["by_distance"][0]["nearest"]["distance_m"].get<double>(), least_m + 0.01);
    EXPECT_TRUE(closest["by_distance"][0]["utc"].is_string());
    EXPECT_TRUE(closest["by_distance"][0]["picture"].is_null()) << "no pictures are kept";
}

TEST(ClosestFinder, AwayFromTheTerrainThereIsNothing) {
    const nlohmann::json summary = summary_of_two_frames(tedavis::test_support::FlownAway());
    EXPECT_EQ(summary["closest"]["by_height"].size() + summary["closest"]["by_distance"].size(), 0u);
    EXPECT_GT(summary["closest"]["unknown_s"], 6);
    EXPECT_TRUE(summary["frames_read"][0]["clearance"].is_null());
}

TEST(ClosestFinder, AnInterruptedRunIsNotSearched) {
    EXPECT_TRUE(summary_of_two_frames(tedavis::test_support::FlownCircle(), true)["closest"].is_null());
}

}  // namespace
}  // namespace tedavis::host_sim::test_closest_finder
