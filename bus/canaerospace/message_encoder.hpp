/// Encodes SI values as CANaerospace messages, for converted flights, scenarios and tests.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/canaerospace/identifier_table.hpp"
#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::bus {

/// Who determined a flight phase, as message 1830 says it.
enum class PhaseOrigin : std::uint8_t { unknown, fms, pilot, computed, simulator };
inline constexpr std::uint8_t kConfidenceNotStated = 255;

/// Thread  one. Memory  fixed, inside. Failure  nothing is written and 0 is returned for an identifier that is not in the
/// tables, a type that its table does not allow for it, a value that is not finite, a direction on a bus with magnetic
/// directions before the variation is stated, and a span that is too short.
class MessageEncoder {
public:
    /// `node` is the sender's number, 1..199.
    MessageEncoder(const BusSettings& settings, std::uint8_t node) : settings_(settings), node_(node) {}

    /// Writes one frame, or two (high half first) for DataType::double_high; returns how many. `si` is SI and radians, as
    /// the decoder gives it. SHORT2 chooses the smallest full scale 1, 2, 4, .. 16384, 32767 that holds the value.
    std::size_t encode(std::uint16_t identifier, double si, DataType type, base::Time time, base::Span<CanFrame> out,
                       std::uint8_t channel = 0, std::uint8_t service_code = 0);
    /// Writes that nothing is selected, for an identifier of guidance that may say so.
    std::size_t encode_nothing_selected(std::uint16_t identifier, base::Time time, base::Span<CanFrame> out);
    /// States the magnetic variation, rad, east positive, by which true directions become magnetic ones where the bus file
    /// says so.
    void set_variation(double variation_rad) { variation_rad_ = variation_rad; }
    /// Writes a phase message; `valid` false sends service code 1.
    std::size_t encode_phase(flight::FlightPhase phase, PhaseOrigin origin, std::uint8_t confidence, bool valid, base::Time time,
                             base::Span<CanFrame> out);
    std::size_t encode_phase_request(flight::FlightPhase phase, base::Time time, base::Span<CanFrame> out);
    /// Asks for a legend; `show` is nothing to withdraw the request. Writes nothing where the bus carries no such request.
    std::size_t encode_legend_request(std::optional<flight::LegendShow> show, base::Time time, base::Span<CanFrame> out);
    std::size_t encode_utc(std::uint8_t hour, std::uint8_t minute, std::uint8_t second, base::Time time,
                           base::Span<CanFrame> out);
    /// `month` 1..12.
    std::size_t encode_date(std::uint8_t day, std::uint8_t month, std::uint16_t year, base::Time time, base::Span<CanFrame> out);

private:
    static constexpr std::size_t kIdentifiers = 2048;
    std::size_t put(std::uint16_t identifier, const TypedValue& value, base::Time time, base::Span<CanFrame> out,
                    std::uint8_t channel, std::uint8_t service_code);
    std::size_t encode_double(std::uint16_t identifier, double number, base::Time time, base::Span<CanFrame> out,
                              std::uint8_t channel, std::uint8_t service_code);

    BusSettings settings_;
    std::uint8_t node_;
    double variation_rad_ = std::numeric_limits<double>::quiet_NaN();
    std::array<std::array<std::uint8_t, kMaxRedundancyChannels>, kIdentifiers> next_code_{};
};

}  // namespace tedavis::bus
