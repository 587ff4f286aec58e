#include "bus/state/replay_index.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "bus/canaerospace/message_encoder.hpp"
#include "bus/candump/candump_line.hpp"
#include "tests/bus/text_bytes.hpp"

namespace tedavis::bus {
namespace {

using base::Duration;

base::Time at(double seconds) { return base::Time{1'700'000'000'000'000'000} + Duration::from_seconds(seconds); }

/// Two minutes of flight with jitter, broken lines and out-of-order stamps.
std::string flight_log() {
    std::string text;
    MessageEncoder encoder(BusSettings(), 9);
    std::mt19937 random(2);
    for (int i = 0; i < 12000; ++i) {
        const double t = 0.01 * i;
        CanFrame frames[10];
        std::size_t count = 0;
        const auto put = [&](std::uint16_t identifier, double si, DataType type) {
            const double jitter = static_cast<double>(random() % 5000) * 1e-6;
            count += encoder.encode(identifier, si, type, at(t + jitter), {frames + count, 10 - count});
        };
        put(311, 0.1 * std::sin(t), DataType::float32);
        put(312, 0.3 * std::sin(0.3 * t), DataType::float32);
        if (i % 10 == 0) {
            put(1036, 0.8 + 1e-5 * t, DataType::double_high);
            put(1037, 0.1 + 1e-5 * std::sin(t), DataType::double_high);
            put(1038, 1000 + t, DataType::float32);
        }
        char line[kMaxCandumpLine];
        for (std::size_t k = 0; k < count; ++k)
            text.append(line, format_candump_line(frames[k], "can0", StampDigits::nano, false, line));
        if (i % 500 == 3) text += "(broken line\n";
    }
    return text;
}

StateAssembler run(CandumpLogSource& source, StateAssembler assembler, base::Time until) {
    CanFrame batch[64];
    while (const std::size_t count = source.read(until, batch)) assembler.feed({batch, count});
    return assembler;
}

bool same_bits(const flight::AircraftState& a, const flight::AircraftState& b) {
    bool same = std::memcmp(&a.own_ship.position, &b.own_ship.position, sizeof a.own_ship.position) == 0;
    same = same && std::memcmp(&a.own_ship.velocity_north_mps, &b.own_ship.velocity_north_mps, 3 * sizeof(double)) == 0;
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
        same =
            same && a.signals[i].source_time() == b.signals[i].source_time() && a.signals[i].quality() == b.signals[i].quality();
        same = same && a.signals[i].value_or(0) == b.signals[i].value_or(0);
    }
    return same;
}

TEST(ReplayIndex, SeekingGivesTheBitsOfAWholeRun) {
    const std::string text = flight_log();
    TextBytes bytes(text);
    std::vector<char> window(64 * 1024);
    CandumpLogSource source(bytes, {window.data(), window.size()});
    std::vector<ReplayCheckpoint> checkpoints(6);
    auto index = std::make_unique<ReplayIndex>(source, BusSettings(),
                                               base::Span<ReplayCheckpoint>(checkpoints.data(), checkpoints.size()));
    int turns = 0;
    while (index->extend(5000)) ++turns;
    EXPECT_GT(turns, 3);
    EXPECT_EQ(index->extent().frames, source.statistics().frames);
    EXPECT_NEAR((index->extent().last - index->extent().first).to_seconds(), 120, 0.1);
    for (const double t : {119.0, 0.0, 60.0, 1.234, 60.01, 95.5, 200.0, -1.0}) {
        CandumpLogSource whole(base::Span<const char>(text.data(), text.size()));
        const StateAssembler expected = run(whole, StateAssembler(), at(t));
        const StateAssembler found = run(source, index->seek(at(t)), at(t));
        EXPECT_TRUE(same_bits(expected.snapshot(at(t)).state, found.snapshot(at(t)).state)) << t;
        EXPECT_EQ(source.statistics().frames, whole.statistics().frames) << t;
        EXPECT_EQ(source.statistics().malformed, whole.statistics().malformed) << t;
        EXPECT_EQ(expected.snapshot(at(t)).counters.decoded, found.snapshot(at(t)).counters.decoded) << t;
    }
}

TEST(ReplayIndex, SeekingReadsLittle) {
    const std::string text = flight_log();
    TextBytes bytes(text);
    std::vector<char> window(8 * 1024);
    CandumpLogSource source(bytes, {window.data(), window.size()});
    std::vector<ReplayCheckpoint> checkpoints(8);
    auto index = std::make_unique<ReplayIndex>(source, BusSettings(),
                                               base::Span<ReplayCheckpoint>(checkpoints.data(), checkpoints.size()));
    while (index->extend(100000)) {
    }
    const std::uint64_t before = bytes.bytes_read();
    (void)run(source, index->seek(at(110)), at(110));
    EXPECT_LT((bytes.bytes_read() - before) * 3, text.size());
}

TEST(ReplayIndex, AnEmptyLogHasNoExtent) {
    CandumpLogSource source(base::Span<const char>{});
    std::vector<ReplayCheckpoint> checkpoints(2);
    auto index = std::make_unique<ReplayIndex>(source, BusSettings(),
                                               base::Span<ReplayCheckpoint>(checkpoints.data(), checkpoints.size()));
    EXPECT_FALSE(index->extend(10));
    EXPECT_EQ(index->extent().frames, 0u);
}

}  // namespace
}  // namespace tedavis::bus
