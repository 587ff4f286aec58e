/// Writes one line to the event log when the picture first follows another phase:
///
///   phase approach.final of can: frame 12 of 45.123456 s
///
/// Before the first line the picture follows no phase, of no source. The source is that of flight::to_string(PhaseSource),
/// "+fault" behind it where the panel's pattern is impossible; the time is the monotonic clock's when that frame had been
/// presented.
///
/// Thread  one. Memory  none. It allocates nothing.
#pragma once

#include "render_core/flight/flight_phase.hpp"
#include "target/event_log.hpp"

namespace tedavis::target {

class PhaseEvents {
public:
    explicit PhaseEvents(const EventLog& log) : log_(log) {}

    /// `phase` is that of the frame number `frame`, which was presented at `presented`.
    void report(const flight::PhaseStatus& phase, std::uint64_t frame, base::Time presented);

private:
    const EventLog& log_;
    flight::PhaseStatus reported_;  ///< of no source, as before the first message
};

}  // namespace tedavis::target
