#include "host_sim/evaluation/evaluated_flight.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/evaluated_flights.hpp"

namespace tedavis::host_sim::test_evaluated_flight {
namespace {

TEST(EvaluatedFlight, SummariesAreThoseOfTheirFrames) {
    EvaluatedFlight flight = test_support::made_flight(90);
    const std::vector<SpanSummary> phases = summaries_by_phase(flight);
    ASSERT_EQ(phases.size(), 2u);
    double sum = 0, highest = 0;
    for (std::size_t n = 45; n < 90; ++n) {
        sum += flight.measures[n].clutter;
        highest = std::max(highest, flight.measures[n].clutter);
    }
    EXPECT_EQ(phases[1].phase, "approach.final");
    EXPECT_EQ(phases[1].first, 45u);
    EXPECT_EQ(phases[1].end, 90u);
    EXPECT_NEAR(phases[1].mean, sum / 45, 1e-12);
    EXPECT_EQ(phases[1].highest, highest);
    EXPECT_EQ(flight.measures[phases[1].highest_at].clutter, highest);
    EXPECT_EQ(phases[0].prioritized, "data");
    EXPECT_EQ(phases[0].comes_first, "data");
    EXPECT_EQ(summary_of(flight, 0, 90).prioritized, "") << "it changes";
    EXPECT_EQ(summary_of(flight, 0, 90).comes_first, "");
    EXPECT_FALSE(prioritized_share(phases[0]).has_value());
    EXPECT_FALSE(mean_prioritized_share(flight).has_value());
    test_support::give_layers(flight);
    flight.measures[0].layers.clear();  // the mean is of those that have a mask
    EXPECT_NEAR(*prioritized_share(summaries_by_phase(flight)[0]), 0.3, 1e-12);
    EXPECT_NEAR(*mean_prioritized_share(flight), (44 * 0.3 + 45 * 0.5) / 89, 1e-12) << "data in cruise, terrain in the approach";
    EXPECT_NEAR(summary_of(flight, 0, 90).layers[0].area, 0.7, 1e-12);
}

TEST(EvaluatedFlight, AHazardThatRaisesAWeightForAWhileChangesNotWhatComesFirst) {
    EvaluatedFlight flight = test_support::made_flight(90);
    for (std::size_t n = 0; n < 45; ++n) flight.run.frames[n].weights = {{{n < 20 ? 1.0 : 0.3, 0.3}, {0.5, 0.5}, {1, 1}}};
    const auto cruise = [&] { return summaries_by_phase(flight)[0]; };
    EXPECT_EQ(cruise().comes_first, "uncertainty");
    EXPECT_EQ(cruise().prioritized, "uncertainty");
    for (std::size_t n = 0; n < 45; ++n) flight.run.frames[n].weights = {{{1, 0.3}, {0.5, 0.5}, {1, 1}}};
    EXPECT_EQ(cruise().comes_first, "uncertainty") << "alike in every frame, and stated higher";
    for (std::size_t n = 0; n < 45; ++n) flight.run.frames[n].weights = {{{0.8, 0.8}, {0.8, 0.8}, {0.5, 0.5}}};
    EXPECT_EQ(cruise().comes_first, "terrain and data alike");
    EXPECT_EQ(cruise().prioritized, "");
    for (std::size_t n = 0; n < 45; ++n) flight.run.frames[n].weights = {{{1, 1}, {1, 1}, {1, 1}}};
    EXPECT_EQ(cruise().comes_first, "terrain, data and uncertainty alike");
    for (std::size_t n = 0; n < 45; ++n) flight.run.frames[n].weights = {};
    EXPECT_EQ(cruise().comes_first, "none");
    for (std::size_t n = 0; n < 90; ++n) flight.run.frames[n].weights = {{{0.8, 0.8}, {0.8, 0.8}, {0.5, 0.5}}};
    EXPECT_EQ(summary_of(flight, 0, 90).comes_first, "terrain and data alike") << "the same in both phases";
}

TEST(EvaluatedFlight, MomentsAreThePeaksOrTheHighestValue) {
    EvaluatedFlight flight = test_support::made_flight(90);
    const std::vector<FlightMoment> moments = moments_of(flight, "");
    ASSERT_EQ(moments.size(), 3u);
    EXPECT_EQ(moments[0].label, "A");
    EXPECT_EQ(moments[1].index, 45u);
    EXPECT_EQ(moments_of(flight, "B")[2].label, "B3");
    for (PictureMeasures& one : flight.measures) one.clutter = 0.1;
    flight.measures[7].clutter = 0.101;
    const std::vector<FlightMoment> highest = moments_of(flight, "");
    ASSERT_EQ(highest.size(), 1u);
    EXPECT_EQ(highest[0].index, 7u);
    EXPECT_EQ(highest[0].prominence, 0);
}

TEST(EvaluatedFlight, RegionsHaveNamesAndMeans) {
    const perception::RegionGrid grid{8, 6};
    EXPECT_EQ(region_name(grid, 0, 0), "upper left");
    EXPECT_EQ(region_name(grid, 4, 2), "middle centre");
    EXPECT_EQ(region_name(grid, 7, 5), "lower right");
    const EvaluatedFlight flight = test_support::made_flight(30);
    const std::vector<double> means = mean_grid(flight);
    ASSERT_EQ(means.size(), 48u);
    EXPECT_EQ(busiest_region(means), 9u);
    EXPECT_NEAR(means[9], 2 * summary_of(flight, 0, 30).mean, 1e-12);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluated_flight
