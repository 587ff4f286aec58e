/// Decodes CANaerospace messages into SI values: headers, types, pairs of DOUBLE halves, message codes, plausibility.
///
/// Only identifiers of the table with a data type that the table allows are decoded; all other frames only change counters.
/// Frames longer than their type needs (from senders that pad to eight bytes) are decoded and counted.
///
/// Message codes: a repeated or older code of one identifier and channel marks a duplicate, which is dropped. Gaps are counted
/// as lost messages. The sender counts as restarted after `sender_timeout` of silence, when the node changes, or at the third
/// older code in a row. A code that never changes means that the sender does not number its messages.
///
/// Thread  one. Memory  fixed, inside; trivially copyable, so that a copy is a checkpoint. Failure  counted by kind.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/canaerospace/identifier_table.hpp"
#include "bus/canaerospace/message_header.hpp"
#include "bus/canaerospace/traffic_profile.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::bus {

enum class MessageKind : std::uint8_t {
    alien,     ///< not CANaerospace, or not an identifier of the table
    repeated,  ///< duplicate or older message
    half,      ///< first half of a DOUBLE
    known,     ///< in the table but not a signal of the core; the value is decoded
    signal,
    phase,
    phase_request,
    legend_request,
    traffic,  ///< one part of a report on another aircraft; `value` is that of decode_traffic_part()
    utc,
    date,
    identification_request,
};

struct DecodedMessage {
    MessageKind kind = MessageKind::alien;
    MessageHeader header;
    std::uint16_t identifier = 0;
    std::uint16_t place = kNotInTable;  ///< of the identifier that states the value, in the table
    std::uint8_t channel = 0;
    bool restarted = false;         ///< first message of a sender after start, silence or restart
    bool numbered = true;           ///< false: the sender does not number its messages
    bool nothing_selected = false;  ///< guidance: the sender states that there is no value; legend: no request
    bool is_magnetic = false;       ///< `value` is a direction relative to magnetic north
    bool healthy = true;            ///< false: the sender states invalid, or the value is implausible (`value` is then not set)
    flight::Signal signal = flight::Signal::count_;
    std::uint8_t rank = 0;
    double value = 0;  ///< SI
    TrafficPart traffic_part = TrafficPart::count;
    flight::FlightPhase phase;                            ///< of phase messages
    std::uint8_t phase_origin = 0;                        ///< 0 unknown, 1 FMS, 2 pilot, 3 computed, 4 simulator
    std::uint8_t confidence = 255;                        ///< percent, 255 not stated
    flight::LegendShow legend = flight::LegendShow::key;  ///< of a legend request
    std::array<std::uint8_t, 4> clock{};                  ///< utc: h, m, s, 0; date: day, month 1..12, year / 100, year % 100
};

struct DecoderCounts {
    std::uint64_t decoded = 0;
    std::uint64_t alien = 0;
    std::uint64_t repeated = 0;
    std::uint64_t lost = 0;  ///< messages missing by message code
    std::uint64_t restarts = 0;
    std::uint64_t padded = 0;
    std::uint64_t halves_dropped = 0;
    std::uint64_t out_of_range = 0;  ///< refused values: implausible, not a number, or an impossible code
    std::uint64_t stated_invalid = 0;
    std::uint64_t impossible_phases = 0;      ///< phase messages with an unknown code; also counted in out_of_range
    std::uint8_t first_impossible_phase = 0;  ///< the code of the first
};

class MessageDecoder {
public:
    explicit MessageDecoder(const BusSettings& settings);

    [[nodiscard]] DecodedMessage decode(const CanFrame& frame);
    [[nodiscard]] const DecoderCounts& counts() const { return counts_; }

private:
    struct Sender {
        base::Time last;
        base::Time half_time;
        std::uint32_t half_bits = 0;
        std::uint8_t half_type = 0;  // 0: no half is pending
        std::uint8_t half_code = 0;
        std::uint8_t node = 0;
        std::uint8_t code = 0;
        std::uint8_t same_codes = 0;
        std::uint8_t older_codes = 0;
        bool seen = false;
        bool numbered = true;
    };
    static constexpr std::uint16_t kPhasePlace = kMaxPlaces;
    static constexpr std::uint16_t kLegendPlace = kPhasePlace + 2;
    static constexpr std::size_t kMaxEntries = std::size_t{kPhasePlace} + 3;

    DecodedMessage decode_named(const CanFrame& frame, MessageId id);
    DecodedMessage decode_entry(const CanFrame& frame, MessageId id, std::uint16_t place);
    DecodedMessage decode_known(const CanFrame& frame, MessageId id, std::uint16_t place, std::uint32_t types);
    DecodedMessage decode_traffic(const CanFrame& frame, MessageId id);
    void finish_entry(const CanFrame& frame, const TypedValue& value, Sender& sender, std::uint16_t place,
                      DecodedMessage& message);
    void finish_phase(const TypedValue& value, DecodedMessage& message);
    void finish_legend(const TypedValue& value, DecodedMessage& message);
    void finish_clock(const TypedValue& value, DecodedMessage& message);
    void finish_number(double number, std::uint16_t place, DecodedMessage& message);
    [[nodiscard]] bool follows(Sender& sender, const MessageHeader& header, base::Time time, DecodedMessage& message);
    [[nodiscard]] bool step_on(Sender& sender, std::uint8_t code, bool& restarted);
    [[nodiscard]] bool join_halves(Sender& sender, const MessageHeader& header, base::Time time, std::uint32_t bits,
                                   double& number);
    [[nodiscard]] bool status_invalid(std::uint8_t service_code) const;

    BusDialect dialect_;
    PhaseMessageSettings phase_;
    TrafficSettings traffic_;
    GuidanceSettings guidance_;
    DisplayRequestSettings display_;
    StatedMessages messages_;
    DecoderCounts counts_;
    std::array<SignalBinding, kMaxEntries> bindings_{};
    std::array<std::array<Sender, kMaxRedundancyChannels>, kMaxEntries> senders_{};
};
static_assert(std::is_trivially_copyable_v<MessageDecoder>);

}  // namespace tedavis::bus
