#include "host_sim/flight_test/sent_message.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "bus/canaerospace/message_encoder.hpp"
#include "bus/state/state_assembler.hpp"
#include "host_sim/flight_test/signal_value.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"

namespace tedavis::host_sim::test_sent_message {
namespace {

bus::BusSettings shipped_bus() {
    const std::string path = resolve_config("canaerospace", "buses");
    return bus::load_bus_settings(read_file(path), path).value();
}

/// The decoder is the oracle: what is sent by the message arrives as that signal, and as no other one.
TEST(SentMessage, EverySignalArrivesAsItself) {
    const bus::BusSettings bus = shipped_bus();
    std::size_t arrived = 0;
    for (const std::string& name : bus_signal_names()) {
        const flight::Signal signal = flight::signal_from_name(name);
        const auto message = sent_message(signal, bus);
        ASSERT_TRUE(message) << name;
        bus::MessageEncoder encoder(bus, 9);
        encoder.set_variation(0);
        bus::CanFrame frames[2];
        const base::Time now{1'000'000'000};
        const double value = signal == flight::Signal::baro_setting          ? 101325
                             : signal == flight::Signal::outside_temperature ? 280
                             : signal == flight::Signal::navigation_source   ? 1
                                                                             : 0.25;
        const std::size_t count = encoder.encode(message->identifier, value, message->type, now, {frames, 2});
        ASSERT_GT(count, 0u) << name;
        const auto assembler = std::make_unique<bus::StateAssembler>(bus);
        assembler->feed({frames, count});
        const bus::BusSnapshot snapshot = assembler->snapshot(now);
        const double read = snapshot.state[signal].value_or(-1e9);
        EXPECT_NEAR(read, value, 1e-3) << name;
        if (read > -1e8) ++arrived;
    }
    EXPECT_EQ(arrived, bus_signal_names().size());
}

TEST(SentMessage, ABusWithoutGuidanceCarriesNone) {
    EXPECT_FALSE(sent_message(flight::Signal::selected_altitude, bus::BusSettings()));
    EXPECT_EQ(sent_message(flight::Signal::selected_altitude, shipped_bus())->identifier, 1833);
}

TEST(SentMessage, ComputedSignalsHaveNone) { EXPECT_FALSE(sent_message(flight::Signal::height_above_terrain, shipped_bus())); }

}  // namespace
}  // namespace tedavis::host_sim::test_sent_message
