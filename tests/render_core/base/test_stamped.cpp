#include "render_core/base/stamped.hpp"

#include <gtest/gtest.h>

#include "render_core/base/time.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::base::test_stamped {
namespace {

constexpr FreshnessLimits kLimits{Duration::milliseconds(500), Duration::seconds(2)};
constexpr Time kStamp{1'700'000'000'000'000'000};

TEST(Stamped, ages_from_valid_to_stale_to_lost) {
    const Stamped<double> value(4.5, kStamp);
    const auto state_after = [&](std::int64_t ns) { return value.state({kStamp.ns + ns}, kLimits); };
    EXPECT_EQ(state_after(0), SignalState::valid);
    EXPECT_EQ(state_after(500'000'000), SignalState::valid);
    EXPECT_EQ(state_after(500'000'001), SignalState::stale);
    EXPECT_EQ(state_after(2'000'000'000), SignalState::stale);
    EXPECT_EQ(state_after(2'000'000'001), SignalState::lost);
    EXPECT_EQ(value.value_or(0), 4.5) << "the value outlives its freshness; the state says what may be done with it";
}

TEST(Stamped, a_stamp_from_the_future_is_trusted_for_the_stale_limit_only) {
    const Stamped<double> value(1, kStamp);
    EXPECT_EQ(value.state({kStamp.ns - 500'000'000}, kLimits), SignalState::valid);
    EXPECT_EQ(value.state({kStamp.ns - 500'000'001}, kLimits), SignalState::lost);
}

TEST(Stamped, missing_and_invalid_win_over_age) {
    EXPECT_EQ(Stamped<double>().state(kStamp, kLimits), SignalState::missing);
    EXPECT_EQ(Stamped<double>().value_or(7.0), 7.0);
    const Stamped<double> bad(1, kStamp, Quality::bad);
    EXPECT_EQ(bad.state(kStamp, kLimits), SignalState::invalid);
    EXPECT_EQ(bad.state({kStamp.ns + 100'000'000'000}, kLimits), SignalState::invalid);
    EXPECT_EQ(Stamped<double>(1, kStamp, Quality::degraded).state(kStamp, kLimits), SignalState::valid);
}

TEST(SignalState, every_state_has_its_own_name) {
    EXPECT_STREQ(to_string(SignalState::missing), "missing");
    EXPECT_STREQ(to_string(SignalState::valid), "valid");
    EXPECT_STREQ(to_string(SignalState::stale), "stale");
    EXPECT_STREQ(to_string(SignalState::lost), "lost");
    EXPECT_STREQ(to_string(SignalState::invalid), "invalid");
    EXPECT_STREQ(to_string(static_cast<SignalState>(99)), "invalid");
}

TEST(Time, a_day_is_as_exact_as_a_nanosecond) {
    EXPECT_EQ((Time{kStamp.ns + 1} - kStamp).ns, 1);
    EXPECT_EQ((kStamp + Duration::seconds(86400)) - kStamp, Duration::seconds(86400));
    EXPECT_EQ(Duration::from_seconds(0.1).ns, 100'000'000);
    EXPECT_EQ(Duration::from_seconds(-0.1).ns, -100'000'000);
    EXPECT_EQ(Duration::from_seconds(1e-9 * 0.6).ns, 1);
    EXPECT_DOUBLE_EQ(Duration::milliseconds(1500).to_seconds(), 1.5);
}

TEST(Units, factors_are_the_legal_definitions) {
    EXPECT_DOUBLE_EQ(1000 * kMetresPerFoot, 304.8);
    EXPECT_DOUBLE_EQ(100 * kMpsPerKnot, 185200.0 / 3600.0);
    EXPECT_DOUBLE_EQ(500 * kMpsPerFootPerMinute, 2.54);
    EXPECT_DOUBLE_EQ(radians(180.0), kPi);
    EXPECT_DOUBLE_EQ(degrees(radians(47.25)), 47.25);
}

}  // namespace
}  // namespace tedavis::base::test_stamped
