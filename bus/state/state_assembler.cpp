#include "bus/state/state_assembler.hpp"

#include "bus/canaerospace/redundancy_vote.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::bus {
namespace {

using flight::Signal;

constexpr std::uint16_t kTrueEastVelocity = 1130;
constexpr std::uint16_t kTrueNorthVelocity = 1131;

/// Which of two estimates serves better: usable states first, then geometric heights.
int demerits(const flight::OwnShipEstimate& estimate) {
    constexpr int kRank[] = {8, 0, 2, 6, 4};  // missing, valid, stale, lost, invalid
    return kRank[static_cast<std::size_t>(estimate.state)] + (estimate.height_is_geometric ? 0 : 1);
}

}  // namespace

StateAssembler::StateAssembler(const BusSettings& settings)
    : settings_(settings), decoder_(settings), clock_(settings.utc_timeout), traffic_(settings) {
    for (OwnShipFilter& filter : filters_) filter = OwnShipFilter(settings.own_ship);
    phase_status_.limits = {settings.phase.timeout, settings.phase.timeout};
    phase_request_.limits = phase_status_.limits;
}

void StateAssembler::feed(base::Span<const CanFrame> frames) {
    for (const CanFrame& frame : frames) take(frame);
}

void StateAssembler::take(const CanFrame& frame) {
    ++frames_;
    if (frame.kind == FrameKind::error) {
        ++errors_;
        return;
    }
    const DecodedMessage message = decoder_.decode(frame);
    switch (message.kind) {
        case MessageKind::signal:
        case MessageKind::known: take_value(message, frame.time); break;
        case MessageKind::phase: take_phase(message, frame.time, phase_status_); break;
        case MessageKind::phase_request: take_phase(message, frame.time, phase_request_); break;
        case MessageKind::legend_request: take_legend(message); break;
        case MessageKind::utc:
        case MessageKind::date: take_clock(message, frame.time); break;
        case MessageKind::traffic: take_traffic(message, frame.time); break;
        case MessageKind::alien:
        case MessageKind::repeated:
        case MessageKind::half:
        case MessageKind::identification_request: break;
    }
}

void StateAssembler::take_value(const DecodedMessage& message, base::Time received) {
    SourceTimeFit& fit = fits_[message.place][message.channel];
    if (message.restarted) fit.reset();
    const SourceTime source = message.numbered ? fit.add(message.header.message_code, received) : SourceTime{received, false};
    if (message.kind == MessageKind::signal) {
        const base::Quality healthy = source.locked ? base::Quality::good : base::Quality::degraded;
        store(message, source.time, message.healthy ? healthy : base::Quality::bad);
    }
    filter(message, source.time);
}

/// An unhealthy value keeps the last good number beside its bad quality: no reader may show it, none may stumble over it.
void StateAssembler::store(const DecodedMessage& message, base::Time at, base::Quality quality) {
    const std::size_t place = std::size_t{message.rank} * kMaxRedundancyChannels + message.channel;
    has_candidates_[static_cast<std::size_t>(message.signal)] = true;
    base::Stamped<double>& candidate = candidates_[static_cast<std::size_t>(message.signal)][place];
    if (message.healthy && message.nothing_selected) {
        // Of all channels: what another one stated last is no longer selected either.
        auto& all = candidates_[static_cast<std::size_t>(message.signal)];
        for (std::size_t n = 0; n < kMaxRedundancyChannels; ++n) all[place - message.channel + n] = {};
    } else if (message.healthy && message.is_magnetic) {
        candidate = true_direction(message.value, at, quality);
    } else {
        candidate = {message.healthy ? message.value : candidate.value_or(0), at, quality};
    }
}

/// A magnetic direction without a variation that is known at the time states nothing.
base::Stamped<double> StateAssembler::true_direction(double magnetic_rad, base::Time at, base::Quality quality) const {
    const base::Stamped<double> variation = best(Signal::magnetic_variation, at);
    const base::SignalState state = variation.state(at, settings_.limits[static_cast<std::size_t>(Signal::magnetic_variation)]);
    const bool known = state == base::SignalState::valid || state == base::SignalState::stale;
    return {earth::wrap_heading(magnetic_rad + variation.value_or(0)), at, known ? quality : base::Quality::bad};
}

/// What the channels and identifiers that state a signal have agreed on.
base::Stamped<double> StateAssembler::best(Signal signal, base::Time now) const {
    const auto& candidates = candidates_[static_cast<std::size_t>(signal)];
    if (!has_candidates_[static_cast<std::size_t>(signal)]) return {};
    const base::Span<const base::Stamped<double>> all(candidates.data(), candidates.size());
    return candidates[vote(all, now, settings_.limits[static_cast<std::size_t>(signal)])];
}

void StateAssembler::filter(const DecodedMessage& message, base::Time at) {
    OwnShipFilter& own = filters_[message.channel];
    if (!message.healthy) {
        filter_invalid(message);
    } else if (message.kind == MessageKind::signal) {
        filter_signal(message, at, own);
    } else if (message.identifier == kTrueNorthVelocity) {
        own.add_north_velocity(message.value, at);
    } else if (message.identifier == kTrueEastVelocity) {
        own.add_east_velocity(message.value, at);
    }
}

void StateAssembler::filter_signal(const DecodedMessage& message, base::Time at, OwnShipFilter& own) {
    switch (message.signal) {
        case Signal::latitude: own.add_latitude(message.value, at); break;
        case Signal::longitude: own.add_longitude(message.value, at); break;
        case Signal::ellipsoid_height: own.add_height(HeightSource::ellipsoid, message.value, at); break;
        case Signal::baro_altitude: own.add_height(HeightSource::baro, message.value, at); break;
        case Signal::standard_altitude: own.add_height(HeightSource::standard, message.value, at); break;
        case Signal::ground_speed:
            if (message.rank == 0) own.add_ground_speed(message.value, at);
            break;
        case Signal::true_track:
            if (message.rank == 0) own.add_true_track(message.value, at);
            break;
        case Signal::vertical_speed: own.add_up_velocity(message.value, at); break;
        case Signal::horizontal_accuracy: own.set_horizontal_accuracy(message.value); break;
        case Signal::vertical_accuracy: own.set_vertical_accuracy(message.value); break;
        default: break;
    }
}

void StateAssembler::filter_invalid(const DecodedMessage& message) {
    OwnShipFilter& own = filters_[message.channel];
    switch (message.signal) {
        case Signal::latitude:
        case Signal::longitude: own.set_position_invalid(); break;
        case Signal::ellipsoid_height: own.set_height_invalid(HeightSource::ellipsoid); break;
        case Signal::baro_altitude: own.set_height_invalid(HeightSource::baro); break;
        case Signal::standard_altitude: own.set_height_invalid(HeightSource::standard); break;
        default: break;
    }
}

void StateAssembler::take_phase(const DecodedMessage& message, base::Time received, PhaseMessage& phase) {
    const flight::FlightPhase value = message.healthy ? message.phase : phase.phase.value_or({});
    phase.phase = {value, received, message.healthy ? base::Quality::good : base::Quality::bad};
    phase.origin = message.phase_origin;
    phase.confidence = message.confidence;
}

/// A request that is not valid leaves the one before.
void StateAssembler::take_legend(const DecodedMessage& message) {
    if (!message.healthy) return;
    legend_.reset();
    if (!message.nothing_selected) legend_ = message.legend;
}

void StateAssembler::take_traffic(const DecodedMessage& message, base::Time received) {
    const flight::OwnShipEstimate own = traffic_.has_room(received) ? flight::OwnShipEstimate() : own_ship(received);
    traffic_.take(message, message.traffic_part, received, own);
}

void StateAssembler::take_clock(const DecodedMessage& message, base::Time received) {
    if (!message.healthy) return;
    const auto& part = message.clock;
    if (message.kind == MessageKind::utc)
        clock_.take_time({part[0], part[1], part[2]}, received);
    else
        clock_.take_date(100 * part[2] + part[3], part[1], part[0], received);
}

flight::OwnShipEstimate StateAssembler::own_ship(base::Time now) const {
    flight::OwnShipEstimate best = filters_[0].estimate(now);
    for (std::size_t i = 1; i < settings_.dialect.redundancy_channels; ++i) {
        const flight::OwnShipEstimate other = filters_[i].estimate(now);
        if (demerits(other) < demerits(best)) best = other;
    }
    return best;
}

BusSnapshot StateAssembler::snapshot(base::Time now) const {
    BusSnapshot result;
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
        result.state.signals[i] = best(static_cast<Signal>(i), now);
        result.state.limits[i] = settings_.limits[i];
    }
    result.state.own_ship = own_ship(now);
    result.state.utc = clock_.estimate(now);
    result.state.traffic = traffic_.estimate(now);
    result.phase_status = phase_status_;
    result.phase_request = phase_request_;
    result.legend = legend_;
    result.decoder = decoder_.counts();
    result.counters = {frames_, result.decoder.decoded, result.decoder.alien, errors_, dropped_, traffic_.counts()};
    return result;
}

}  // namespace tedavis::bus
