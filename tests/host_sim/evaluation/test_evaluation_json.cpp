#include "host_sim/evaluation/evaluation_json.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/evaluated_flights.hpp"

namespace tedavis::host_sim::test_evaluation_json {
namespace {

TEST(EvaluationJson, APictureHasWhatTheContractNames) {
    EvaluatedPicture one{"in/a.png", "a", test_support::made_flight(3).measures[0]};
    one.measures.layers = {{"terrain", 0.75, 0.5}, {"data", 0.25, 0.5}};
    one.measures.gaze = GazeScore{4, 0.8, 1.5};
    one.measures.opinions = ClutterOpinions{2.5, 3.5};
    const EvaluationSettings settings;
    const auto json = pictures_json({one}, settings, false);
    EXPECT_EQ(json["interrupted"], false);
    const auto& picture = json["pictures"][0];
    EXPECT_EQ(picture["file"], "in/a.png");
    EXPECT_EQ(picture["clutter"], one.measures.clutter);
    ASSERT_EQ(picture["clutter_grid"].size(), 6u);
    ASSERT_EQ(picture["clutter_grid"][5].size(), 8u);
    EXPECT_EQ(picture["clutter_grid"][1][1], one.measures.clutter_grid[9]);
    EXPECT_EQ(picture["saliency_map"], "a.saliency.png");
    EXPECT_EQ(picture["canny"]["sigma"], settings.canny.sigma);
    EXPECT_EQ(picture["canny"]["low"], settings.canny.low);
    EXPECT_EQ(picture["canny"]["high"], settings.canny.high);
    EXPECT_EQ(picture["layer_shares"]["terrain"], 0.75);
    EXPECT_EQ(picture["gaze"]["auc"], 0.8);
    EXPECT_EQ(json["gaze"]["nss"], 1.5);
    EXPECT_EQ(picture["feature_congestion"], 2.5);
    EXPECT_EQ(picture["subband_entropy"], 3.5);
    EXPECT_EQ(picture["views"]["congestion"], "a.congestion.png");
    EXPECT_EQ(json["order_agreement"]["feature_congestion"]["pairs"], 0) << "of one picture";
}

TEST(EvaluationJson, AFlightHasAllFramesPhasesAndPeaks) {
    FlightReport report;
    report.flights.push_back(test_support::made_flight(90));
    test_support::give_moments(report.flights[0]);
    test_support::give_disputed_moments(report.flights[0]);
    const auto json = flights_json(report);
    EXPECT_EQ(json["frames"], 90);
    EXPECT_EQ(json["pictures"].size(), 90u);
    EXPECT_EQ(json["peaks"].size(), 3u);
    EXPECT_EQ(json["phases"].size(), 2u);
    EXPECT_TRUE(json["phases"][0]["prioritized_share"].is_null());
    EXPECT_EQ(json["pictures"][45]["time_s"], 45);
    EXPECT_EQ(json["pictures"][45]["saliency_map"], "B.saliency.png") << "a peak";
    EXPECT_TRUE(json["pictures"][0]["saliency_map"].is_null());
    EXPECT_TRUE(json["gaze"].is_null());
    EXPECT_EQ(json["peaks"][1]["feature_congestion"], 5.0);
    EXPECT_EQ(json["order_agreement"]["subband_entropy"]["pairs"], 3);
    EXPECT_EQ(json["order_agreement"]["subband_entropy"]["alike"], 2);
    EXPECT_EQ(json["peaks"][1]["plan"]["weights"], "terrain 1.00");
}

TEST(EvaluationJson, TwoFlightsStandBesideTheirDifferences) {
    FlightReport report;
    report.flights.push_back(test_support::made_flight(30));
    report.flights.push_back(test_support::made_flight(30, 0.2));
    report.comparison = compared(report.flights[0], report.flights[1]);
    const auto json = flights_json(report);
    EXPECT_EQ(json["runs"].size(), 2u);
    EXPECT_EQ(json["differences"]["frames"], 30);
    EXPECT_NEAR(json["differences"]["all"]["change"].get<double>(), 0.1, 1e-12);
}

TEST(EvaluationJson, GazeIsMeanOverThePicturesThatWereLookedAt) {
    std::vector<PictureMeasures> measures(3);
    measures[0].gaze = GazeScore{1, 0.5, 1.0};
    measures[2].gaze = GazeScore{9, 0.9, std::nullopt};
    const auto json = gaze_summary_json({&measures[0], &measures[1], &measures[2]});
    EXPECT_EQ(json["pictures"], 2);
    EXPECT_NEAR(json["auc"].get<double>(), 0.7, 1e-12);
    EXPECT_EQ(json["nss"], 1.0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluation_json
