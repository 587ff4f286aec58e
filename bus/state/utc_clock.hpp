/// Derives UTC from the messages 1200 (time of day, whole seconds) and 1206 (date), which arrive separately and may be wrong.
///
/// UTC is the source's time plus an offset. The clock starts when a time of day and a date surely belong to the same day, that
/// is, not within kMidnight of midnight. From then on the date follows from the clock. Senders truncate to whole seconds, so
/// the largest offset seen is the best estimate, with kTransport as the transport delay; UTC is late by at most one second. A
/// time of day that differs by more than kSlack, or another date, is rejected and does not confirm the clock. When kDoubts
/// rejected values in a row agree with each other, the sender's clock was set: a step of up to kSmallStep is followed; after a
/// larger step or another date the clock restarts. A leap second (23:59:60) is the next day's first second, as in POSIX time.
///
/// Thread  one. Memory  fixed, trivially copyable. Failure  dates that do not exist, or lie before 2000 or after 2099, are
/// ignored: receivers without a fix send them.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "render_core/flight/flight_time.hpp"

namespace tedavis::bus {

class UtcClock {
public:
    static constexpr base::Duration kTransport = base::Duration::milliseconds(1);  ///< delay before and on the bus
    static constexpr base::Duration kSlack = base::Duration::milliseconds(1500);
    static constexpr base::Duration kMidnight = base::Duration::seconds(5);
    static constexpr base::Duration kSmallStep = base::Duration::seconds(60);
    static constexpr std::uint8_t kDoubts = 3;

    /// UTC is lost when it has not been confirmed for longer than `timeout`.
    explicit UtcClock(base::Duration timeout) : timeout_(timeout) {}

    /// Hour 0..23, minute 0..59, second 0..60; others are ignored.
    void take_time(const std::array<std::uint8_t, 3>& time_of_day, base::Time received);
    /// Month 1..12.
    void take_date(int year, int month, int day, base::Time received);
    [[nodiscard]] flight::UtcEstimate estimate(base::Time now) const;

private:
    struct Stated {
        base::Duration value;  ///< since midnight, or since 1970
        base::Time received;
        bool is_there = false;
    };
    struct Doubt {
        base::Duration error;
        std::uint8_t count = 0;
    };
    void follow(base::Duration error);
    void doubt(base::Duration error);
    void begin_anew();
    void try_to_begin();

    base::Duration timeout_;
    Stated time_, date_;
    base::Duration ahead_;
    base::Time confirmed_;
    Doubt time_doubt_;
    std::uint8_t date_doubts_ = 0;
    bool is_known_ = false, is_running_ = false;
};
static_assert(std::is_trivially_copyable_v<UtcClock>);

}  // namespace tedavis::bus
