#include "render_core/flight/flight_time.hpp"

#include <gtest/gtest.h>

namespace tedavis::flight::test_flight_time {
namespace {

using base::Duration;
using base::SignalState;

constexpr base::Time kDate{1'780'315'200'000'000'000};  // 2026-06-01T12:00:00Z
constexpr base::Time kBoard{77'000'000'000};            // since the board was started

TEST(FlightTime, IsTheSourcesOwnWhereTheBusHasNeverStatedAny) {
    EXPECT_TRUE(flight_time({}, kDate).is_date);
    EXPECT_TRUE(flight_time({}, kDate).is_confirmed);
    EXPECT_EQ(flight_time({}, kDate).utc, kDate);
    EXPECT_FALSE(flight_time({}, kBoard).is_date);
    EXPECT_FALSE(flight_time({}, kBoard).is_confirmed);
}

TEST(FlightTime, IsTheBusesBeforeTheSources) {
    const UtcEstimate utc{kDate - kBoard, SignalState::valid};
    EXPECT_EQ(flight_time(utc, kBoard).utc, kDate);
    EXPECT_TRUE(flight_time(utc, kBoard).is_confirmed);
    const UtcEstimate old{Duration::seconds(-86'400 * 365), SignalState::valid};
    EXPECT_EQ((kDate - flight_time(old, kDate).utc).ns, Duration::seconds(86'400 * 365).ns) << "a recording made later";
}

TEST(FlightTime, WithoutTheBusItGoesOnUnconfirmed) {
    const UtcEstimate utc{kDate - kBoard, SignalState::lost};
    const FlightTime later = flight_time(utc, kBoard + Duration::seconds(60));
    EXPECT_TRUE(later.is_date);
    EXPECT_FALSE(later.is_confirmed);
    EXPECT_EQ((later.utc - kDate).ns, Duration::seconds(60).ns);
    EXPECT_FALSE(flight_time({kDate - kBoard, SignalState::lost}, kDate).is_confirmed) << "nor do the stamps of the source";
}

TEST(FlightTime, AnOffsetThatGivesNoDateIsNone) {
    EXPECT_FALSE(flight_time({Duration::seconds(5), SignalState::valid}, kBoard).is_date);
    EXPECT_FALSE(flight_time({Duration::seconds(4'000'000'000), SignalState::valid}, kDate).is_confirmed);
}

}  // namespace
}  // namespace tedavis::flight::test_flight_time
