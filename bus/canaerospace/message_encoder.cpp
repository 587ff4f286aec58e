#include "bus/canaerospace/message_encoder.hpp"

#include <cmath>

#include "bus/canaerospace/message_header.hpp"

namespace tedavis::bus {
namespace {

constexpr std::uint16_t kUtc = 1200;
constexpr std::uint16_t kDate = 1206;
constexpr double kMaxLong = 2147483647.0;

std::int16_t full_scale_for(double value) {
    std::int32_t scale = 1;
    while (scale < 32767 && static_cast<double>(scale) < std::fabs(value)) scale *= 2;
    return static_cast<std::int16_t>(scale < 32767 ? scale : 32767);
}

/// An integer of the type's range; `fits` false outside it.
TypedValue integer_value(DataType type, double number, bool& fits) {
    const TypeLayout layout = type_layout(static_cast<std::uint8_t>(type));
    const double span = std::ldexp(1.0, 8 * layout.bytes);
    const double rounded = std::nearbyint(number);
    fits = layout.is_signed ? rounded >= -span / 2 && rounded < span / 2 : rounded >= 0 && rounded < span;
    TypedValue value{type, layout.count, 0, {}};
    if (fits) value.parts[0] = static_cast<std::int64_t>(rounded);
    return value;
}

TypedValue typed(DataType type, double number, bool position, bool& fits) {
    fits = true;
    if (type == DataType::float32) return {type, 1, static_cast<float>(number), {}};
    if (type == DataType::short16x2) return short2_of(number, full_scale_for(number));
    const double scaled = type == DataType::long32 && position ? number / kDegreesPerLongUnit : number;
    if (std::fabs(scaled) > 2 * kMaxLong + 1) fits = false;
    return fits ? integer_value(type, scaled, fits) : TypedValue();
}

}  // namespace

std::size_t MessageEncoder::encode(std::uint16_t identifier, double si, DataType type, base::Time time, base::Span<CanFrame> out,
                                   std::uint8_t channel, std::uint8_t service_code) {
    const std::uint16_t place = place_of(identifier, settings_.guidance);
    if (place == kNotInTable || !std::isfinite(si) || channel >= kMaxRedundancyChannels) return 0;
    const IdentifierEntry& entry = entry_at(place);
    const bool clock = entry.unit == BusUnit::time_of_day || entry.unit == BusUnit::date;
    if (clock || (entry.types & type_bit(type)) == 0 || type == DataType::double_low || type == DataType::nodata) return 0;
    const SignalBinding binding = bind(entry, settings_.dialect);
    if (binding.is_magnetic && !std::isfinite(variation_rad_)) return 0;
    const double number = from_si(binding, binding.is_magnetic ? si - variation_rad_ : si);
    if (type == DataType::double_high) return encode_double(identifier, number, time, out, channel, service_code);
    bool fits = false;
    const TypedValue value = typed(type, number, is_position(entry), fits);
    return fits ? put(identifier, value, time, out, channel, service_code) : 0;
}

std::size_t MessageEncoder::encode_nothing_selected(std::uint16_t identifier, base::Time time, base::Span<CanFrame> out) {
    const std::uint16_t place = place_of(identifier, settings_.guidance);
    if (place == kNotInTable || (entry_at(place).types & type_bit(DataType::nodata)) == 0) return 0;
    return put(identifier, {}, time, out, 0, 0);
}

std::size_t MessageEncoder::encode_double(std::uint16_t identifier, double number, base::Time time, base::Span<CanFrame> out,
                                          std::uint8_t channel, std::uint8_t service_code) {
    if (out.size() < 2) return 0;
    std::uint32_t high = 0;
    std::uint32_t low = 0;
    split_double(number, high, low);
    (void)put(identifier, {DataType::double_high, 1, 0, {high}}, time, out, channel, service_code);
    (void)put(identifier, {DataType::double_low, 1, 0, {low}}, time, out.subspan(1, 1), channel, service_code);
    return 2;
}

std::size_t MessageEncoder::put(std::uint16_t identifier, const TypedValue& value, base::Time time, base::Span<CanFrame> out,
                                std::uint8_t channel, std::uint8_t service_code) {
    if (out.empty()) return 0;
    CanFrame& frame = out[0];
    frame = CanFrame();
    frame.time = time;
    set_message_id(frame, identifier, channel);
    write_header(frame, {node_, static_cast<std::uint8_t>(value.type), service_code, next_code_[identifier][channel]++});
    frame.length = static_cast<std::uint8_t>(kMessageHeaderBytes + encode_value(value, frame.data.data() + kMessageHeaderBytes));
    return 1;
}

std::size_t MessageEncoder::encode_phase(flight::FlightPhase phase, PhaseOrigin origin, std::uint8_t confidence, bool valid,
                                         base::Time time, base::Span<CanFrame> out) {
    const TypedValue value{DataType::uchar8x4, 4, 0, {phase.code(), 0, static_cast<std::int64_t>(origin), confidence}};
    return put(settings_.phase.status_identifier, value, time, out, 0, valid ? 0 : 1);
}

std::size_t MessageEncoder::encode_phase_request(flight::FlightPhase phase, base::Time time, base::Span<CanFrame> out) {
    const TypedValue value{DataType::uchar8x4, 4, 0, {phase.code(), 0, static_cast<std::int64_t>(PhaseOrigin::pilot), 0}};
    return put(settings_.phase.request_identifier, value, time, out, 0, 0);
}

std::size_t MessageEncoder::encode_legend_request(std::optional<flight::LegendShow> show, base::Time time,
                                                  base::Span<CanFrame> out) {
    const std::uint16_t identifier = settings_.display.legend_identifier;
    if (identifier == 0) return 0;
    if (!show) return put(identifier, {}, time, out, 0, 0);
    return put(identifier, {DataType::uchar8, 1, 0, {static_cast<std::int64_t>(*show)}}, time, out, 0, 0);
}

std::size_t MessageEncoder::encode_utc(std::uint8_t hour, std::uint8_t minute, std::uint8_t second, base::Time time,
                                       base::Span<CanFrame> out) {
    if (hour > 23 || minute > 59 || second > 60) return 0;
    return put(kUtc, {DataType::char8x4, 4, 0, {hour, minute, second, 0}}, time, out, 0, 0);
}

std::size_t MessageEncoder::encode_date(std::uint8_t day, std::uint8_t month, std::uint16_t year, base::Time time,
                                        base::Span<CanFrame> out) {
    if (day < 1 || day > 31 || month < 1 || month > 12 || year > 9999) return 0;
    const int sent_month = settings_.dialect.month_from_zero ? month - 1 : month;
    return put(kDate, {DataType::char8x4, 4, 0, {day, sent_month, year / 100, year % 100}}, time, out, 0, 0);
}

}  // namespace tedavis::bus
