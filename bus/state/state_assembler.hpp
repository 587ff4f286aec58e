/// Assembles the aircraft state from the frames of the bus.
///
/// Frames are fed in the order of their source; snapshot(now) changes nothing. Where the source is read up to `now` before each
/// snapshot (CanSource::read), the snapshot at T depends only on the frames up to T, not on earlier snapshots. A copy of the
/// object is a checkpoint.
///
/// Each value has the source time that source_time_fit.hpp reconstructs; without a lock it has its receive stamp and degraded
/// quality. Thread  one. Memory  fixed, inside. Failure  none; foreign and broken traffic is counted.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "bus/canaerospace/message_decoder.hpp"
#include "bus/state/own_ship_filter.hpp"
#include "bus/state/source_time_fit.hpp"
#include "bus/state/traffic_table.hpp"
#include "bus/state/utc_clock.hpp"
#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::bus {

/// A flight phase that the bus states. Its quality is bad while the sender states invalid or the code is impossible.
struct PhaseMessage {
    base::Stamped<flight::FlightPhase> phase;
    base::FreshnessLimits limits;   ///< both equal the bus file's timeout
    std::uint8_t origin = 0;        ///< 0 unknown, 1 FMS, 2 pilot, 3 computed, 4 simulator
    std::uint8_t confidence = 255;  ///< percent, 255 not stated
};

struct BusCounters {
    std::uint64_t frames = 0;
    std::uint64_t decoded = 0;
    std::uint64_t alien = 0;
    std::uint64_t errors = 0;   ///< error frames of the controller
    std::uint64_t dropped = 0;  ///< frames that kernel or recorder lost
    TrafficCounts traffic;
};

struct BusSnapshot {
    flight::AircraftState state;
    PhaseMessage phase_status;                 ///< message 1830
    PhaseMessage phase_request;                ///< message 1831
    std::optional<flight::LegendShow> legend;  ///< the last request; it holds until the next
    BusCounters counters;
    DecoderCounts decoder;
};
static_assert(std::is_trivially_copyable_v<BusSnapshot>);

class StateAssembler {
public:
    explicit StateAssembler(const BusSettings& settings = BusSettings());

    void feed(base::Span<const CanFrame> frames);
    /// Takes over the source's total of lost frames.
    void record_dropped(std::uint64_t total) { dropped_ = total; }
    [[nodiscard]] BusSnapshot snapshot(base::Time now) const;

private:
    static constexpr std::size_t kCandidates = std::size_t{kMaxRanks} * kMaxRedundancyChannels;

    void take(const CanFrame& frame);
    void take_value(const DecodedMessage& message, base::Time received);
    void store(const DecodedMessage& message, base::Time at, base::Quality quality);
    [[nodiscard]] base::Stamped<double> true_direction(double magnetic_rad, base::Time at, base::Quality quality) const;
    [[nodiscard]] base::Stamped<double> best(flight::Signal signal, base::Time now) const;
    void filter(const DecodedMessage& message, base::Time at);
    void filter_signal(const DecodedMessage& message, base::Time at, OwnShipFilter& filter);
    void filter_invalid(const DecodedMessage& message);
    void take_phase(const DecodedMessage& message, base::Time received, PhaseMessage& phase);
    void take_legend(const DecodedMessage& message);
    void take_traffic(const DecodedMessage& message, base::Time received);
    void take_clock(const DecodedMessage& message, base::Time received);
    [[nodiscard]] flight::OwnShipEstimate own_ship(base::Time now) const;

    BusSettings settings_;
    MessageDecoder decoder_;
    std::array<std::array<SourceTimeFit, kMaxRedundancyChannels>, kMaxPlaces> fits_{};
    std::array<std::array<base::Stamped<double>, kCandidates>, flight::kSignalCount> candidates_{};
    std::array<bool, flight::kSignalCount> has_candidates_{};  ///< of most signals no bus ever states a value
    std::array<OwnShipFilter, kMaxRedundancyChannels> filters_;
    PhaseMessage phase_status_;
    PhaseMessage phase_request_;
    std::optional<flight::LegendShow> legend_;
    UtcClock clock_;
    TrafficTable traffic_;
    std::uint64_t frames_ = 0;
    std::uint64_t errors_ = 0;
    std::uint64_t dropped_ = 0;
};
static_assert(std::is_trivially_copyable_v<StateAssembler>);

}  // namespace tedavis::bus
