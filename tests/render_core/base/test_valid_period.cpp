#include "render_core/base/valid_period.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/hard_case.hpp"

namespace tedavis::base::test_valid_period {
namespace {

constexpr Time kBegin{1'000}, kEnd{2'000}, kLongAgo{INT64_MIN}, kLate{INT64_MAX};

TEST(ValidPeriod, BeginsWithItsFirstInstantAndEndsBeforeTheNextOne) {
    const ValidPeriod period{kBegin, kEnd};
    EXPECT_EQ(currency_at(period, kLongAgo), Currency::not_yet_valid);
    EXPECT_EQ(currency_at(period, {999}), Currency::not_yet_valid);
    EXPECT_EQ(currency_at(period, kBegin), Currency::current);
    EXPECT_EQ(currency_at(period, {1'999}), Currency::current);
    EXPECT_EQ(currency_at(period, kEnd), Currency::expired);
    EXPECT_EQ(currency_at(period, kLate), Currency::expired);
}

TEST(ValidPeriod, IsOpenWhereNothingIsStated) {
    for (const Time utc : {kLongAgo, Time{0}, kBegin, kEnd, kLate}) EXPECT_EQ(currency_at({}, utc), Currency::current);
    EXPECT_EQ(currency_at({kBegin, {}}, kLate), Currency::current);
    EXPECT_EQ(currency_at({kBegin, {}}, kLongAgo), Currency::not_yet_valid);
    EXPECT_EQ(currency_at({{}, kEnd}, kLongAgo), Currency::current);
    EXPECT_EQ(currency_at({{}, kEnd}, kLate), Currency::expired);
}

/// 1970 is an instant like others, and no sign of absence.
TEST(ValidPeriod, MayBeginOrEndWhenTimeBegins) {
    EXPECT_EQ(currency_at({Time{0}, {}}, {-1}), Currency::not_yet_valid);
    EXPECT_EQ(currency_at({{}, Time{0}}, {0}), Currency::expired);
}

/// The naive form: the end belongs to the period, and the instant 0 says that none is stated.
Currency closed_at(const ValidPeriod& period, Time utc) {
    if (period.begin && period.begin->ns != 0 && utc < *period.begin) return Currency::not_yet_valid;
    return period.end && period.end->ns != 0 && *period.end < utc ? Currency::expired : Currency::current;
}

TEST(ValidPeriod, AClosedOneIsCurrentForTooLong) {
    const struct {
        ValidPeriod period;
        Time utc;
        Currency truth;
    } instants[] = {{{kBegin, kEnd}, {999}, Currency::not_yet_valid}, {{kBegin, kEnd}, kBegin, Currency::current},
                    {{kBegin, kEnd}, {1'999}, Currency::current},     {{kBegin, kEnd}, kEnd, Currency::expired},
                    {{Time{0}, {}}, {-1}, Currency::not_yet_valid},   {{{}, Time{0}}, {0}, Currency::expired},
                    {{{}, Time{0}}, kLate, Currency::expired},        {{{}, kLate}, kLate, Currency::expired}};
    int wrong = 0, naive_wrong = 0;
    for (const auto& at : instants) {
        wrong += currency_at(at.period, at.utc) != at.truth ? 1 : 0;
        naive_wrong += closed_at(at.period, at.utc) != at.truth ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(naive_wrong, 5) << "control";
    test_support::record_worst("A67", wrong);
    test_support::record_control("A67", naive_wrong);
}

TEST(ValidPeriod, OneThatEndsBeforeItBeginsIsNeverCurrent) {
    for (const Time utc : {kLongAgo, kBegin, Time{1'500}, kEnd, kLate})
        EXPECT_EQ(currency_at({kEnd, kBegin}, utc), utc < kEnd ? Currency::not_yet_valid : Currency::expired);
}

}  // namespace
}  // namespace tedavis::base::test_valid_period
