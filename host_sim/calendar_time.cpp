#include "host_sim/calendar_time.hpp"

#include <cctype>
#include <chrono>
#include <cstdint>
#include <cstdio>

namespace tedavis::host_sim {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000, kMaxSeconds = 7'000'000'000;
constexpr int kDaysOfMonth[12] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};

bool is_leap_year(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

int days_of(int year, int month) { return kDaysOfMonth[month - 1] + (month == 2 && is_leap_year(year) ? 1 : 0); }

/// Reads fixed-width fields from the front of a text.
class FieldReader {
public:
    explicit FieldReader(std::string_view text) : text_(text) {}

    int digits(std::size_t count) {
        int value = 0;
        if (text_.size() < count) ok_ = false;
        for (std::size_t i = 0; ok_ && i < count; ++i) {
            if (std::isdigit(static_cast<unsigned char>(text_[i])) == 0) ok_ = false;
            value = value * 10 + (text_[i] - '0');
        }
        if (ok_) text_.remove_prefix(count);
        return ok_ ? value : 0;
    }
    bool accept(char c) {
        if (!ok_ || text_.empty() || text_.front() != c) return false;
        text_.remove_prefix(1);
        return true;
    }
    void expect(char c) { ok_ = accept(c) && ok_; }
    /// Digits after a decimal point as nanoseconds; more than nine are cut.
    std::int64_t fraction_ns() {
        std::int64_t value = 0, scale = 100'000'000;
        while (!text_.empty() && std::isdigit(static_cast<unsigned char>(text_.front())) != 0) {
            value += (text_.front() - '0') * scale;
            scale /= 10;
            text_.remove_prefix(1);
        }
        return value;
    }
    [[nodiscard]] bool ok() const { return ok_; }
    [[nodiscard]] bool at_end() const { return text_.empty(); }

private:
    std::string_view text_;
    bool ok_ = true;
};

/// Seconds east of UTC; zero for "Z" or nothing.
int zone_offset_s(FieldReader& reader) {
    if (reader.accept('Z') || reader.at_end()) return 0;
    const int sign = reader.accept('-') ? -1 : 1;
    if (sign > 0) reader.expect('+');
    const int hours = reader.digits(2);
    reader.accept(':');
    return sign * (hours * 3600 + reader.digits(2) * 60);
}

}  // namespace

std::optional<base::Time> midnight_of(int year, int month, int day) {
    if (year < 1900 || year > 2199 || month < 1 || month > 12 || day < 1 || day > days_of(year, month)) return std::nullopt;
    std::int64_t days = 0;
    for (int y = 1970; y < year; ++y) days += is_leap_year(y) ? 366 : 365;
    for (int y = year; y < 1970; ++y) days -= is_leap_year(y) ? 366 : 365;
    for (int m = 1; m < month; ++m) days += days_of(year, m);
    return base::Time{} + base::Duration::seconds((days + day - 1) * base::kSecondsPerDay);
}

CalendarDate calendar_date(base::Time time) {
    const std::int64_t second = time.ns / kNanosecondsPerSecond - (time.ns % kNanosecondsPerSecond < 0 ? 1 : 0);
    std::int64_t days = second / base::kSecondsPerDay - (second % base::kSecondsPerDay < 0 ? 1 : 0);
    CalendarDate date;
    date.second_of_day = static_cast<int>(second - days * base::kSecondsPerDay);
    while (days < 0) days += is_leap_year(--date.year) ? 366 : 365;
    while (days >= (is_leap_year(date.year) ? 366 : 365)) days -= is_leap_year(date.year++) ? 366 : 365;
    while (days >= days_of(date.year, date.month)) days -= days_of(date.year, date.month++);
    date.day = static_cast<int>(days) + 1;
    return date;
}

std::string utc_text(base::Time time) {
    const CalendarDate date = calendar_date(time);
    char text[32];
    std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02dZ", date.year, date.month, date.day, date.second_of_day / 3600,
                  date.second_of_day / 60 % 60, date.second_of_day % 60);
    return text;
}

std::string utc_now() {
    const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
    return utc_text({std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count()});
}

std::optional<base::Time> parse_iso8601(std::string_view text) {
    FieldReader reader(text);
    const int year = reader.digits(4);
    reader.expect('-');
    const int month = reader.digits(2);
    reader.expect('-');
    const int day = reader.digits(2);
    if (!reader.accept('T')) reader.expect(' ');
    const int hour = reader.digits(2);
    reader.expect(':');
    const int minute = reader.digits(2);
    reader.expect(':');
    const int second = reader.digits(2);
    const std::int64_t fraction = reader.accept('.') ? reader.fraction_ns() : 0;
    const int offset_s = reader.ok() ? zone_offset_s(reader) : 0;
    const auto midnight = midnight_of(year, month, day);
    if (!reader.ok() || !reader.at_end() || !midnight || hour > 23 || minute > 59 || second > 60) return std::nullopt;
    return *midnight + base::Duration::seconds(hour * 3600 + minute * 60 + second - offset_s) + base::Duration{fraction};
}

std::optional<base::Time> parse_unix_seconds(std::string_view text) {
    FieldReader reader(text);
    const bool negative = reader.accept('-');
    std::int64_t seconds = reader.digits(1);
    while (reader.ok() && !reader.at_end() && !reader.accept('.')) {
        seconds = seconds * 10 + reader.digits(1);
        if (seconds > kMaxSeconds) return std::nullopt;
    }
    const std::int64_t ns = seconds * kNanosecondsPerSecond + reader.fraction_ns();
    if (!reader.ok() || !reader.at_end()) return std::nullopt;
    return base::Time{negative ? -ns : ns};
}

}  // namespace tedavis::host_sim
