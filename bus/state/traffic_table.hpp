/// Other aircraft out of the messages that report them (canaerospace/traffic_profile.hpp): a fixed number of the newest reports.
///
/// A report is taken when all its parts have come: with one number, node and message code, within kWindow of the first. A part
/// with the next code begins another report, and what was there of the one before is dropped; a part that was there, or with an
/// older code, is a repetition; after `sender_timeout` of silence, or from another node, any code begins anew. One implausible
/// part refuses the whole report. Its time is that of its first part less the age that it states. A report that is older than the
/// aircraft's last one is refused.
///
/// With kMaxTraffic aircraft the table is full, and the farthest from the own ship, the new one among them, has no room. While
/// nobody knows where the own ship is, the new one has none. Places of those without a report for kTrafficKept are free.
///
/// Thread  one. Memory  fixed, trivially copyable. Failure  none; what is not taken is counted.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "bus/canaerospace/message_decoder.hpp"
#include "bus/canaerospace/traffic_profile.hpp"
#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::bus {

struct TrafficCounts {
    std::uint64_t reports = 0;     ///< taken
    std::uint64_t incomplete = 0;  ///< reports of which parts are missing
    std::uint64_t repeated = 0;    ///< messages
    std::uint64_t refused = 0;     ///< reports with an implausible part, and messages with an impossible number
    std::uint64_t outdated = 0;    ///< reports older than the aircraft's last one
    std::uint64_t no_room = 0;     ///< reports that the full table refused, or gave up for a nearer aircraft
};

class TrafficTable {
public:
    static constexpr base::Duration kWindow = base::Duration::milliseconds(500);
    static constexpr base::Duration kCutIsSaid = base::Duration::seconds(10);  ///< after the last report without room

    explicit TrafficTable(const BusSettings& settings)
        : is_carried_(settings.traffic.is_carried()), sender_timeout_(settings.dialect.sender_timeout) {}

    /// A message of the kind traffic. `own_ship` is needed where there is no room.
    void take(const DecodedMessage& message, TrafficPart part, base::Time received, const flight::OwnShipEstimate& own_ship);
    [[nodiscard]] bool has_room(base::Time now) const;
    [[nodiscard]] flight::Traffic estimate(base::Time now) const;
    [[nodiscard]] const TrafficCounts& counts() const { return counts_; }

private:
    struct Assembly {
        TrafficNumbers numbers{};
        base::Time begun;
        std::uint16_t parts = 0;  ///< bit n: part n is there; 0: never begun
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
