#include "host_sim/replay/flight_outline.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_flight_outline {
namespace {

const base::Time kBegin{1'700'000'000'000'000'000};

base::Time second(std::int64_t s) { return kBegin + base::Duration::seconds(s); }

flight::OwnShipEstimate at(double latitude_rad, base::SignalState state = base::SignalState::valid) {
    flight::OwnShipEstimate own_ship;
    own_ship.position.latitude_rad = latitude_rad;
    own_ship.state = state;
    return own_ship;
}

TEST(FlightOutline, WantsAPlaceASecond) {
    FlightOutline outline;
    EXPECT_TRUE(outline.wants_place(kBegin));
    outline.add_place(at(0.5), kBegin);
    EXPECT_FALSE(outline.wants_place(kBegin + base::Duration::milliseconds(980)));
    EXPECT_TRUE(outline.wants_place(second(1)));
    outline.add_place(at(0.6, base::SignalState::stale), second(1));
    ASSERT_EQ(outline.places().size(), 1u) << "a position that is not valid is none";
    EXPECT_EQ(outline.places()[0].latitude_rad, 0.5);
    EXPECT_EQ(outline.places()[0].time, kBegin);
}

TEST(FlightOutline, StaysSmallHoweverLongTheFlight) {
    FlightOutline outline;
    const auto seconds = static_cast<std::int64_t>(5 * FlightOutline::kMaxPlaces);
    for (std::int64_t s = 0; s < seconds; ++s)
        if (outline.wants_place(second(s))) outline.add_place(at(static_cast<double>(s)), second(s));
    EXPECT_LE(outline.places().size(), FlightOutline::kMaxPlaces);
    EXPECT_GE(outline.places().size(), FlightOutline::kMaxPlaces / 2);
    for (std::size_t n = 0; n < outline.places().size(); ++n) {
        const std::int64_t s = static_cast<std::int64_t>(n) * outline.stride();
        ASSERT_EQ(outline.places()[n].time, second(s));
        ASSERT_EQ(outline.places()[n].latitude_rad, static_cast<double>(s));
    }
}

TEST(FlightOutline, NotesChangesOfThePhaseAndNotTheFirstOne) {
    FlightOutline outline;
    const flight::FlightPhase phases[] = {{flight::Scenario::cruise}, {flight::Scenario::cruise}, flight::kApproachFinal,
                                          flight::kApproachFinal,     flight::kApproachLanding,   {flight::Scenario::cruise}};
    for (std::int64_t s = 0; s < 6; ++s) outline.add_phase(phases[s], second(s));
    EXPECT_EQ(outline.phase_changes(), (std::vector<base::Time>{second(2), second(4), second(5)}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_outline
