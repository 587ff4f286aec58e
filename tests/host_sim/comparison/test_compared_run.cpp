#include "host_sim/comparison/compared_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/host_sim/comparison/made_runs.hpp"
#include "tests/support/files/run_folders.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_compared_run {
namespace {

using test_support::expect_user_error;

TEST(ComparedRun, HasWhatTheRecordsAndTheSummarySay) {
    const test_support::TemporaryFolder place;
    test_support::write_run(place, "a", [](FrameResult& result) {
        result.record.alerts.terrain = policy::TerrainAhead::warning;
        result.record.alerts.height_above_terrain_m = 250.5;
        result.record.labels.placed = 7;
        result.record.flight_time.is_date = result.record.frame > 0;
        result.record.flight_time.utc =
            base::Time{} + base::Duration::from_seconds(1000 + 0.1 * static_cast<double>(result.record.frame));
        display::EffectRecord run, skipped;
        run.name = "fog";
        run.state = display::EffectState::run;
        skipped.name = "shadow";
        skipped.state = display::EffectState::skipped;
        EXPECT_TRUE(result.record.effects.try_push_back(run) && result.record.effects.try_push_back(skipped));
    });
    const RgbaPicture picture{4, 4, std::vector<std::uint8_t>(64, 200)};
    test_support::write_picture(place, "a", 2, picture);
    place.write("a/summary.json", R"({"log": "x.log", "design": "cruise", "size": "4x4", "closest": {"by_height": []}})");
    const ComparedRun run = read_compared_run(place.file("a"));
    ASSERT_EQ(run.frames.size(), 5u);
    const ComparedFrame& frame = run.frames[2];
    EXPECT_DOUBLE_EQ(frame.time_s, 0.2);
    EXPECT_EQ(frame.phase, "takeoff.first_climb");
    EXPECT_EQ(frame.terrain_alert, 2);
    EXPECT_EQ(frame.obstacle_alert, 0);
    EXPECT_EQ(frame.values[kAltitude], 1510);
    EXPECT_EQ(frame.values[kHeightAboveTerrain], 250.5);
    EXPECT_EQ(frame.values[kLabelsPlaced], 7);
    EXPECT_EQ(frame.values[kFrameTime], 3);
    EXPECT_TRUE(std::isnan(frame.values[kClearance])) << "it was not measured";
    EXPECT_TRUE(std::isnan(frame.values[kCrowdedRegions])) << "there is no clutter budget";
    EXPECT_EQ(frame.effects, std::vector<std::string>{"fog"});
    EXPECT_NEAR(frame.latitude_deg, 46.5, 1e-9);
    EXPECT_TRUE(run.frames[1].picture.empty());
    EXPECT_EQ(frame.picture, frame_picture_path(place.file("a"), 2));
    EXPECT_EQ(run.design, "cruise");
    EXPECT_TRUE(run.closest.is_object());
    EXPECT_FALSE(run.assumes_heights);
    EXPECT_FALSE(frame.has_pressure_height) << "its height is above the ellipsoid";
    EXPECT_NEAR(*utc_offset_s(run), 1000, 1e-6);
    EXPECT_EQ(frame_time_words(run, 61), "00:17:41 UTC");
}

TEST(ComparedRun, KnowsWhatItsHeightsRestOn) {
    const test_support::TemporaryFolder place;
    test_support::write_run(place, "a", [](FrameResult& result) {
        result.record.own_ship.height_is_geometric = result.record.frame != 3 && result.record.frame != 2;
        if (result.record.frame == 2)  // above sea level by the altimeter's setting
            ASSERT_TRUE(result.record.flags.try_push_back(display::Name("own_ship.height_on_qnh")));
        if (result.record.frame == 4) result.record.own_ship.state = base::SignalState::lost;
    });
    const auto assumes = [&](const std::string& summary) {
        place.write("a/summary.json", summary);
        return read_compared_run(place.file("a")).assumes_heights;
    };
    EXPECT_TRUE(assumes(R"({"assumes_heights": true, "closest": null})"));
    EXPECT_TRUE(assumes(R"({"closest": {"assumes_heights": true}})")) << "runs of before";
    EXPECT_FALSE(assumes(R"({"assumes_heights": false, "closest": {"assumes_heights": false}})"));
    const ComparedRun run = read_compared_run(place.file("a"));
    for (const ComparedFrame& frame : run.frames) EXPECT_EQ(frame.has_pressure_height, frame.frame == 3) << frame.frame;
}

TEST(ComparedRun, CountsRegionsAboveTheClutterBudgetAlone) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directories(place.file("a"));
    place.write(
        "a/frames.jsonl",
        R"({"frame":0,"hash":"0","time_s":1,"clutter":{"budget":0.3,"is_measured":true,"regions":[{"clutter":0.4},{"clutter":0.2}]}})"
        "\n"
        R"({"frame":1,"hash":"0","time_s":0.5,"clutter":{"budget":0.3,"is_measured":false,"regions":[]},"ms":null})"
        "\n");
    const ComparedRun run = read_compared_run(place.file("a"));
    EXPECT_EQ(run.frames[1].values[kCrowdedRegions], 1);
    EXPECT_EQ(run.frames[0].frame, 1u) << "frames are in the order of time";
    EXPECT_TRUE(std::isnan(run.frames[0].values[kCrowdedRegions]));
    EXPECT_TRUE(std::isnan(run.frames[0].values[kFrameTime]));
    EXPECT_FALSE(run.frames[0].has_place);
    EXPECT_EQ(frame_time_words(run, 61), "61.0 s");
}

TEST(ComparedRun, RefusesWhatIsNoRun) {
    const test_support::TemporaryFolder place;
    expect_user_error([&] { (void)read_compared_run(place.file("none")); }, "name a folder that replay or fly wrote");
    std::filesystem::create_directories(place.file("a"));
    place.write("a/frames.jsonl", "{\"frame\":0,\"hash\":\"0\"}\n");
    expect_user_error([&] { (void)read_compared_run(place.file("a")); }, "frames.jsonl:1: a record without time_s");
    place.write("a/frames.jsonl", "{\"frame\":0,\"hash\":\"0\",\"time_s\":0}\n");
    place.write("a/summary.json", "no JSON");
    expect_user_error([&] { (void)read_compared_run(place.file("a")); }, "summary.json");
}

TEST(ComparedRun, DistancesAreThoseOnASphere) {
    EXPECT_NEAR(ground_distance_m(46, 9, 46.01, 9), 0.01 * kDegree_m, 0.01);
    EXPECT_NEAR(ground_distance_m(60, 179.995, 60, -179.995), 0.005 * kDegree_m, 0.01)
        << "across the antimeridian, at half the width";
}

TEST(ComparedRun, TheUsualStepIsTheMedian) {
    ComparedRun run = made_run("a", 9, 0, 2);
    run.frames.back().time_s = 500;
    EXPECT_EQ(median_step_s(run), 2);
    EXPECT_EQ(median_step_s(made_run("b", 1)), 0);
}

TEST(ComparedRun, KnowsItsLogByWhatItHolds) {
    const test_support::TemporaryFolder place;
    const auto with_log_of = [&](const std::string& name, const std::string& log, const std::string& content) {
        std::filesystem::create_directories(place.file(name));
        place.write(name + "/frames.jsonl", "{\"frame\":0,\"hash\":\"0\",\"time_s\":0}\n");
        place.write(name + "/summary.json", "{\"log\": \"" + log + "\", \"can\": {\"frames\": 12}}");
        if (!content.empty()) place.write(name + "/flight.log", content);
        return read_compared_run(place.file(name));
    };
    const std::string text(200'000, 'x');
    const ComparedRun day = with_log_of("day", "out/day/flight.log", text);
    ASSERT_TRUE(day.log_content.has_value()) << "the run was moved from out/day, with its log";
    EXPECT_EQ(day.log_content->first, 200'000u);
    EXPECT_EQ(day.can_frames, 12u);
    EXPECT_EQ(with_log_of("night", place.file("night/flight.log"), text).log_content, day.log_content);
    EXPECT_NE(with_log_of("begin", "flight.log", "y" + text.substr(1)).log_content, day.log_content);
    EXPECT_NE(with_log_of("end", "flight.log", text.substr(1) + "y").log_content, day.log_content);
    EXPECT_NE(with_log_of("size", "flight.log", text + "x").log_content, day.log_content);
    EXPECT_EQ(with_log_of("elsewhere", place.file("day/flight.log"), "").log_content, day.log_content);
    EXPECT_FALSE(with_log_of("gone", "out/gone/flight.log", "").log_content.has_value());
    EXPECT_TRUE(with_log_of("short", "flight.log", "x").log_content.has_value());
}

TEST(ComparedRun, APictureOrPhaseMayBeUnknown) {
    ComparedFrame frame = made_frame(0, 0, 0, 0);
    EXPECT_TRUE(knows_picture(frame) && knows_phase(frame));
    for (const char* hash : {"", "0", "0000000000000000"}) {
        frame.hash = hash;
        EXPECT_FALSE(knows_picture(frame)) << hash;
    }
    for (const char* phase : {"", "unknown"}) {
        frame.phase = phase;
        EXPECT_FALSE(knows_phase(frame)) << phase;
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_compared_run
