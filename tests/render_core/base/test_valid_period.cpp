#include "render_core/base/valid_period.hpp"

#include <gtest/gtest.h>

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

TEST(ValidPeriod, OneThatEndsBeforeItBeginsIsNeverCurrent) {
    for (const Time utc : {kLongAgo, kBegin, Time{1'500}, kEnd, kLate})
        EXPECT_EQ(currency_at({kEnd, kBegin}, utc), utc < kEnd ? Currency::not_yet_valid : Currency::expired);
}

}  // namespace
}  // namespace tedavis::base::test_valid_period
