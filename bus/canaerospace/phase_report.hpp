/// The flight phase that this display has, as a message for others on the bus: testers and recorders.
///
/// UCHAR4 {phase code (FlightPhase::code), source, faults, 0} on `report_identifier` of [phase] in the bus file. The source is 0
/// none, 1 held, 2 motion, 3 CAN, 4 switches; in faults bit 0 says that the panel has an impossible pattern or does not answer,
/// bit 1 that sources disagree. At most one display on a bus may use the identifier. The phase is the record's; the picture may
/// still follow the earlier one for a moment.
///
/// Pure: no clock, no socket. Thread one. Memory fixed, inside.
#pragma once

#include <optional>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/frame/can_frame.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::bus {

class PhaseReport {
public:
    explicit PhaseReport(const BusSettings& settings)
        : identifier_(settings.phase.report_identifier), node_(settings.node.node) {}

    /// Returns the message that is due at `now`, which must not decrease: the first one, one at each change of phase, source or
    /// faults, and one a second. Empty if the bus file asks for no report. Until sent() is called the same message stays due.
    [[nodiscard]] std::optional<CanFrame> due(const flight::PhaseStatus& status, base::Time now) const noexcept;
    /// To be called when the message that was due at `now` is on its way.
    void sent(const flight::PhaseStatus& status, base::Time now) noexcept;

private:
    std::uint16_t identifier_;
    std::uint8_t node_;
    std::uint8_t next_code_ = 0;
    bool has_sent_ = false;
    flight::PhaseStatus last_;
    base::Time last_at_;
};

}  // namespace tedavis::bus
