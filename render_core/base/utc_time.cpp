#include "render_core/base/utc_time.hpp"

namespace tedavis::base {
namespace {

constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
constexpr Time kFirstUtc{946'684'800'000'000'000}, kLastUtc{4'102'444'800'000'000'000};
constexpr int kFirstYear = 1970, kLastYear = 2199;
constexpr int kDaysOfMonth[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool has_form(std::string_view text) {
    if (text.size() != kForm.size()) return false;
    for (std::size_t n = 0; n < kForm.size(); ++n)
        if (kForm[n] == '0' ? !is_digit(text[n]) : text[n] != kForm[n]) return false;
    return true;
}

int number_at(std::string_view text, std::size_t at, std::size_t digits) {
    int number = 0;
    for (std::size_t n = 0; n < digits; ++n) number = 10 * number + (text[at + n] - '0');
    return number;
}

bool is_leap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }
int days_of(int year, int month) { return kDaysOfMonth[month - 1] + (month == 2 && is_leap(year) ? 1 : 0); }

std::int64_t days_since_epoch(int year, int month, int day) {
    std::int64_t days = day - 1;
    for (int y = kFirstYear; y < year; ++y) days += is_leap(y) ? 366 : 365;
    for (int m = 1; m < month; ++m) days += days_of(year, m);
    return days;
}

}  // namespace

bool parse_utc(std::string_view text, Time& time) noexcept {
    if (!has_form(text)) return false;
    const int year = number_at(text, 0, 4), month = number_at(text, 5, 2), day = number_at(text, 8, 2);
    const int hour = number_at(text, 11, 2), minute = number_at(text, 14, 2), second = number_at(text, 17, 2);
    std::int64_t days = 0;
    if (hour > 23 || minute > 59 || second > 59 || !days_to_date(year, month, day, days)) return false;
    time = Time{} + Duration::seconds(days * 86400 + hour * 3600 + minute * 60 + second);
    return true;
}

bool days_to_date(int year, int month, int day, std::int64_t& days) noexcept {
    if (year < kFirstYear || year > kLastYear || month < 1 || month > 12 || day < 1 || day > days_of(year, month)) return false;
    days = days_since_epoch(year, month, day);
    return true;
}

bool can_be_utc(Time time) noexcept { return kFirstUtc <= time && time <= kLastUtc; }

}  // namespace tedavis::base
