#include "render_core/base/utc_time.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <ctime>

namespace tedavis::base::test_utc_time {
namespace {

TEST(UtcTime, AgreesWithTheLibraryOnEveryDay) {
    for (std::int64_t s = 0; s < 7'258'118'400; s += 86400 + 3661) {  // to the end of 2199
        const std::time_t instant = s;
        std::tm parts{};
        gmtime_r(&instant, &parts);
        char text[32];
        std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
        Time time;
        ASSERT_TRUE(parse_utc(text, time)) << text;
        ASSERT_EQ(time.ns, s * 1'000'000'000) << text;
    }
}

TEST(UtcTime, WhatIsNoInstantIsRefusedAndChangesNothing) {
    for (const char* text :
         {"", "2026-06-01", "2026-06-01T14:00:00", "2026-06-01 14:00:00Z", "2026-06-01T14:00:00+", "x026-06-01T14:00:00Z",
          "2026-13-01T14:00:00Z", "2026-00-01T14:00:00Z", "2026-06-31T14:00:00Z", "2025-02-29T14:00:00Z", "2100-02-29T14:00:00Z",
          "2026-06-00T14:00:00Z", "2026-06-01T24:00:00Z", "2026-06-01T14:60:00Z", "2026-06-01T14:00:60Z", "1969-12-31T23:59:59Z",
          "2200-01-01T00:00:00Z", "2026-06-01T14:00:00Zz"}) {
        Time time{42};
        EXPECT_FALSE(parse_utc(text, time)) << text;
        EXPECT_EQ(time.ns, 42) << text;
    }
    Time time{42};
    EXPECT_TRUE(parse_utc("2024-02-29T14:00:00Z", time)) << "control";
}

TEST(UtcTime, DatesThatTheCalendarHasNotAreRefused) {
    std::int64_t days = 42;
    EXPECT_TRUE(days_to_date(1970, 1, 2, days));
    EXPECT_EQ(days, 1);
    EXPECT_TRUE(days_to_date(2000, 2, 29, days));
    EXPECT_EQ(days, 11016);
    for (const auto& [year, month, day] :
         {std::array{2100, 2, 29}, {1969, 12, 31}, {2200, 1, 1}, {2026, 0, 1}, {2026, 13, 1}, {2026, 4, 31}, {2026, 4, 0}}) {
        EXPECT_FALSE(days_to_date(year, month, day, days)) << year << '-' << month << '-' << day;
        EXPECT_EQ(days, 11016);
    }
}

TEST(CanBeUtc, ACenturyOfIt) {
    Time first, last;
    ASSERT_TRUE(parse_utc("2000-01-01T00:00:00Z", first) && parse_utc("2100-01-01T00:00:00Z", last));
    EXPECT_TRUE(can_be_utc(first) && can_be_utc(last));
    EXPECT_FALSE(can_be_utc(Time{first.ns - 1}) || can_be_utc(Time{last.ns + 1}) || can_be_utc(Time{0}));
}

}  // namespace
}  // namespace tedavis::base::test_utc_time
