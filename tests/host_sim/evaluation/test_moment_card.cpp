#include "host_sim/evaluation/moment_card.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flights/evaluated_flights.hpp"

namespace tedavis::host_sim::test_moment_card {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(MomentCard, ShowsPicturesAndPlan) {
    EvaluatedFlight flight = test_support::made_flight(90);
    test_support::give_layers(flight);
    test_support::give_moments(flight);
    const std::string card = moment_card({&flight, ""}, flight.moments[1], {}, {});
    for (const char* part : {"id='moment-B'", "45.0 s, approach.final, clutter 0.200", "a &lt;plain&gt; one",
                             "(row 2, column 2), 0.400", "terrain 50 % on 70 % of the pixels", "phase by can",
                             "Feature Congestion 4.00, Subband Entropy 3.50 bits", "class='first' title='terrain"})
        EXPECT_THAT(card, HasSubstr(part));
    EXPECT_EQ(count(card, "<img "), 5u);
    EXPECT_EQ(count(card, " alt='"), 5u);
    EXPECT_THAT(moment_tab(flight, flight.moments[1]), HasSubstr("href='#moment-B'"));
}

TEST(MomentCard, TwoFlightsStandOneBelowTheOther) {
    EvaluatedFlight flight = test_support::made_flight(90), other = test_support::made_flight(90, 0.3);
    test_support::give_moments(flight, "A");
    flight.moments[0].other = flight.moments[0].index;
    const std::string card = moment_card({&flight, "A default"}, flight.moments[0], {&other, "B <cruise>"}, {});
    EXPECT_EQ(count(card, "<img "), 10u);
    EXPECT_THAT(card, HasSubstr("B &lt;cruise&gt;</b>: clutter 0.4"));
}

TEST(MomentCard, AFlightWithoutPeaksSaysSo) {
    EvaluatedFlight flight = test_support::made_flight(9);
    test_support::give_moments(flight);
    flight.moments[0].prominence = 0;
    const std::string card = moment_card({&flight, ""}, flight.moments[0], {}, {});
    EXPECT_THAT(card, HasSubstr("a flight without peaks"));
    EXPECT_THAT(card, Not(HasSubstr("rises by")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_moment_card
