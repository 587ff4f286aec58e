#include "host_sim/calendar_time.hpp"

#include <gtest/gtest.h>
#include <time.h>

namespace tedavis::host_sim::test_calendar_time {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

// Oracle: the C library's own calendar.
TEST(CalendarTime, AgreesWithTheSystemCalendar) {
    for (std::int64_t second = -2'200'000'000; second < 7'200'000'000; second += 7'654'321) {
        const time_t instant = static_cast<time_t>(second);
        struct tm expected {};
        gmtime_r(&instant, &expected);
        const CalendarDate date = calendar_date({second * kSecond + 999'999'999});
        ASSERT_EQ(date.year, expected.tm_year + 1900) << second;
        ASSERT_EQ(date.month, expected.tm_mon + 1) << second;
        ASSERT_EQ(date.day, expected.tm_mday) << second;
        ASSERT_EQ(date.second_of_day, expected.tm_hour * 3600 + expected.tm_min * 60 + expected.tm_sec) << second;
        ASSERT_EQ(midnight_of(date.year, date.month, date.day)->ns, (second - date.second_of_day) * kSecond);
    }
}

TEST(CalendarTime, InstantsAreWrittenAsTheyAreRead) {
    for (const char* const text : {"2026-06-01T14:00:07Z", "1970-01-01T00:00:00Z", "2024-02-29T23:59:59Z"})
        EXPECT_EQ(utc_text(parse_iso8601(text).value()), text);
    EXPECT_EQ(utc_text({kSecond - 1}), "1970-01-01T00:00:00Z") << "a second is not rounded up";
    EXPECT_GT(utc_now(), "2026") << "not before this was written";
}

TEST(CalendarTime, KnowsWhichDaysExist) {
    EXPECT_TRUE(midnight_of(2000, 2, 29));
    EXPECT_FALSE(midnight_of(1900, 2, 29));
    EXPECT_FALSE(midnight_of(2023, 2, 29));
    EXPECT_FALSE(midnight_of(2024, 4, 31));
    EXPECT_FALSE(midnight_of(2024, 13, 1));
    EXPECT_FALSE(midnight_of(2024, 0, 1));
    EXPECT_FALSE(midnight_of(2024, 1, 0));
}

TEST(CalendarTime, ReadsIso8601) {
    EXPECT_EQ(parse_iso8601("1970-01-01T00:00:00Z")->ns, 0);
    EXPECT_EQ(parse_iso8601("2020-04-12T09:47:00Z")->ns, 1586684820 * kSecond);
    EXPECT_EQ(parse_iso8601("2020-04-12T11:47:00+02:00")->ns, 1586684820 * kSecond);
    EXPECT_EQ(parse_iso8601("2020-04-12T07:17:00-0230")->ns, 1586684820 * kSecond);
    EXPECT_EQ(parse_iso8601("2020-04-12 09:47:00.25")->ns, 1586684820 * kSecond + 250'000'000);
    EXPECT_EQ(parse_iso8601("2020-04-12T09:47:00.1234567891Z")->ns, 1586684820 * kSecond + 123'456'789);
}

TEST(CalendarTime, ReadsSecondsToTheNanosecond) {
    EXPECT_EQ(parse_unix_seconds("1586684820.123456789")->ns, 1586684820'123'456'789);
    EXPECT_EQ(parse_unix_seconds("1586684820")->ns, 1586684820 * kSecond);
    EXPECT_EQ(parse_unix_seconds("-1.5")->ns, -1'500'000'000);
    EXPECT_EQ(parse_unix_seconds("0.")->ns, 0);
    for (const char* text : {"", "-", ".5", "1e9", "12s", "1.5.2", "99999999999999999999", "nan"})
        EXPECT_FALSE(parse_unix_seconds(text)) << text;
}

TEST(CalendarTime, RefusesWhatIsNoTime) {
    for (const char* text : {"", "2020", "2020-04-12", "2020-04-31T00:00:00Z", "2020-04-12T24:00:00Z", "2020-04-12T09:60:00Z",
                             "2020-04-12T09:47:00X", "2020-04-12T09:47:00Zrest", "12.04.2020 09:47:00", "1586684820"}) {
        EXPECT_FALSE(parse_iso8601(text)) << text;
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_calendar_time
