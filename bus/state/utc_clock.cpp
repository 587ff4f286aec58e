#include "bus/state/utc_clock.hpp"

#include "render_core/base/utc_time.hpp"

namespace tedavis::bus {
namespace {

using base::Duration;

constexpr Duration kDay = Duration::seconds(86'400);

Duration within_day(Duration time) {
    const std::int64_t rest = time.ns % kDay.ns;
    return {rest < 0 ? rest + kDay.ns : rest};
}

/// Between two times of day, the shorter way round.
Duration difference(Duration a, Duration b) {
    const Duration apart = within_day(a - b);
    return apart > Duration{kDay.ns / 2} ? apart - kDay : apart;
}

bool is_within(Duration value, Duration limit) { return value <= limit && Duration{} - value <= limit; }

bool is_near_midnight(Duration of_day) { return of_day < UtcClock::kMidnight || of_day > kDay - UtcClock::kMidnight; }

}  // namespace

void UtcClock::take_time(const std::array<std::uint8_t, 3>& time_of_day, base::Time received) {
    if (time_of_day[0] > 23 || time_of_day[1] > 59 || time_of_day[2] > 60) return;
    time_ = {Duration::seconds(3600 * time_of_day[0] + 60 * time_of_day[1] + time_of_day[2]), received - kTransport, true};
    if (!is_running_) return try_to_begin();
    const Duration error = difference(time_.value, Duration{(time_.received + ahead_).ns});
    if (is_within(error, kSlack))
        follow(error);
    else
        doubt(error);
}

void UtcClock::follow(Duration error) {
    if (error > Duration{}) ahead_ = ahead_ + error;
    confirmed_ = time_.received;
    time_doubt_ = {};
}

void UtcClock::doubt(Duration error) {
    // A date from before the clock was set may be of the clock before.
    if (time_doubt_.count == 0) date_.is_there = false;
    const bool agrees = time_doubt_.count > 0 && is_within(error - time_doubt_.error, kSlack);
    time_doubt_ = {error, static_cast<std::uint8_t>(agrees ? time_doubt_.count + 1 : 1)};
    if (time_doubt_.count < kDoubts) return;
    if (!is_within(error, kSmallStep)) return begin_anew();
    ahead_ = ahead_ + error;
    follow({});
}

void UtcClock::take_date(int year, int month, int day, base::Time received) {
    std::int64_t days = 0;
    if (!base::days_to_date(year, month, day, days)) return;
    date_ = {Duration::seconds(days * 86'400), received - kTransport, true};
    if (!is_running_) return try_to_begin();
    const Duration utc{(date_.received + ahead_).ns}, of_day = within_day(utc);
    if (is_near_midnight(of_day)) return;
    date_doubts_ = date_.value == utc - of_day ? std::uint8_t{0} : static_cast<std::uint8_t>(date_doubts_ + 1);
    if (date_doubts_ == kDoubts) begin_anew();
}

void UtcClock::begin_anew() {
    is_running_ = false;
    time_doubt_ = {};
    date_doubts_ = 0;
    try_to_begin();
}

void UtcClock::try_to_begin() {
    if (!time_.is_there || !date_.is_there) return;
    const Duration when_dated = time_.value + (date_.received - time_.received);
    if (is_near_midnight(when_dated)) return;  // or of another day altogether
    const Duration ahead = date_.value + when_dated - Duration{date_.received.ns};
    if (!base::can_be_utc(time_.received + ahead)) return;
    ahead_ = ahead;
    confirmed_ = time_.received;
    is_known_ = is_running_ = true;
}

flight::UtcEstimate UtcClock::estimate(base::Time now) const {
    if (!is_known_) return {};
    const bool is_confirmed = is_running_ && is_within(now - confirmed_, timeout_);
    return {ahead_, is_confirmed ? base::SignalState::valid : base::SignalState::lost};
}

}  // namespace tedavis::bus
