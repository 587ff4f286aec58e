#include "render_core/policy/database_dates.hpp"

#include <gtest/gtest.h>

#include "render_core/base/utc_time.hpp"

namespace tedavis::policy::test_database_dates {
namespace {

using base::Currency;
using base::SignalState;

base::Time utc(const char* text) {
    base::Time time;
    EXPECT_TRUE(base::parse_utc(text, time)) << text;
    return time;
}

/// December 2026.
base::ValidPeriod december() { return {utc("2026-12-01T00:00:00Z"), utc("2027-01-01T00:00:00Z")}; }

Currency currency_on(const char* text) { return currency_of({december()}, flight::time_of_source(utc(text))); }

TEST(DatabaseDates, TheDateOfTheFrameDecides) {
    EXPECT_EQ(currency_on("2026-11-30T23:59:59Z"), Currency::not_yet_valid);
    EXPECT_EQ(currency_on("2026-12-01T00:00:00Z"), Currency::current);
    EXPECT_EQ(currency_on("2026-12-31T23:59:59Z"), Currency::current);
    EXPECT_EQ(currency_on("2027-01-01T00:00:00Z"), Currency::expired);
    EXPECT_EQ(currency_of({}, flight::time_of_source(utc("2027-01-01T00:00:00Z"))), Currency::current) << "no dates";
}

/// A board's clock starts with the machine: what was found at the start holds until the bus states UTC, which decides.
TEST(DatabaseDates, WithoutADateTheStartDecidesAndWithOneItDoesNot) {
    const flight::FlightTime no_date = flight::time_of_source({90'000'000'000});
    ASSERT_FALSE(no_date.is_date);
    EXPECT_EQ(currency_of({december()}, no_date), Currency::current);
    for (const Currency at_start : {Currency::current, Currency::not_yet_valid, Currency::expired}) {
        EXPECT_EQ(currency_of({december(), at_start}, no_date), at_start);
        EXPECT_EQ(currency_of({december(), at_start}, flight::time_of_source(utc("2026-12-24T12:00:00Z"))), Currency::current);
        EXPECT_EQ(currency_of({december(), at_start}, flight::time_of_source(utc("2027-06-01T12:00:00Z"))), Currency::expired);
    }
}

/// The bus states UTC until an instant of the source's clock, which goes on.
TEST(DatabaseDates, LostUtcTakesNothingBack) {
    const base::Time now{90'000'000'000}, midnight = utc("2027-01-01T00:00:00Z");
    const DatabaseDates found_current{december()};
    const auto currency = [&](base::Duration from_midnight, SignalState state) {
        const flight::UtcEstimate estimate{midnight + from_midnight - now, state};
        return currency_of(found_current, flight::flight_time(estimate, now));
    };
    for (const SignalState state : {SignalState::valid, SignalState::lost}) {
        EXPECT_EQ(currency(base::Duration::seconds(60), state), Currency::expired);
        EXPECT_EQ(currency(base::Duration::seconds(-60), state), Currency::current);
    }
    EXPECT_EQ(currency(base::Duration::seconds(60), SignalState::missing), Currency::current) << "control: never stated";
}

TEST(DatabaseDates, TheClockOfTheStartCountsIfItWasSet) {
    EXPECT_EQ(dates_at_start(december(), utc("2026-11-30T12:00:00Z")).at_start, Currency::not_yet_valid);
    EXPECT_EQ(dates_at_start(december(), utc("2026-12-30T12:00:00Z")).at_start, Currency::current);
    EXPECT_EQ(dates_at_start(december(), utc("2027-01-30T12:00:00Z")).at_start, Currency::expired);
    EXPECT_EQ(dates_at_start(december(), {0}).at_start, Currency::current) << "1970";
    EXPECT_EQ(dates_at_start({}, utc("2027-01-30T12:00:00Z")).at_start, Currency::current) << "no dates";
    EXPECT_EQ(dates_at_start(december(), {0}).period.begin, december().begin);
    EXPECT_EQ(dates_at_start(december(), {0}).period.end, december().end);
}

}  // namespace
}  // namespace tedavis::policy::test_database_dates
