#include "host_sim/evaluation/flight_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flight_run {
namespace {

using ::testing::ElementsAre;

TEST(FlightRun, ReadsRecordsPicturesAndSummary) {
    const test_support::TemporaryFolder place;
    test_support::write_striped_run(place, "run", 4, {2});
    (void)place.write("run/summary.json", R"({"log":"a.log","design":"cruise","device":"es3-mid","size":"96x72"})");
    const FlightRun run = read_flight_run(place.file("run"));
    ASSERT_EQ(run.frames.size(), 4u);
    EXPECT_EQ(run.design, "cruise");
    EXPECT_EQ(run.log, "a.log");
    EXPECT_EQ(run.frames[3].time_s, 3);
    EXPECT_EQ(run.frames[3].phase, "takeoff.first_climb");
    EXPECT_EQ(run.frames[3].phase_source, "can");
    EXPECT_EQ(run.frames[3].prioritized, "terrain");
    EXPECT_EQ(run.frames[3].picture, place.file("run/frames/000003.png"));
    const auto records = records_of(run, {2, 9});
    EXPECT_EQ(records[0]["frame"], 2);
    EXPECT_TRUE(records[1].is_null());
    EXPECT_TRUE(is_folder(place.path()));
    EXPECT_FALSE(is_folder(place.file("run/summary.json")));
}

TEST(FlightRun, ItsSummaryMayBeMissingButNotDamaged) {
    const test_support::TemporaryFolder place;
    test_support::write_striped_run(place, "run", 4, {2});
    EXPECT_EQ(read_flight_run(place.file("run")).design, "") << "as of an interrupted run";
    for (const char* damaged : {"", "[]", R"({"log":"a.log","design":"cru)"}) {
        (void)place.write("run/summary.json", damaged);
        test_support::expect_user_error([&] { (void)read_flight_run(place.file("run")); },
                                        "run/summary.json: no summary of a run; replay the run again");
    }
}

TEST(FlightRun, FramesOfARunThatGoesBackwardsAreInTheOrderOfTime) {
    const test_support::TemporaryFolder place;
    test_support::write_run(place, "run", [](FrameResult& result) {
        result.record.time = base::Time{} + base::Duration::from_seconds(10.0 - static_cast<double>(result.record.frame));
    });
    for (std::uint64_t n = 0; n < 5; ++n) test_support::write_picture(place, "run", n, test_support::striped_picture(4, 4, 2));
    const FlightRun run = read_flight_run(place.file("run"));
    EXPECT_EQ(run.frames.front().frame, 4u);
    EXPECT_EQ(run.frames.front().time_s, 6);
    EXPECT_TRUE(run.frames.back().prioritized.empty()) << "equal weights";
}

TEST(FlightRun, PicturesWithTheAccuracyDrawnOverThemAreKnown) {
    const test_support::TemporaryFolder place;
    test_support::write_run(
        place, "run", [](FrameResult& result) { result.has_accuracy_overlay = result.record.frame == 1; }, 2);
    for (std::uint64_t n = 0; n < 2; ++n) test_support::write_picture(place, "run", n, test_support::striped_picture(4, 4, 2));
    const FlightRun run = read_flight_run(place.file("run"));
    EXPECT_FALSE(run.frames[0].has_accuracy_overlay);
    EXPECT_TRUE(run.frames[1].has_accuracy_overlay);
}

TEST(FlightRun, SaysHowPicturesAreMade) {
    const test_support::TemporaryFolder place;
    test_support::write_run(place, "run", [](FrameResult&) {});
    test_support::expect_user_error([&] { (void)read_flight_run(place.file("run")); }, "--frames png");
    test_support::expect_user_error([&] { (void)read_flight_run(place.path()); }, "name a folder that replay or fly wrote");
    (void)place.write("run/frames.jsonl", "{\"frame\":0,\"hash\":\"1\"}\n");
    test_support::expect_user_error([&] { (void)read_flight_run(place.file("run")); }, "frames.jsonl:1: a record without time_s");
}

TEST(FlightRun, ObstaclesAreKnownWhereTheRunRecordedThem) {
    const test_support::TemporaryFolder place;
    const auto read = [&](bool recorded) {
        test_support::write_run(
            place, "run",
            [&](FrameResult& result) {
                result.has_layers = recorded;
                result.record.design = base::FixedString<47>("cruise");
                display::ObstaclePlace mast;
                mast.name = base::FixedString<31>("Mast 1");
                mast.state = display::ObstacleState::left_out;
                mast.ahead_s = 12;
                mast.box = {10, 20, 30, 40};
                static_cast<void>(result.obstacles.try_push_back(mast));
            },
            1);
        test_support::write_picture(place, "run", 0, test_support::striped_picture(4, 4, 2));
        return read_flight_run(place.file("run")).frames[0];
    };
    const FlightFrame frame = read(true);
    EXPECT_EQ(frame.design, "cruise");
    ASSERT_TRUE(frame.obstacles.has_value());
    ASSERT_EQ(frame.obstacles->size(), 1u);
    const FrameObstacle& mast = frame.obstacles->at(0);
    EXPECT_EQ(mast.name, "Mast 1");
    EXPECT_EQ(mast.state, "left_out");
    EXPECT_EQ(mast.ahead_s, 12);
    EXPECT_EQ(mast.box, (std::array<double, 4>{10, 20, 40, 60}));
    EXPECT_FALSE(read(false).obstacles.has_value());
}

TEST(FlightRun, OfEqualWeightsTheOneThatTheDesignStatesHigherComesFirst) {
    EXPECT_THAT(first_aspects({{{0.3, 0.3}, {0.5, 0.5}, {1, 1}}}), ElementsAre("uncertainty"));
    EXPECT_THAT(first_aspects({{{1, 0.3}, {0.5, 0.5}, {1, 1}}}), ElementsAre("uncertainty")) << "terrain is raised by a hazard";
    EXPECT_THAT(first_aspects({{{1, 0.3}, {0.5, 0.5}, {0.9, 0.9}}}), ElementsAre("terrain")) << "raised above it";
    EXPECT_THAT(first_aspects({{{1, 1}, {1, 1}, {0.5, 0.5}}}), ElementsAre("terrain", "data"));
    EXPECT_TRUE(first_aspects({}).empty());
}

TEST(FlightRun, WeightsAreReadFromTheRecord) {
    const test_support::TemporaryFolder place;
    test_support::write_run(
        place, "run",
        [](FrameResult& result) {
            result.record.terrain_aspect.weight = 1;
            result.record.data_aspect.weight = 0.5;
            result.record.uncertainty_aspect.weight = 1;
            for (const auto& [name, stated] : {std::pair{"terrain", 0.3}, {"uncertainty", 1.0}})
                EXPECT_TRUE(result.record.weights.try_push_back({display::Name(name), 1, stated}));
        },
        1);
    test_support::write_picture(place, "run", 0, test_support::striped_picture(4, 4, 2));
    const FlightFrame frame = read_flight_run(place.file("run")).frames[0];
    EXPECT_EQ(frame.weights[0].weight, 1);
    EXPECT_EQ(frame.weights[0].stated, 0.3);
    EXPECT_EQ(frame.weights[1].stated, 0.5) << "not stated apart";
    EXPECT_EQ(frame.prioritized, "") << "of this frame none weighs most";
    EXPECT_THAT(first_aspects(frame.weights), ElementsAre("uncertainty"));
}

TEST(FlightRun, PhasesAreContiguous) {
    std::vector<FlightFrame> frames(5);
    for (std::size_t n = 0; n < 5; ++n) frames[n].phase = n == 2 ? "b" : "a";
    const auto spans = phase_spans(frames);
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_EQ(spans[1].phase, "b");
    EXPECT_EQ(spans[2].first, 3u);
    EXPECT_EQ(spans[2].end, 5u);
    EXPECT_TRUE(phase_spans({}).empty());
}

TEST(FlightRun, LayersAreNamedByTheRecord) {
    EXPECT_THAT(layer_names({{"layers", {"terrain", "data"}}}), ElementsAre("terrain", "data"));
    EXPECT_TRUE(layer_names({{"layers", 3}}).empty());
    EXPECT_TRUE(layer_names(nlohmann::ordered_json::object()).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_run
