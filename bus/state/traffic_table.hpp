/// Assembles reports of other aircraft from their messages (canaerospace/traffic_profile.hpp) and keeps the newest report of
/// each of up to kMaxTraffic aircraft.
///
/// A report is complete when all its parts have arrived within kWindow of the first, with the same number, node and message
/// code. A part with a later code begins another report and drops an incomplete one; a part that is already there, or has an
/// older code, counts as repeated. After `sender_timeout` of silence, or from another node, any code begins a new report. One
/// implausible part invalidates the whole report. The time of a report is the receive time of its first part minus the age that
/// it states. A report older than the aircraft's last one is refused.
///
/// When the table is full, the aircraft farthest from the own ship, which may be the new one, is left out; while the own ship's
/// position is unknown, the new one is left out. An entry without a report for kTrafficKept is free.
///
/// Thread  one. Memory  fixed, trivially copyable. Failure  none; reports that are not kept are counted.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "bus/canaerospace/message_decoder.hpp"
#include "bus/canaerospace/traffic_profile.hpp"
#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::bus {

struct TrafficCounts {
    std::uint64_t reports = 0;     ///< kept
    std::uint64_t incomplete = 0;  ///< reports with missing parts
    std::uint64_t repeated = 0;    ///< messages
    std::uint64_t refused = 0;     ///< reports with an implausible part, and messages with an impossible number
    std::uint64_t outdated = 0;    ///< reports older than the aircraft's last one
    std::uint64_t no_room = 0;     ///< reports that the full table refused, or replaced by a nearer aircraft's
};

class TrafficTable {
public:
    static constexpr base::Duration kWindow = base::Duration::milliseconds(500);
    static constexpr base::Duration kCutIsSaid =
        base::Duration::seconds(10);  ///< `is_cut` holds this long after a report had no room

    explicit TrafficTable(const BusSettings& settings)
        : is_carried_(settings.traffic.is_carried()), sender_timeout_(settings.dialect.sender_timeout) {}

    /// Takes a message of the kind `traffic`. `own_ship` decides which aircraft is left out of a full table.
    void take(const DecodedMessage& message, TrafficPart part, base::Time received, const flight::OwnShipEstimate& own_ship);
    [[nodiscard]] bool has_room(base::Time now) const;
    [[nodiscard]] flight::Traffic estimate(base::Time now) const;
    [[nodiscard]] const TrafficCounts& counts() const { return counts_; }

private:
    struct Assembly {
        TrafficNumbers numbers{};
        base::Time begun;
        std::uint16_t parts = 0;  ///< bit n: part n has arrived; 0: never begun
        std::uint8_t node = 0, code = 0;
        bool is_refused = false;
    };
    using Places = std::array<flight::TrafficReport, flight::kMaxTraffic>;

    [[nodiscard]] bool begins(const Assembly& assembly, const MessageHeader& header, base::Time received) const;
    void keep(const flight::TrafficReport& report, base::Time received, const flight::OwnShipEstimate& own_ship);
    [[nodiscard]] std::size_t place_for(const flight::TrafficReport& report, base::Time received,
                                        const flight::OwnShipEstimate& own_ship);
    [[nodiscard]] std::size_t farthest_but(const flight::TrafficReport& report, const flight::OwnShipEstimate& own_ship) const;

    bool is_carried_;
    base::Duration sender_timeout_;
    std::array<Assembly, kTrafficNumbers> assemblies_{};
    Places places_{};  ///< address 0: free
    base::Time cut_at_;
    TrafficCounts counts_;
};
static_assert(std::is_trivially_copyable_v<TrafficTable>);

}  // namespace tedavis::bus
