#include "bus/state/state_assembler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "bus/canaerospace/message_encoder.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/bus/golden_frames.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::bus::test_state_assembler {
namespace {

using base::Duration;
using base::Quality;
using base::radians;
using base::SignalState;
using flight::Signal;

base::Time at(double seconds) { return base::Time{1'700'000'000'000'000'000} + Duration::from_seconds(seconds); }

struct Bus {
    explicit Bus(const BusSettings& settings = BusSettings()) : encoder(settings, 9), assembler(settings) {}
    void send(std::uint16_t identifier, double si, double seconds, std::uint8_t channel = 0, std::uint8_t service_code = 0,
              DataType type = DataType::float32) {
        CanFrame frames[2];
        const std::size_t count = encoder.encode(identifier, si, type, at(seconds), frames, channel, service_code);
        ASSERT_GE(count, 1u);
        assembler.feed({frames, count});
    }
    [[nodiscard]] SignalState state(Signal signal, double seconds) const {
        return assembler.snapshot(at(seconds)).state.state_of(signal, at(seconds));
    }
    [[nodiscard]] double value(Signal signal, double seconds) const {
        return assembler.snapshot(at(seconds)).state[signal].value_or(NAN);
    }

    MessageEncoder encoder;
    StateAssembler assembler;
};

TEST(StateAssembler, NothingReceivedIsMissing) {
    const BusSnapshot snapshot = StateAssembler().snapshot(at(0));
    for (std::size_t i = 0; i < flight::kSignalCount; ++i)
        EXPECT_EQ(snapshot.state.state_of(static_cast<Signal>(i), at(0)), SignalState::missing);
    EXPECT_EQ(snapshot.state.own_ship.state, SignalState::missing);
    EXPECT_FALSE(snapshot.phase_status.phase.received());
}

TEST(StateAssembler, ValuesAgeByTheirOwnLimits) {
    Bus bus;
    bus.send(311, 0.1, 0);
    bus.send(320, 1000, 0);
    EXPECT_EQ(bus.state(Signal::pitch, 0.29), SignalState::valid);
    EXPECT_EQ(bus.state(Signal::pitch, 0.31), SignalState::stale);
    EXPECT_EQ(bus.state(Signal::pitch, 1.01), SignalState::lost);
    EXPECT_EQ(bus.state(Signal::baro_altitude, 0.9), SignalState::valid);
    EXPECT_EQ(bus.state(Signal::baro_altitude, 2.9), SignalState::stale);
    EXPECT_EQ(bus.state(Signal::baro_altitude, 3.1), SignalState::lost);
    EXPECT_NEAR(bus.value(Signal::baro_altitude, 3.1), 1000, 1e-3);
}

TEST(StateAssembler, QualityIsDegradedUntilSourceTimeLocks) {
    Bus bus;
    for (int i = 0; i < 20; ++i) {
        bus.send(311, 0.1, 0.0125 * i);
        const Quality quality = bus.assembler.snapshot(at(0.0125 * i)).state[Signal::pitch].quality();
        EXPECT_EQ(quality, i + 1 >= SourceTimeFit::kMessagesToLock ? Quality::good : Quality::degraded) << i;
    }
}

TEST(StateAssembler, SourceTimesAreBetterThanReceiveStamps) {
    Bus bus;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> delay(0, 0.010);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        bus.send(311, 0.1, 0.02 * i + delay(random));
        if (i > 300) {
            const double stamp =
                (bus.assembler.snapshot(at(0.02 * i)).state[Signal::pitch].source_time() - at(0.02 * i + 0.005)).to_seconds();
            worst = std::max(worst, std::fabs(stamp));
        }
    }
    EXPECT_LT(worst, 0.001) << "receive stamps are off by up to 0.005";
}

TEST(StateAssembler, InvalidIsSaidAndTheLastGoodNumberKept) {
    Bus bus;
    bus.send(311, 0.1, 0);
    bus.send(311, 0.2, 0.01, 0, 1);
    EXPECT_EQ(bus.state(Signal::pitch, 0.02), SignalState::invalid);
    EXPECT_NEAR(bus.value(Signal::pitch, 0.02), 0.1, 1e-6);
    bus.send(311, 0.3, 0.02);
    EXPECT_EQ(bus.state(Signal::pitch, 0.02), SignalState::valid);
}

TEST(StateAssembler, RedundancyChannelsAreVotedByHealthAndFreshness) {
    Bus bus;
    const auto both = [&](double seconds, double first, double second, std::uint8_t first_service) {
        bus.send(312, first, seconds, 0, first_service);
        bus.send(312, second, seconds, 1);
    };
    for (int i = 0; i < 20; ++i) both(0.0125 * i, 0.1, 0.2, 0);
    EXPECT_NEAR(bus.value(Signal::roll, 0.24), 0.1, 1e-6);
    both(0.25, 0.1, 0.2, 1);
    EXPECT_NEAR(bus.value(Signal::roll, 0.25), 0.2, 1e-6) << "channel 0 says invalid";
    EXPECT_EQ(bus.state(Signal::roll, 0.25), SignalState::valid);
    both(0.2625, 0.1, 0.2, 0);
    EXPECT_NEAR(bus.value(Signal::roll, 0.27), 0.1, 1e-6);
    for (int i = 22; i < 80; ++i) bus.send(312, 0.2, 0.0125 * i, 1);
    EXPECT_NEAR(bus.value(Signal::roll, 0.99), 0.2, 1e-6) << "channel 0 fell silent";
}

TEST(StateAssembler, PreferredIdentifiersComeFirst) {
    Bus bus;
    for (int i = 0; i < 20; ++i) {
        bus.send(321, radians(100), 0.02 * i);
        bus.send(1133, radians(101), 0.02 * i);
    }
    EXPECT_NEAR(bus.value(Signal::true_heading, 0.39), radians(101), 1e-6);
    for (int i = 20; i < 60; ++i) bus.send(321, radians(100), 0.02 * i);
    EXPECT_NEAR(bus.value(Signal::true_heading, 1.19), radians(100), 1e-6);
}

TEST(StateAssembler, PhaseMessagesWithTheirTimeout) {
    Bus bus;
    CanFrame frame[1];
    ASSERT_EQ(bus.encoder.encode_phase(flight::kApproachFinal, PhaseOrigin::fms, 80, true, at(0), frame), 1u);
    bus.assembler.feed({frame, 1});
    BusSnapshot snapshot = bus.assembler.snapshot(at(1));
    EXPECT_EQ(snapshot.phase_status.phase.value_or({}), flight::kApproachFinal);
    EXPECT_EQ(snapshot.phase_status.phase.state(at(3.0), snapshot.phase_status.limits), SignalState::valid);
    EXPECT_EQ(snapshot.phase_status.phase.state(at(3.1), snapshot.phase_status.limits), SignalState::lost);
    EXPECT_EQ(snapshot.phase_status.confidence, 80);
    ASSERT_EQ(bus.encoder.encode_phase(flight::kTakeoffStart, PhaseOrigin::fms, 80, false, at(1), frame), 1u);
    bus.assembler.feed({frame, 1});
    snapshot = bus.assembler.snapshot(at(1));
    EXPECT_EQ(snapshot.phase_status.phase.state(at(1), snapshot.phase_status.limits), SignalState::invalid);
    ASSERT_EQ(bus.encoder.encode_phase_request(flight::kGoAroundAbort, at(1), frame), 1u);
    bus.assembler.feed({frame, 1});
    snapshot = bus.assembler.snapshot(at(1));
    EXPECT_EQ(snapshot.phase_request.phase.value_or({}), flight::kGoAroundAbort);
}

TEST(StateAssembler, ALegendRequestHoldsUntilTheNext) {
    BusSettings settings;
    settings.display.legend_identifier = 1852;
    Bus bus(settings);
    const auto send = [&](std::optional<flight::LegendShow> show, double seconds, bool is_valid = true) {
        CanFrame frame;
        ASSERT_EQ(bus.encoder.encode_legend_request(show, at(seconds), {&frame, 1}), 1u);
        if (!is_valid) frame.data[2] = 1;
        bus.assembler.feed({&frame, 1});
    };
    EXPECT_FALSE(bus.assembler.snapshot(at(0)).legend);
    send(flight::LegendShow::whole, 0);
    EXPECT_EQ(bus.assembler.snapshot(at(0)).legend, flight::LegendShow::whole);
    EXPECT_EQ(bus.assembler.snapshot(at(3600)).legend, flight::LegendShow::whole) << "it does not grow stale";
    send(flight::LegendShow::none, 1, false);
    EXPECT_EQ(bus.assembler.snapshot(at(1)).legend, flight::LegendShow::whole) << "the sender says that it is invalid";
    send(flight::LegendShow::none, 2);
    EXPECT_EQ(bus.assembler.snapshot(at(2)).legend, flight::LegendShow::none);
    send({}, 3);
    EXPECT_FALSE(bus.assembler.snapshot(at(3)).legend) << "withdrawn";
}

TEST(StateAssembler, CountersAndClock) {
    Bus bus;
    const CanFrame frames[] = {frame_of("137#0102002A40A00000"), frame_of("7FF#00"), frame_of("20000040#0000000000000000"),
                               frame_of("4B0#090F00060D2B1600"), frame_of("4B6#090F00070C061357")};
    bus.assembler.feed({frames, 5});
    bus.assembler.record_dropped(12);
    const BusSnapshot snapshot = bus.assembler.snapshot({});
    EXPECT_EQ(snapshot.counters.frames, 5u);
    EXPECT_EQ(snapshot.counters.decoded, 3u);
    EXPECT_EQ(snapshot.counters.alien, 1u);
    EXPECT_EQ(snapshot.counters.errors, 1u);
    EXPECT_EQ(snapshot.counters.dropped, 12u);
    EXPECT_EQ(snapshot.state.utc.state, SignalState::missing) << "1987 is no date of a flight";
}

/// The board's clock counts from its start, 1000 s before; UTC comes by the bus.
TEST(StateAssembler, UtcComesFromTheBusAndIsLostWithIt) {
    Bus bus;
    const auto on_board = [](double seconds) { return base::Time{} + Duration::from_seconds(1000 + seconds); };
    const auto send = [&](std::uint8_t second, double seconds, bool healthy = true) {
        CanFrame frames[2];
        ASSERT_EQ(bus.encoder.encode_utc(13, 5, second, on_board(seconds), {frames, 1}), 1u);
        ASSERT_EQ(bus.encoder.encode_date(1, 6, 2026, on_board(seconds), {frames + 1, 1}), 1u);
        if (!healthy) frames[0].data[2] = frames[1].data[2] = 1;
        bus.assembler.feed({frames, 2});
    };
    const auto time_at = [&](double seconds) {
        return flight::flight_time(bus.assembler.snapshot(on_board(seconds)).state.utc, on_board(seconds));
    };
    send(9, -1, false);
    EXPECT_FALSE(time_at(0).is_date) << "the sender says that it does not know";
    send(10, 0);
    const base::Time sent{1'780'319'110'000'000'000};  // 2026-06-01T13:05:10Z by date(1)
    EXPECT_EQ((time_at(0).utc - sent).ns, UtcClock::kTransport.ns);
    EXPECT_TRUE(time_at(9).is_date && time_at(9).is_confirmed);
    EXPECT_EQ((time_at(9).utc - time_at(0).utc).ns, Duration::seconds(9).ns);
    EXPECT_TRUE(time_at(10.1).is_date);
    EXPECT_FALSE(time_at(10.1).is_confirmed) << "not heard for longer than the bus file allows";
    send(25, 15);
    EXPECT_TRUE(time_at(15).is_confirmed);
}

TEST(StateAssembler, WhatIsNoLongerSelectedIsAbsentAndSilenceIsLost) {
    BusSettings settings;
    settings.guidance.first_identifier = 1832;
    Bus bus(settings);
    bus.send(1833, 1500, 0);
    EXPECT_EQ(bus.state(Signal::selected_altitude, 1), SignalState::valid);
    EXPECT_EQ(bus.state(Signal::selected_altitude, 3.1), SignalState::stale);
    EXPECT_EQ(bus.state(Signal::selected_altitude, 10.1), SignalState::lost);
    CanFrame frame;
    ASSERT_EQ(bus.encoder.encode_nothing_selected(1833, at(1), {&frame, 1}), 1u);
    bus.assembler.feed({&frame, 1});
    EXPECT_EQ(bus.state(Signal::selected_altitude, 1), SignalState::missing);
    EXPECT_EQ(bus.state(Signal::selected_altitude, 100), SignalState::missing);
    bus.send(1833, 1600, 2);
    EXPECT_NEAR(bus.value(Signal::selected_altitude, 2), 1600, 1e-3);
    bus.send(1833, 1700, 2.1, 1);
    ASSERT_EQ(bus.encoder.encode_nothing_selected(1833, at(3), {&frame, 1}), 1u);
    bus.assembler.feed({&frame, 1});
    EXPECT_EQ(bus.state(Signal::selected_altitude, 20), SignalState::missing) << "and not the lost value of the other channel";
}

TEST(StateAssembler, MagneticDirectionsBecomeTrueByTheVariationOfTheirTime) {
    BusSettings settings;
    settings.dialect.directions = HeadingReference::magnetic;
    Bus bus(settings);
    bus.encoder.set_variation(radians(-5.5));
    bus.send(1125, radians(240), 0);
    EXPECT_EQ(bus.state(Signal::selected_course, 0), SignalState::invalid) << "the display does not know the variation";
    bus.send(1121, radians(-5.5), 1);
    bus.send(1125, radians(240), 1);
    EXPECT_EQ(bus.state(Signal::selected_course, 1), SignalState::valid);
    EXPECT_NEAR(bus.value(Signal::selected_course, 1), radians(240), 1e-6);
    bus.send(1125, radians(2), 700);
    EXPECT_EQ(bus.state(Signal::selected_course, 700), SignalState::invalid) << "the variation is lost";
}

TEST(StateAssembler, ForeignTrafficLeavesTheStateAlone) {
    std::mt19937_64 random(3);
    StateAssembler assembler;
    std::vector<CanFrame> frames(50000);
    for (CanFrame& frame : frames) {
        frame.id = static_cast<std::uint32_t>(random() % 2048);
        if (identifier_index(static_cast<std::uint16_t>(frame.id)) != kNotInTable || frame.id == 1830 || frame.id == 1831)
            frame.id = 310;
        frame.length = static_cast<std::uint8_t>(random() % 9);
        for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random());
    }
    assembler.feed({frames.data(), frames.size()});
    const flight::AircraftState state = assembler.snapshot({}).state;
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) EXPECT_FALSE(state.signals[i].received());
    EXPECT_EQ(assembler.snapshot({}).counters.frames, 50000u);
}

/// An aircraft in a standard-rate turn (3 deg/s at 128.6 m/s); the truth in closed form in a tangent plane.
struct Turn {
    static constexpr double kSpeed = 128.6;
    static constexpr double kRate = radians(3.0);
    static constexpr double kLatitude = radians(46.8);
    static constexpr double kLongitude = radians(9.8);
    [[nodiscard]] static double north(double t) { return kSpeed / kRate * std::sin(kRate * t); }
    [[nodiscard]] static double east(double t) { return kSpeed / kRate * (1 - std::cos(kRate * t)); }
    [[nodiscard]] static earth::Geodetic position(double t) {
        const earth::Ecef origin = earth::to_ecef({kLatitude, kLongitude, {1500}});
        const glm::dmat3 axes = earth::north_east_down(kLatitude, kLongitude);
        earth::Geodetic place = earth::from_ecef(origin + axes * glm::dvec3(north(t), east(t), 0));
        place.height.m = 1500;
        return place;
    }
    /// From the north of the place itself, which the meridians' convergence turns against that of the origin.
    [[nodiscard]] static double track(double t) {
        const earth::Geodetic place = position(t);
        const glm::dvec3 velocity(std::cos(kRate * t), std::sin(kRate * t), 0);
        const glm::dmat3 here = earth::north_east_down(place.latitude_rad, place.longitude_rad);
        const glm::dvec3 local = glm::transpose(here) * (earth::north_east_down(kLatitude, kLongitude) * velocity);
        return std::atan2(local.y, local.x);
    }
};

struct TurnErrors {
    double filtered_rms;
    double received_rms;  ///< last fix carried on with its velocity from its receive stamp
    double worst, received_worst;
};

/// 20 Hz fixes with message delays of 0..10 ms (the mean, 5 ms, is no jitter and is taken out of the truth), 2 % lost;
/// judged at 60 Hz.
TurnErrors fly_turn(double noise_m) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> delay(0, 0.010);
    std::uniform_real_distribution<double> chance(0, 1);
    std::normal_distribution<double> noise(0, 1);
    BusSettings settings;
    settings.own_ship.position_noise_m = std::fmax(noise_m, 0.05);
    MessageEncoder encoder(settings, 9);
    std::vector<CanFrame> frames;
    struct Fix {
        double received;
        double north, east, track;
    };
    std::vector<Fix> fixes;
    for (int i = 0; i < 60 * 20; ++i) {
        const double t = 0.05 * i;
        const earth::Geodetic place = Turn::position(t);
        const double north_error = noise_m * noise(random);
        const double east_error = noise_m * noise(random);
        const double lat = place.latitude_rad + north_error / earth::meridian_radius_m(place.latitude_rad);
        const double lon = place.longitude_rad + east_error / (earth::prime_vertical_radius_m(lat) * std::cos(lat));
        const double received = t + delay(random);
        const bool lost = chance(random) < 0.02;
        CanFrame out[9];
        std::size_t count = 0;
        const auto put = [&](std::uint16_t identifier, double si, DataType type) {
            count += encoder.encode(identifier, si, type, at(received + 0.00013 * static_cast<double>(count)),
                                    {out + count, 9 - count});
        };
        put(1036, lat, DataType::double_high);
        put(1037, lon, DataType::double_high);
        put(1038, 1500, DataType::float32);
        put(1039, Turn::kSpeed, DataType::float32);
        put(1040, Turn::track(t), DataType::float32);
        if (lost) continue;
        frames.insert(frames.end(), out, out + count);
        fixes.push_back({received, Turn::north(t) + north_error, Turn::east(t) + east_error, Turn::kRate * t});
    }
    StateAssembler assembler(settings);
    const glm::dmat3 axes = earth::north_east_down(Turn::kLatitude, Turn::kLongitude);
    const earth::Ecef origin = earth::to_ecef({Turn::kLatitude, Turn::kLongitude, {1500}});
    std::size_t fed = 0;
    std::size_t fix = 0;
    double squares = 0, received_squares = 0, worst = 0, received_worst = 0;
    int count = 0;
    for (double now = 0; now < 59.9; now += 1.0 / 60) {
        for (; fed < frames.size() && frames[fed].time <= at(now); ++fed) assembler.feed({&frames[fed], 1});
        while (fix + 1 < fixes.size() && fixes[fix + 1].received <= now) ++fix;
        if (now < 20) continue;
        const flight::OwnShipEstimate own = assembler.snapshot(at(now)).state.own_ship;
        EXPECT_EQ(own.state, SignalState::valid);
        earth::Geodetic place = own.position;
        place.height.m = 1500;
        const double sent = now - 0.005;
        const glm::dvec3 truth(Turn::north(sent), Turn::east(sent), 0);
        const glm::dvec3 offset = glm::transpose(axes) * (earth::to_ecef(place) - origin) - truth;
        const double error = std::hypot(offset.x, offset.y);
        const double ahead = now - fixes[fix].received;
        const double simple = std::hypot(fixes[fix].north + Turn::kSpeed * std::cos(fixes[fix].track) * ahead - truth.x,
                                         fixes[fix].east + Turn::kSpeed * std::sin(fixes[fix].track) * ahead - truth.y);
        squares += error * error;
        received_squares += simple * simple;
        worst = std::fmax(worst, error);
        received_worst = std::fmax(received_worst, simple);
        ++count;
    }
    return {std::sqrt(squares / count), std::sqrt(received_squares / count), worst, received_worst};
}

TEST(StateAssembler, OwnShipInATurnBeatsReceiveStampsByFar) {
    const TurnErrors clean = fly_turn(0);
    EXPECT_LT(clean.filtered_rms * 8, clean.received_rms) << clean.filtered_rms << " m against " << clean.received_rms << " m";
    EXPECT_LT(clean.worst, 0.2);
    EXPECT_GT(clean.received_worst, 0.2) << "control";
    test_support::record_worst("A16", clean.worst);
    test_support::record_control("A16", clean.received_worst);
    const TurnErrors noisy = fly_turn(1);
    EXPECT_LT(noisy.filtered_rms * 6, noisy.received_rms) << noisy.filtered_rms << " m against " << noisy.received_rms << " m";
    EXPECT_LT(noisy.worst, 0.6);
}

TEST(StateAssembler, SnapshotsChangeNothing) {
    Bus often;
    Bus once;
    for (int i = 0; i < 300; ++i) {
        for (Bus* bus : {&often, &once}) {
            bus->send(1036, 0.8 + 1e-6 * i, 0.1 * i, 0, 0, DataType::double_high);
            bus->send(1037, 0.1, 0.1 * i, 0, 0, DataType::double_high);
            bus->send(1038, 1000, 0.1 * i);
        }
        for (int k = 0; k < 7; ++k) (void)often.assembler.snapshot(at(0.1 * i + 0.01 * k));
    }
    const BusSnapshot a = often.assembler.snapshot(at(29.95));
    const BusSnapshot b = once.assembler.snapshot(at(29.95));
    EXPECT_EQ(a.state.own_ship.position.latitude_rad, b.state.own_ship.position.latitude_rad);
    EXPECT_EQ(a.state.own_ship.position.longitude_rad, b.state.own_ship.position.longitude_rad);
    EXPECT_EQ(a.state.own_ship.position.height.m, b.state.own_ship.position.height.m);
    EXPECT_EQ(a.state.own_ship.at, b.state.own_ship.at);
    EXPECT_EQ(a.counters.decoded, b.counters.decoded);
}

TEST(StateAssembler, TheSecondGpsTakesOver) {
    Bus bus;
    const auto fix = [&](double seconds, std::uint8_t channel) {
        bus.send(1036, 0.8 + 0.001 * channel, seconds, channel, 0, DataType::double_high);
        bus.send(1037, 0.1, seconds, channel, 0, DataType::double_high);
        bus.send(1038, 1000, seconds, channel);
    };
    for (int i = 0; i < 20; ++i) {
        fix(0.1 * i, 0);
        fix(0.1 * i, 1);
    }
    EXPECT_NEAR(bus.assembler.snapshot(at(1.95)).state.own_ship.position.latitude_rad, 0.8, 1e-9);
    for (int i = 20; i < 30; ++i) fix(0.1 * i, 1);
    EXPECT_NEAR(bus.assembler.snapshot(at(2.95)).state.own_ship.position.latitude_rad, 0.801, 1e-9);
    EXPECT_EQ(bus.assembler.snapshot(at(2.95)).state.own_ship.state, SignalState::valid);
}

TEST(StateAssembler, FitsItsMemory) { EXPECT_LE(sizeof(StateAssembler), 128u * 1024u); }

}  // namespace
}  // namespace tedavis::bus::test_state_assembler
