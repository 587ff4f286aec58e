#include "platform/configuration/utc_day.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

namespace tedavis::platform::test_utc_day {
namespace {

/// Against the C library's calendar.
TEST(UtcDay, DaysAreThoseOfTheCalendar) {
    for (std::int64_t day = 0; day < 84'000; ++day) {
        const std::time_t time = day * 86'400;
        std::tm parts{};
        gmtime_r(&time, &parts);
        char text[40];
        std::snprintf(text, sizeof text, "%04d-%02d-%02d", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
        ASSERT_EQ(day_of(day * 86'400'000'000'000).view(), text);
        ASSERT_EQ(day_of(day * 86'400'000'000'000 + 86'399'999'999'999).view(), text);
        ASSERT_TRUE(is_day(text)) << text;
        ASSERT_EQ(start_of_day(text).ns, day * 86'400'000'000'000) << text;
    }
    for (const char* wrong : {"", "2026-13-01", "2026-00-01", "2026-04-31", "2026-02-29", "2100-02-29", "2026-1-01", "2026-01-00",
                              "2026/01/01", "x026-01-01", "2026-01-01 ", "1969-12-31", "2200-01-01", "0000-01-01", "2026-99-99"})
        EXPECT_FALSE(is_day(wrong)) << wrong;
}

}  // namespace
}  // namespace tedavis::platform::test_utc_day
