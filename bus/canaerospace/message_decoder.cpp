#include "bus/canaerospace/message_decoder.hpp"

#include <cmath>

namespace tedavis::bus {
namespace {

constexpr std::uint16_t kIdentificationRequest = 128;
constexpr std::uint8_t kRepeatsUntilUnnumbered = 3;
constexpr std::uint8_t kOldersUntilRestart = 3;
constexpr double kRoundingShare = 1e-4;  // of the plausible range

bool is_half(std::uint8_t type) {
    return type == static_cast<std::uint8_t>(DataType::double_high) || type == static_cast<std::uint8_t>(DataType::double_low);
}

bool is_identification_request(const CanFrame& frame, MessageId id) {
    const MessageHeader header = read_header(frame);
    return id.identifier == kIdentificationRequest && id.channel == 0 && header.data_type == 0 && header.service_code == 0;
}

}  // namespace

MessageDecoder::MessageDecoder(const BusSettings& settings)
    : dialect_(settings.dialect),
      phase_(settings.phase),
      traffic_(settings.traffic),
      guidance_(settings.guidance),
      display_(settings.display),
      messages_(settings.messages) {
    for (std::uint16_t i = 0; i < place_count(); ++i) bindings_[i] = bind(entry_at(i), dialect_);
}

DecodedMessage MessageDecoder::decode(const CanFrame& frame) {
    DecodedMessage message;
    const MessageId id = message_id(frame.id, frame.extended);
    if (frame.kind == FrameKind::data && frame.length >= kMessageHeaderBytes && id.valid &&
        id.channel < dialect_.redundancy_channels)
        message = decode_named(frame, id);
    ++(message.kind == MessageKind::alien ? counts_.alien : counts_.decoded);
    return message;
}

/// By what the bus file and the standard give its identifier to.
DecodedMessage MessageDecoder::decode_named(const CanFrame& frame, MessageId id) {
    if (id.identifier == phase_.status_identifier || id.identifier == phase_.request_identifier) {
        const bool request = id.identifier == phase_.request_identifier;
        const auto phase_place = static_cast<std::uint16_t>(kPhasePlace + (request ? 1 : 0));
        return decode_known(frame, id, phase_place, type_bit(DataType::uchar8x4));
    }
    if (display_.has(id.identifier))
        return decode_known(frame, id, kLegendPlace, type_bit(DataType::uchar8) | type_bit(DataType::nodata));
    if (const StatedMessage* const stated = find_message(messages_, id.identifier)) {
        const std::uint16_t place = place_of_signal(stated->signal);
        const std::uint32_t nothing = entry_at(place).types & type_bit(DataType::nodata);
        return decode_known(frame, id, place, type_bit(stated->type) | nothing);
    }
    if (const std::uint16_t place = place_of(id.identifier, guidance_); place != kNotInTable)
        return decode_entry(frame, id, place);
    if (traffic_.has(id.identifier)) return decode_traffic(frame, id);
    DecodedMessage message;
    if (is_identification_request(frame, id)) {
        message.kind = MessageKind::identification_request;
        message.header = read_header(frame);
    }
    return message;
}

/// A signal that a [[message]] of the bus file states has no other identifier.
DecodedMessage MessageDecoder::decode_entry(const CanFrame& frame, MessageId id, std::uint16_t place) {
    const IdentifierEntry& entry = entry_at(place);
    const bool is_known =
        (!entry.glider_profile || dialect_.glider_identifiers) && !is_stated(messages_, bindings_[place].signal);
    return is_known ? decode_known(frame, id, place, entry.types) : DecodedMessage();
}

DecodedMessage MessageDecoder::decode_known(const CanFrame& frame, MessageId id, std::uint16_t place, std::uint32_t types) {
    DecodedMessage message;
    message.header = read_header(frame);
    message.identifier = id.identifier;
    message.channel = id.channel;
    TypedValue value;
    const std::size_t payload = frame.length - kMessageHeaderBytes;
    const std::uint8_t type = message.header.data_type;
    if (!decode_value(type, frame.data.data() + kMessageHeaderBytes, payload, value) || (types & type_bit(value.type)) == 0)
        return message;
    if (value.type == DataType::long32 && !dialect_.accept_long_position && (types & type_bit(DataType::double_high)) != 0)
        return message;
    message.place = place;
    if (payload > type_layout(type).bytes) ++counts_.padded;
    Sender& sender = senders_[place][id.channel];
    if (!follows(sender, message.header, frame.time, message)) {
        ++counts_.repeated;
        message.kind = MessageKind::repeated;
        return message;
    }
    if (place == kLegendPlace) {
        finish_legend(value, message);
    } else if (place >= kPhasePlace) {
        message.kind = place == kPhasePlace ? MessageKind::phase : MessageKind::phase_request;
        finish_phase(value, message);
    } else {
        finish_entry(frame, value, sender, place, message);
    }
    return message;
}

/// Only channel 0: reports are assembled for one sender per number.
DecodedMessage MessageDecoder::decode_traffic(const CanFrame& frame, MessageId id) {
    DecodedMessage message;
    message.header = read_header(frame);
    message.identifier = id.identifier;
    message.traffic_part = static_cast<TrafficPart>(id.identifier - traffic_.first_identifier);
    TypedValue value;
    const std::size_t payload = frame.length - kMessageHeaderBytes;
    const std::uint8_t type = message.header.data_type;
    if (id.channel != 0 || !decode_value(type, frame.data.data() + kMessageHeaderBytes, payload, value) ||
        (traffic_part_entry(message.traffic_part).types & type_bit(value.type)) == 0)
        return message;
    message.kind = MessageKind::traffic;
    message.healthy = decode_traffic_part(message.traffic_part, value, message.value);
    if (!message.healthy) ++counts_.out_of_range;
    return message;
}

void MessageDecoder::finish_entry(const CanFrame& frame, const TypedValue& value, Sender& sender, std::uint16_t place,
                                  DecodedMessage& message) {
    const IdentifierEntry& entry = entry_at(place);
    message.signal = bindings_[place].signal;
    message.rank = bindings_[place].rank;
    message.kind = message.signal == flight::Signal::count_ ? MessageKind::known : MessageKind::signal;
    if (entry.unit == BusUnit::time_of_day || entry.unit == BusUnit::date) {
        message.kind = entry.unit == BusUnit::date ? MessageKind::date : MessageKind::utc;
        finish_clock(value, message);
        return;
    }
    double number = number_of(value);
    if (const StatedMessage* const stated = find_message(messages_, message.identifier)) {
        // In the unit of the table, so that sign, reference and range are those of the standard's identifier.
        number = (number * stated->factor + stated->offset) / std::fabs(bindings_[place].factor);
    } else if (is_half(message.header.data_type)) {
        if (!join_halves(sender, message.header, frame.time, static_cast<std::uint32_t>(value.parts[0]), number)) {
            message.kind = MessageKind::half;
            return;
        }
    } else if (value.type == DataType::long32 && is_position(entry)) {
        number *= kDegreesPerLongUnit;
    }
    if (!entry.service_code_is_index && status_invalid(message.header.service_code)) {
        ++counts_.stated_invalid;
        message.healthy = false;
        return;
    }
    message.nothing_selected = value.type == DataType::nodata;
    if (!message.nothing_selected) finish_number(number, place, message);
}

void MessageDecoder::finish_number(double number, std::uint16_t place, DecodedMessage& message) {
    const IdentifierEntry& entry = entry_at(place);
    const double factor = std::fabs(bindings_[place].factor);
    const double plain = number * factor;
    // A limit itself may come out a little beyond it (SHORT2 and FLOAT round): taken as the limit. A NaN fails the test.
    const double slack = kRoundingShare * (entry.high - entry.low);
    if (!(plain >= entry.low - slack && plain <= entry.high + slack)) {
        ++counts_.out_of_range;
        message.healthy = false;
        return;
    }
    if (plain < entry.low) number = entry.low / factor;
    if (plain > entry.high) number = entry.high / factor;
    message.value = to_si(bindings_[place], number);
    message.is_magnetic = bindings_[place].is_magnetic;
}

void MessageDecoder::finish_phase(const TypedValue& value, DecodedMessage& message) {
    const flight::ParsedPhase parsed = flight::phase_from_code(static_cast<std::uint8_t>(value.parts[0]));
    const bool confidence_good = value.parts[3] <= 100 || value.parts[3] == 255;
    message.phase_origin = static_cast<std::uint8_t>(value.parts[2]);
    if (message.header.service_code != 0) {
        ++counts_.stated_invalid;
        message.healthy = false;
    } else if (!parsed.ok || !confidence_good) {
        ++counts_.out_of_range;
        message.healthy = false;
        if (!parsed.ok && counts_.impossible_phases++ == 0)
            counts_.first_impossible_phase = static_cast<std::uint8_t>(value.parts[0]);
    } else {
        message.phase = parsed.phase;
        message.confidence = static_cast<std::uint8_t>(value.parts[3]);
    }
}

void MessageDecoder::finish_legend(const TypedValue& value, DecodedMessage& message) {
    message.kind = MessageKind::legend_request;
    message.nothing_selected = value.type == DataType::nodata;
    if (status_invalid(message.header.service_code)) {
        ++counts_.stated_invalid;
        message.healthy = false;
    } else if (!message.nothing_selected && value.parts[0] >= static_cast<std::int64_t>(flight::kLegendShowNames.size())) {
        ++counts_.out_of_range;
        message.healthy = false;
    } else if (!message.nothing_selected) {
        message.legend = static_cast<flight::LegendShow>(value.parts[0]);
    }
}

void MessageDecoder::finish_clock(const TypedValue& value, DecodedMessage& message) {
    std::array<std::int64_t, 4> parts = value.parts;
    bool good = false;
    if (message.kind == MessageKind::utc) {
        good = parts[0] >= 0 && parts[0] <= 23 && parts[1] >= 0 && parts[1] <= 59 && parts[2] >= 0 && parts[2] <= 60;
    } else {
        if (dialect_.month_from_zero) ++parts[1];
        good = value.count == 4 && parts[0] >= 1 && parts[0] <= 31 && parts[1] >= 1 && parts[1] <= 12 && parts[2] >= 0 &&
               parts[2] <= 99 && parts[3] >= 0 && parts[3] <= 99;
    }
    if (status_invalid(message.header.service_code)) {
        ++counts_.stated_invalid;
        good = false;
    } else if (!good) {
        ++counts_.out_of_range;
    }
    message.healthy = good;
    for (std::size_t i = 0; good && i < 4; ++i) message.clock[i] = static_cast<std::uint8_t>(parts[i]);
}

bool MessageDecoder::status_invalid(std::uint8_t service_code) const {
    return service_code != 0 && dialect_.service_code == ServiceCodeMeaning::invalid;
}

/// Decides whether this message is news, and keeps account of gaps and restarts.
bool MessageDecoder::follows(Sender& sender, const MessageHeader& header, base::Time time, DecodedMessage& message) {
    const base::Duration silence = time - sender.last;
    const bool resumed = silence > dialect_.sender_timeout || base::Duration{} - silence > dialect_.sender_timeout;
    bool restarted = !sender.seen || resumed || header.node != sender.node;
    if (!restarted && !step_on(sender, header.message_code, restarted)) return false;
    if (restarted) {
        if (sender.seen) ++counts_.restarts;
        sender = Sender();
    }
    sender.seen = true;
    sender.older_codes = 0;
    sender.node = header.node;
    sender.code = header.message_code;
    sender.last = time;
    message.restarted = restarted;
    message.numbered = sender.numbered;
    return true;
}

/// Compares a message code with the one before; false for a duplicate or an older message.
bool MessageDecoder::step_on(Sender& sender, std::uint8_t code, bool& restarted) {
    const int step = code_step(code, sender.code);
    if (step == 0) {
        if (sender.same_codes < kRepeatsUntilUnnumbered && ++sender.same_codes < kRepeatsUntilUnnumbered) return false;
        sender.numbered = false;
        return true;
    }
    if (step < 0) {
        restarted = ++sender.older_codes >= kOldersUntilRestart;
        return restarted;
    }
    if (sender.numbered) counts_.lost += static_cast<std::uint64_t>(step - 1);
    sender.numbered = true;
    sender.same_codes = 0;
    return true;
}

/// True with the number when this half completes a pair; otherwise it waits for the other.
bool MessageDecoder::join_halves(Sender& sender, const MessageHeader& header, base::Time time, std::uint32_t bits,
                                 double& number) {
    const int step = code_step(header.message_code, sender.half_code);
    const bool adjacent = sender.half_type != 0 && sender.half_type != header.data_type && (step == 1 || !sender.numbered);
    const base::Duration apart = time - sender.half_time;
    if (adjacent && apart <= dialect_.pair_window && base::Duration{} - apart <= dialect_.pair_window) {
        const bool high_came_first = sender.half_type == static_cast<std::uint8_t>(DataType::double_high);
        number = high_came_first ? double_from_halves(sender.half_bits, bits) : double_from_halves(bits, sender.half_bits);
        sender.half_type = 0;
        return true;
    }
    if (sender.half_type != 0) ++counts_.halves_dropped;
    sender.half_type = header.data_type;
    sender.half_code = header.message_code;
    sender.half_time = time;
    sender.half_bits = bits;
    return false;
}

}  // namespace tedavis::bus
