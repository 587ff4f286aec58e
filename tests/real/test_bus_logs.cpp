/// Recorded logs of other buses, and a hand-made CANaerospace log.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::bus::test_bus_logs {
namespace {

std::string read_log(const char* name) {
    std::ifstream file(test_support::real_data_dir() + "/can/" + name, std::ios::binary);
    EXPECT_TRUE(file.is_open()) << name;
    std::ostringstream read;
    read << file.rdbuf();
    return read.str();
}

struct Replayed {
    BusSnapshot snapshot;
    std::uint64_t malformed = 0;
};

Replayed replay(const std::string& text, const BusSettings& settings) {
    Replayed result;
    CandumpLogSource source(base::Span<const char>(text.data(), text.size()));
    auto assembler = std::make_unique<StateAssembler>(settings);
    std::vector<CanFrame> batch(256);
    while (const std::size_t count = source.read({std::numeric_limits<std::int64_t>::max()}, {batch.data(), batch.size()}))
        assembler->feed({batch.data(), count});
    result.malformed = source.statistics().malformed;
    result.snapshot = assembler->snapshot(source.position().newest);
    return result;
}

std::uint64_t lines_of(const std::string& text) { return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n')); }

TEST(BusLogs, CarTrafficChangesNothingButCounters) {
    for (const char* name : {"car_30000_lines.log", "icsim_sample-can.log"}) {
        const std::string text = read_log(name);
        const Replayed run = replay(text, BusSettings());
        EXPECT_EQ(run.malformed, 0u) << name;
        EXPECT_NEAR(static_cast<double>(run.snapshot.counters.frames), static_cast<double>(lines_of(text)), 1.0) << name;
        EXPECT_EQ(run.snapshot.counters.alien, run.snapshot.counters.frames) << name;
        for (const auto& signal : run.snapshot.state.signals) EXPECT_FALSE(signal.received()) << name;
        EXPECT_EQ(run.snapshot.state.own_ship.state, base::SignalState::missing) << name;
        EXPECT_FALSE(run.snapshot.phase_status.phase.received()) << name;
    }
}

/// Every message of this log says "no data" (type 0) and yet carries four bytes: nothing in it may be believed.
TEST(BusLogs, GliderLogSaysNoDataAndIsTakenAtItsWord) {
    BusSettings settings;
    settings.dialect.glider_identifiers = true;
    const Replayed run = replay(read_log("canaerospace_ubx_flaps_canlog.log"), settings);
    EXPECT_EQ(run.malformed, 0u);
    EXPECT_EQ(run.snapshot.counters.frames, 312u);
    EXPECT_EQ(run.snapshot.counters.alien, 312u);
}

/// The same log with the type FLOAT put in: indicated airspeed (315) in its plausible range, flaps known.
TEST(BusLogs, GliderLogWithItsTypeMended) {
    std::string text = read_log("canaerospace_ubx_flaps_canlog.log");
    for (std::size_t place = text.find("13B#0000"); place != std::string::npos; place = text.find("13B#0000", place))
        text[place + 7] = '2';
    const Replayed run = replay(text, BusSettings());
    EXPECT_EQ(run.snapshot.counters.decoded, 288u);
    const base::Stamped<double>& airspeed = run.snapshot.state[flight::Signal::indicated_airspeed];
    ASSERT_TRUE(airspeed.received());
    EXPECT_EQ(airspeed.quality(), base::Quality::degraded) << "the sender does not number its messages";
    EXPECT_GT(airspeed.value_or(0), 5);
    EXPECT_LT(airspeed.value_or(0), 100);
}

}  // namespace
}  // namespace tedavis::bus::test_bus_logs
