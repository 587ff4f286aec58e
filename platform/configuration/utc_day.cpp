#include "platform/configuration/utc_day.hpp"

#include <cstddef>

#include "render_core/base/check.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/utc_time.hpp"

namespace tedavis::platform {
namespace {

// Eras of 400 years begin in March, and so does a year of this count.
constexpr std::int64_t kToEra = 719'468, kEraDays = 146'097;

void append_padded(DayText& text, std::int64_t number, std::size_t width) {
    const auto digits = base::digits(static_cast<std::uint64_t>(number));
    for (std::size_t n = digits.size(); n < width; ++n) text.append("0");
    text.append(digits.view());
}

bool read_day(std::string_view day, base::Time& start) {
    DayText text(day);
    base::FixedString<20> instant(text.view());
    instant.append("T00:00:00Z");
    return day.size() == 10 && base::parse_utc(instant.view(), start);
}

}  // namespace

bool is_day(std::string_view text) {
    base::Time start;
    return read_day(text, start);
}

DayText day_of(std::int64_t unix_ns) {
    const std::int64_t days = (unix_ns >= 0 ? unix_ns : unix_ns - kUtcDay.ns + 1) / kUtcDay.ns + kToEra;
    const std::int64_t era = days / kEraDays, of_era = days - era * kEraDays;
    const std::int64_t year = (of_era - of_era / 1460 + of_era / 36'524 - of_era / 146'096) / 365;
    const std::int64_t of_year = of_era - (365 * year + year / 4 - year / 100);
    const std::int64_t from_march = (5 * of_year + 2) / 153, month = from_march < 10 ? from_march + 3 : from_march - 9;
    DayText text;
    append_padded(text, year + era * 400 + (month <= 2 ? 1 : 0), 4);
    text.append("-");
    append_padded(text, month, 2);
    text.append("-");
    append_padded(text, of_year - (153 * from_march + 2) / 5 + 1, 2);
    return text;
}

base::Time start_of_day(std::string_view day) {
    base::Time start;
    TEDAVIS_CHECK(read_day(day, start));
    return start;
}

}  // namespace tedavis::platform
